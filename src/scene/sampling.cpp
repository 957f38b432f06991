#include "scene/sampling.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "equations/hydrostatics.h"
#include "equations/initial_flow.h"
#include "scene/cells.h"
#include "scene/geometry.h"
#include "scene/lattice.h"
#include "scene/point_grid.h"
#include "scene/wall_depth.h"

namespace weir {

namespace {

// Centre of rotation of the sampled volume: the particles of a box may reach a little further than the box, or less far.
Vec3 turning_center(const Shape& shape, int dimension, double dx) {
  const auto* box = std::get_if<Box>(&shape);
  if (box == nullptr) return shape_center(shape);
  Vec3 center = box->min;
  for (int axis = 0; axis < dimension; ++axis) {
    center[axis] += 0.5 * dx * static_cast<double>(cells(box->max[axis] - box->min[axis], dx));
  }
  return center;
}

// Uniform random moves of up to `length` along each axis. They are made of the generator's own bits, which the C++
// standard fixes: the same on every machine.
class Perturbation {
 public:
  Perturbation(std::uint32_t seed, double length, int dimension)
      : random_(seed), length_(length), dimension_(dimension) {}
  Vec3 next() {
    Vec3 move(0);
    if (length_ == 0) return move;
    for (int axis = 0; axis < dimension_; ++axis) {
      const double unit = (static_cast<double>(random_()) + 0.5) / 2147483648.0 - 1;  // -1 .. 1
      move[axis] = length_ * unit;
    }
    return move;
  }

 private:
  std::mt19937 random_;
  double length_;
  int dimension_;
};

// The domain along periodic axes. A position is within [min, max); rounding, of either end, must neither lose a particle
// nor count its image.
class Period {
 public:
  explicit Period(const Scene& scene)
      : extent_(periodic_extent(scene)), slack_(1e-6 * scene.particle_spacing), dimension_(scene.dimension) {
    for (int axis = 0; axis < 3; ++axis) periodic_[static_cast<std::size_t>(axis)] = is_periodic(scene, axis);
  }
  bool holds(const Vec3& point) const {
    for (int axis = 0; axis < dimension_; ++axis) {
      if (!periodic_[static_cast<std::size_t>(axis)]) continue;
      if (point[axis] < extent_.min[axis] - slack_ || point[axis] >= extent_.max[axis] - slack_) return false;
    }
    return true;
  }
  Vec3 wrapped(Vec3 point) const {
    for (int axis = 0; axis < dimension_; ++axis) {
      if (!periodic_[static_cast<std::size_t>(axis)]) continue;
      const double length = extent_.max[axis] - extent_.min[axis];
      if (point[axis] < extent_.min[axis]) point[axis] += length;
      if (point[axis] >= extent_.max[axis]) point[axis] = std::max(extent_.min[axis], point[axis] - length);
    }
    return point;
  }

 private:
  Bounds extent_;
  double slack_;
  int dimension_;
  std::array<bool, 3> periodic_{};
};

Vec3 initial_velocity(const Volume& volume, const Vec3& point, const Vec3& center) {
  Vec3 velocity = volume.velocity + glm::cross(volume.angular_velocity, point - center);
  if (const auto& flow = volume.flow.taylor_green) {
    velocity += taylor_green_velocity(flow->speed, flow->wave_length, point - flow->phase_origin);
  }
  return velocity;
}

// The column at rest that a volume may start as: pressures by depth below the uppermost corner of its box, and heights above
// the lowest one that go with these, so that densities are those of the volumes that particles have.
class Column {
 public:
  Column(const Scene& scene, const Volume& volume)
      : g_(volume.pressure == StartPressure::none ? 0 : glm::length(scene.gravity)),
        rest_density_(scene.fluid.rest_density) {
    if (g_ == 0) return;
    down_ = scene.gravity / g_;
    const double c0 = sound_speed(scene);
    g_per_c_squared_ = g_ / (c0 * c0);
    const Bounds box = shape_bounds(volume.shape, scene.dimension);
    for (int axis = 0; axis < scene.dimension; ++axis) {
      top_[axis] = down_[axis] > 0 ? box.min[axis] : box.max[axis];
      height_ += std::abs(down_[axis]) * (box.max[axis] - box.min[axis]);
    }
  }
  double pressure(const Vec3& point) const { return hydrostatic_pressure(rest_density_, g_, depth(point)); }
  Vec3 settled(const Vec3& point) const {
    if (g_ == 0) return point;
    const double d = depth(point);
    return point + ((height_ - d) - settled_height(height_, d, g_per_c_squared_)) * down_;
  }

