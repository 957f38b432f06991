#include "scene/wall_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/tank_sides.h"

namespace weir {

namespace {

// From the box of the inside, beyond the sides that are there.
double depth(const Tank& tank, int dimension, const Vec3& point) {
  Vec3 beyond(0);
  for (int axis = 0; axis < dimension; ++axis) {
    const auto [low, high] = tank_sides(axis, dimension);
    if (!is_open(tank, low)) beyond[axis] = std::max(beyond[axis], tank.min[axis] - point[axis]);
    if (!is_open(tank, high)) beyond[axis] = std::max(beyond[axis], point[axis] - tank.max[axis]);
  }
  return glm::length(beyond);
}

double depth(const Block& block, int dimension, const Vec3& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < dimension; ++axis) {
    nearest = std::min({nearest, point[axis] - block.min[axis], block.max[axis] - point[axis]});
  }
  return std::max(nearest, 0.0);
}

double distance_to_line(const std::vector<Vec3>& points, bool closed, const Vec3& point) {
  double nearest = std::numeric_limits<double>::infinity();
  const std::size_t n = points.size();
  for (std::size_t k = 0; k + (closed ? 0 : 1) < n; ++k) {
    const Vec3& from = points[k];
    const Vec3 along = points[(k + 1) % n] - from;
    const double length_squared = glm::dot(along, along);
    const double share = length_squared > 0 ? std::clamp(glm::dot(point - from, along) / length_squared, 0.0, 1.0) : 0;
    nearest = std::min(nearest, glm::length(point - from - share * along));
  }
  return nearest;
}

double depth(const Polyline& line, int /*dimension*/, const Vec3& point) {
  return distance_to_line(line.points, line.closed, point);
}

double depth(const PolygonWall& polygon, int /*dimension*/, const Vec3& point) {
  return distance_to_line(polygon.points, true, point);
}

double depth(const Round& round, int /*dimension*/, const Vec3& point) {
  return std::abs(glm::length(point - round.center) - round.radius);
}

}  // namespace

double wall_depth(const WallShape& shape, int dimension, const Vec3& point) {
  return std::visit([&](const auto& each) { return depth(each, dimension, point); }, shape);
}

}  // namespace weir
