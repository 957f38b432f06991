// How many particles a scene will have, before any is made, and what they cost.
#pragma once

#include "scene/scene.h"

namespace weir {

// Bytes for each particle while a run lasts, a little more than it will be: what the solver keeps of it, its lists of
// pairs, and its part of the frames on their way to the pictures.
double bytes_per_particle(const Scene& scene);
double bytes_per_wall_particle(const Scene& scene);

// From areas and volumes alone; infinite or not a number for absurd sizes.
double expected_particles(const Scene& scene, const Volume& volume);
double expected_particles(const Scene& scene, const Wall& wall);  // holes and open sides are not taken off

// What this machine can give to a process without swapping, bytes; infinity if it does not say.
double available_memory();

}  // namespace weir
