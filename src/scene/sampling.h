// Volumes and walls -> particles on a lattice of the scene's spacing.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace weir {

// In the order of the scene's volumes and walls; that order gives the particle ids.
struct Sampling {
  std::vector<Vec3> fluid_positions;      // m; the first lies dx/2 inside the faces
  std::vector<Vec3> fluid_velocities;     // m/s, same length
  std::vector<double> fluid_pressures;    // Pa at the start, same length, or none where no volume has any
  std::vector<std::int32_t> volume_ends;  // of each volume, one more than its last particle's id
  std::vector<Vec3> wall_positions;   // m; the first layer lies dx/2 behind the faces, nearest first does not matter
  std::vector<double> wall_depths;    // m, behind the face; same length, or none where no viscosity asks for them
  std::vector<Vec3> wall_velocities;  // m/s, with which the surface slides; same length, or none where no wall does
};
Sampling sample(const Scene& scene);

// Numbers of particles; fluid is counted without sampling it.
std::int64_t count_fluid(const Scene& scene);
std::int64_t count_walls(const Scene& scene);

std::vector<Vec3> sample_volume(const Shape& shape, int dimension, double dx);
// One wall alone, holes left out of it, before walls are merged.
std::vector<Vec3> sample_wall(const Wall& wall, int dimension, double dx, int layers);

// Where walls meet, a particle nearer than this part of dx to one already there is left out. It must stay below 0.75,
// the least spacing within one wall (a face of 1.5 dx has two particles); the larger it is, the wider the gap, up to
// 1 + this, where two walls meet off each other's lattice; the smaller, the denser the walls lie there, and dense walls
// push too hard.
inline constexpr double wall_merge_distance = 0.7;

// Smallest box around all that is given.
Bounds bounds(const std::vector<Vec3>& points);

}  // namespace weir
