#include <algorithm>

#include "scene/geometry.h"
#include "scene/lattice.h"
#include "scene/point_grid.h"
#include "scene/sampling.h"
#include "scene/wall_extent.h"

namespace weir {

namespace {

// Walls take each other's particles only where they come near each other, so that only there particles are looked at.
std::int64_t count_merged_walls(const Scene& scene) {
  const int dimension = scene.dimension;
  const double dx = scene.particle_spacing;
  std::vector<Bounds> boxes;
  for (const Wall& wall : scene.walls) boxes.push_back(wall_bounds(wall, dimension, dx, wall_layers(scene, wall)));

  PointGrid kept(wall_merge_distance * dx);
  std::int64_t sum = 0;
  std::vector<std::size_t> others;  // that come near
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    const Wall& wall = scene.walls[i];
    const int layers = wall_layers(scene, wall);
    sum += count_wall(wall, dimension, dx, layers);
    others.clear();
    Bounds region = empty_bounds;
    for (std::size_t other = 0; other < boxes.size(); ++other) {
      if (other == i || apart(boxes[i], boxes[other], dimension, -dx)) continue;
      others.push_back(other);
      region = around(region, grown(boxes[other], dx));
    }
    if (others.empty()) continue;
    const auto shared_with = [&](std::size_t other, const Vec3& point) {
      return contains(grown(boxes[other], dx), point) && !surely_clear(scene.walls[other], point, dimension, dx);
    };
    visit_wall(wall, dimension, dx, layers, region, [&](const Vec3& point) {
      if (std::none_of(others.begin(), others.end(), [&](std::size_t other) { return shared_with(other, point); })) {
        return;
      }
      if (kept.any_near(point, wall_merge_distance * dx)) {
        --sum;
      } else {
        kept.add(point, 0);
      }
    });
  }
  return sum;
}

}  // namespace

ParticleCount count_particles(const Scene& scene) {
  ParticleCount count;
  if (!scene.periodic.empty()) {  // which of the walls' particles are left out
    const Sampling sampling = sample(scene);
    return {static_cast<std::int64_t>(sampling.fluid_positions.size()),
            static_cast<std::int64_t>(sampling.wall_positions.size())};
  }
  for (const Volume& volume : scene.fluid.volumes) {
    count.fluid += Lattice(volume.shape, scene.dimension, scene.particle_spacing).count();
  }
  count.wall = count_merged_walls(scene);
  return count;
}

}  // namespace weir
