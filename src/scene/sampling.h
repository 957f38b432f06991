// Volumes and walls -> particles on a lattice of the scene's spacing.
#pragma once

#include <functional>
#include <vector>

#include "scene/scene.h"

namespace weir {

// In the order of the scene's volumes and walls; that order gives the particle ids.
struct Sampling {
  std::vector<Vec3> fluid_positions;      // m; the first lies dx/2 inside the faces
  std::vector<Vec3> fluid_velocities;     // m/s, same length
  std::vector<std::int32_t> volume_ends;  // of each volume, one more than its last particle's id
  std::vector<Vec3> wall_positions;  // m; the first layer lies dx/2 behind the faces, nearest first does not matter
  std::vector<Vec3> wall_slides;     // m/s, same length; none where no wall slides
};
Sampling sample(const Scene& scene);

std::vector<Vec3> sample_volume(const Shape& shape, int dimension, double dx);
// One wall alone, holes left out of it, before walls are merged.
std::vector<Vec3> sample_wall(const Wall& wall, int dimension, double dx, int layers);
// The same without keeping them: calls visit for each that lies in `region`, in the same order.
using VisitPoint = std::function<void(const Vec3&)>;
void visit_wall(const Wall& wall, int dimension, double dx, int layers, const Bounds& region, const VisitPoint& visit);
std::int64_t count_wall(const Wall& wall, int dimension, double dx, int layers);

// How many particles sample() makes, without making them.
struct ParticleCount {
  std::int64_t fluid = 0;
  std::int64_t wall = 0;
};
ParticleCount count_particles(const Scene& scene);

// Where walls meet, a particle nearer than this part of dx to one already there is left out. It must stay below 0.75,
// the least spacing within one wall (a face of 1.5 dx has two particles); the larger it is, the wider the gap, up to
// 1 + this, where two walls meet off each other's lattice; the smaller, the denser the walls lie there, and dense walls
// push too hard.
inline constexpr double wall_merge_distance = 0.7;

// Smallest box around all that is given.
Bounds bounds(const std::vector<Vec3>& points);

}  // namespace weir
