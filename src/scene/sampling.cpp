#include "scene/sampling.h"

#include <algorithm>
#include <cmath>

#include "scene/geometry.h"
#include "scene/lattice.h"
#include "scene/point_grid.h"

namespace weir {

namespace {

std::int64_t cells(double length, double dx) { return std::max<std::int64_t>(1, std::llround(length / dx)); }

// Where the sampled volume turns about: a box's particles may reach a little further than the box, or less far.
Vec3 turning_center(const Shape& shape, int dimension, double dx) {
  const auto* box = std::get_if<Box>(&shape);
  if (box == nullptr) return shape_center(shape);
  Vec3 center = box->min;
  for (int axis = 0; axis < dimension; ++axis) {
    center[axis] += 0.5 * dx * static_cast<double>(cells(box->max[axis] - box->min[axis], dx));
  }
  return center;
}

}  // namespace

std::vector<Vec3> sample_volume(const Shape& shape, int dimension, double dx) {
  const Lattice lattice(shape, dimension, dx);
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(lattice.count()));
  lattice.for_each([&](const Vec3& point) { points.push_back(point); });
  return points;
}

Sampling sample(const Scene& scene) {
  Sampling sampling;
  const double dx = scene.particle_spacing;
  std::int64_t count = 0;
  for (const Volume& volume : scene.fluid.volumes) count += Lattice(volume.shape, scene.dimension, dx).count();
  sampling.fluid_positions.reserve(static_cast<std::size_t>(count));
  sampling.fluid_velocities.reserve(static_cast<std::size_t>(count));
  for (const Volume& volume : scene.fluid.volumes) {
    const Vec3 center = turning_center(volume.shape, scene.dimension, dx);
    Lattice(volume.shape, scene.dimension, dx).for_each([&](const Vec3& point) {
      sampling.fluid_positions.push_back(point);
      sampling.fluid_velocities.push_back(volume.velocity + glm::cross(volume.angular_velocity, point - center));
    });
    sampling.volume_ends.push_back(static_cast<std::int32_t>(sampling.fluid_positions.size()));
  }
  PointGrid kept(wall_merge_distance * dx);
  for (const Wall& wall : scene.walls) {
    for (const Vec3& point : sample_wall(wall, scene.dimension, dx, wall_layers(scene, wall))) {
      if (kept.any_near(point, wall_merge_distance * dx)) continue;
      kept.add(point, 0);
      sampling.wall_positions.push_back(point);
    }
  }
  return sampling;
}

Bounds bounds(const std::vector<Vec3>& points) {
  if (points.empty()) return {};
  Bounds result{points.front(), points.front()};
  for (const Vec3& point : points) {
    result.min = glm::min(result.min, point);
    result.max = glm::max(result.max, point);
  }
  return result;
}

}  // namespace weir
