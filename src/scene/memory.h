// Expected number of particles of a scene, before sampling, and their memory.
#pragma once

#include "scene/scene.h"

namespace weir {

// Upper estimate of bytes per particle during a run: state of the solver, lists of pairs, buffered frames.
double bytes_per_particle(const Scene& scene);
double bytes_per_wall_particle(const Scene& scene);

// From areas and volumes alone; infinite or NaN for absurd sizes.
double expected_particles(const Scene& scene, const Volume& volume);
double expected_particles(const Scene& scene, const Wall& wall);  // holes and open sides are not taken off

// Memory available to a process without swapping, bytes; infinity if unknown.
double available_memory();

}  // namespace weir