 private:
  double depth(const Vec3& point) const {
    return g_ == 0 ? 0 : std::clamp(glm::dot(down_, point - top_), 0.0, height_);
  }

  double g_;  // m/s^2; 0: no column
  double rest_density_;
  double g_per_c_squared_ = 0;  // 1/m
  Vec3 down_{0};
  Vec3 top_{0};
  double height_ = 0;  // m
};

void sample_walls(const Scene& scene, Sampling& sampling) {
  const double dx = scene.particle_spacing;
  const Period period(scene);
  PointGrid earlier(wall_merge_distance * dx);  // walls; within one wall, particles keep that distance by themselves
  std::vector<Vec3>& points = sampling.wall_positions;
  const bool slides =
      std::any_of(scene.walls.begin(), scene.walls.end(), [](const Wall& wall) { return wall.slide != Vec3(0); });
  for (const Wall& wall : scene.walls) {
    const std::size_t first = points.size();
    for (const Vec3& point : sample_wall(wall, scene.dimension, dx, wall_layers(scene, wall))) {
      if (period.holds(point) && !earlier.any_near(point, wall_merge_distance * dx)) points.push_back(point);
    }
    if (holds_fluid(scene)) {
      for (std::size_t i = first; i < points.size(); ++i) {
        sampling.wall_depths.push_back(wall_depth(wall.shape, scene.dimension, points[i]));
      }
    }
    if (slides) sampling.wall_velocities.resize(points.size(), wall.slide);
    if (&wall == &scene.walls.back()) break;
    for (std::size_t i = first; i < points.size(); ++i) earlier.add(points[i], 0);
  }
}

}  // namespace

std::vector<Vec3> sample_volume(const Shape& shape, int dimension, double dx) {
  const Lattice lattice(shape, dimension, dx);
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(lattice.count()));
  lattice.for_each([&](const Vec3& point) { points.push_back(point); });
  return points;
}

std::int64_t count_fluid(const Scene& scene) {
  std::int64_t count = 0;
  for (const Volume& volume : scene.fluid.volumes) {
    count += Lattice(volume.shape, scene.dimension, scene.particle_spacing).count();
  }
  return count;
}

std::int64_t count_walls(const Scene& scene) {
  Sampling sampling;
  sample_walls(scene, sampling);
  return static_cast<std::int64_t>(sampling.wall_positions.size());
}

Sampling sample(const Scene& scene) {
  Sampling sampling;
  const double dx = scene.particle_spacing;
  const auto count = static_cast<std::size_t>(count_fluid(scene));
  sampling.fluid_positions.reserve(count);
  sampling.fluid_velocities.reserve(count);
  const Period period(scene);
  const bool pressed = std::any_of(scene.fluid.volumes.begin(), scene.fluid.volumes.end(),
                                   [](const Volume& volume) { return volume.pressure != StartPressure::none; });
  for (std::size_t i = 0; i < scene.fluid.volumes.size(); ++i) {
    const Volume& volume = scene.fluid.volumes[i];
    const Vec3 center = turning_center(volume.shape, scene.dimension, dx);
    const Column column(scene, volume);
    Perturbation perturbation(static_cast<std::uint32_t>(i), volume.perturbation * dx, scene.dimension);
    Lattice(volume.shape, scene.dimension, dx).for_each([&](const Vec3& node) {
      const Vec3 point = column.settled(node) + perturbation.next();
      sampling.fluid_positions.push_back(period.wrapped(point));
      sampling.fluid_velocities.push_back(initial_velocity(volume, point, center));
      if (pressed) sampling.fluid_pressures.push_back(column.pressure(node));
    });
    sampling.volume_ends.push_back(static_cast<std::int32_t>(sampling.fluid_positions.size()));
  }
  sample_walls(scene, sampling);
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
