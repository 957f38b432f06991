#include "scene/sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/geometry.h"
#include "scene/point_grid.h"

namespace weir {

namespace {

std::int64_t cells(double length, double dx) { return std::max<std::int64_t>(1, std::llround(length / dx)); }

// Calls visit for each centre of an n.x by n.y by n.z lattice from `min`, x fastest.
template <class Visit>
void for_lattice(const Vec3& min, const glm::i64vec3& n, double dx, Visit visit) {
  for (std::int64_t z = 0; z < n.z; ++z) {
    for (std::int64_t y = 0; y < n.y; ++y) {
      for (std::int64_t x = 0; x < n.x; ++x) {
        visit(min + dx * (Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)) + 0.5));
      }
    }
  }
}

// Centres in the plane z = 0 of a 2D scene.
Vec3 flattened(Vec3 point, int dimension) {
  if (dimension == 2) point.z = 0;
  return point;
}

std::vector<Vec3> sample_shape(const Box& box, int dimension, double dx) {
  glm::i64vec3 n(1);
  for (int axis = 0; axis < dimension; ++axis) n[axis] = cells(box.max[axis] - box.min[axis], dx);
  std::vector<Vec3> points;
  points.reserve(static_cast<std::size_t>(n.x * n.y * n.z));
  for_lattice(box.min, n, dx, [&](const Vec3& point) { points.push_back(flattened(point, dimension)); });
  return points;
}

// Lattice offsets about a ball's centre, in half spacings: all odd (a cell corner in the middle) or all even (a cell).
std::vector<glm::i64vec3> ball_offsets(double radius, int dimension, double dx, int parity) {
  const double limit = 4 * (radius / dx) * (radius / dx);
  const auto reach = static_cast<std::int64_t>(2 * radius / dx) + 2;
  const std::int64_t first = -(reach + ((reach + parity) % 2));
  const std::int64_t last_z = dimension == 3 ? -first : 0;
  std::vector<glm::i64vec3> offsets;
  for (std::int64_t z = dimension == 3 ? first : 0; z <= last_z; z += 2) {
    for (std::int64_t y = first; y <= -first; y += 2) {
      for (std::int64_t x = first; x <= -first; x += 2) {
        if (static_cast<double>(x * x + y * y + z * z) < limit) offsets.emplace_back(x, y, z);
      }
    }
  }
  return offsets;
}

std::vector<Vec3> sample_shape(const Ball& ball, int dimension, double dx) {
  // Both lattices are symmetric about the centre; the one whose mass is nearer to the ball's is taken.
  const double wanted = measure(Shape(ball), dimension) / std::pow(dx, dimension);
  std::vector<glm::i64vec3> offsets = ball_offsets(ball.radius, dimension, dx, 1);
  std::vector<glm::i64vec3> even = ball_offsets(ball.radius, dimension, dx, 0);
  const auto error = [&](const std::vector<glm::i64vec3>& some) {
    return std::abs(static_cast<double>(some.size()) - wanted);
  };
  if (error(even) < error(offsets)) offsets = std::move(even);
  std::vector<Vec3> points;
  points.reserve(offsets.size());
  for (const glm::i64vec3& offset : offsets) points.push_back(ball.center + 0.5 * dx * Vec3(offset));
  return points;
}

// Row by row between the outline's crossings (even-odd), so that slivers cost their rows and not their bounding box.
std::vector<Vec3> sample_shape(const Polygon& polygon, int dimension, double dx) {
  const Bounds box = shape_bounds(Shape(polygon), dimension);
  const auto rows = static_cast<std::int64_t>((box.max.y - box.min.y) / dx) + 1;
  std::vector<Vec3> points;
  std::vector<double> crossings;
  for (std::int64_t row = 0; row < rows; ++row) {
    const double y = box.min.y + dx * (static_cast<double>(row) + 0.5);
    crossings.clear();
    for (std::size_t i = 0; i < polygon.points.size(); ++i) {
      const Vec3& a = polygon.points[i];
      const Vec3& b = polygon.points[(i + 1) % polygon.points.size()];
      if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      auto column = static_cast<std::int64_t>(std::ceil((crossings[k] - box.min.x) / dx - 0.5));
      for (;; ++column) {
        const double x = box.min.x + dx * (static_cast<double>(column) + 0.5);
        if (x >= crossings[k + 1]) break;
        points.emplace_back(x, y, 0);
      }
    }
  }
  return points;
}

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
  return std::visit([&](const auto& each) { return sample_shape(each, dimension, dx); }, shape);
}

Sampling sample(const Scene& scene) {
  Sampling sampling;
  const double dx = scene.particle_spacing;
  for (const Volume& volume : scene.fluid.volumes) {
    const Vec3 center = turning_center(volume.shape, scene.dimension, dx);
    for (const Vec3& point : sample_volume(volume.shape, scene.dimension, dx)) {
      sampling.fluid_positions.push_back(point);
      sampling.fluid_velocities.push_back(volume.velocity + glm::cross(volume.angular_velocity, point - center));
    }
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
