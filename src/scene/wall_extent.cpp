#include "scene/wall_extent.h"

#include <algorithm>
#include <cmath>

#include "scene/geometry.h"
#include "scene/sampling.h"

namespace weir {

namespace {

constexpr double behind = 0.005;  // dx; the face may lie half a hundredth of dx before the particle

Bounds extent(const Tank& tank, int dimension, double dx, int layers) {
  Vec3 thick(layers * dx);
  if (dimension == 2) thick.z = 0;
  return {tank.min - thick, tank.max + thick};
}

// The outermost particles of a block lie half a spacing inside its faces, less where it is stretched to less.
Bounds extent(const Block& block, int dimension, double dx, int) {
  Bounds result{block.min, block.max};
  for (int axis = 0; axis < dimension; ++axis) {
    const double size = block.max[axis] - block.min[axis];
    const double inset = 0.499 * std::min(dx, size / std::max(1.0, std::round(size / dx)));
    result.min[axis] += inset;
    result.max[axis] -= inset;
  }
  return result;
}

// A mitre turns by at most a right angle, so that no corner of a layer is farther from the line than sqrt(2) its depth.
Bounds extent(const Polyline& line, int dimension, double dx, int layers) {
  Vec3 thick(1.5 * layers * dx);
  if (dimension == 2) thick.z = 0;
  const Bounds box = shape_bounds(Polygon{line.points}, dimension);
  return {box.min - thick, box.max + thick};
}

Bounds extent(const Round& round, int dimension, double dx, int layers) {
  const double thick = round.solid == Face::outside ? layers * dx : 0;
  return shape_bounds(Ball{round.center, round.radius + thick}, dimension);
}

// Along the axes, how far from `place` the nearest and the farthest point of a box lies.
Vec3 nearest(const Bounds& box, const Vec3& place) {
  return glm::max(Vec3(0), glm::max(box.min - place, place - box.max));
}
Vec3 farthest(const Bounds& box, const Vec3& place) { return glm::max(place - box.min, box.max - place); }

bool in_front(const Tank& tank, const Shape&, const Bounds& bounds, int dimension, double slack) {
  for (int axis = 0; axis < dimension; ++axis) {
    if (bounds.min[axis] < tank.min[axis] - slack || bounds.max[axis] > tank.max[axis] + slack) return false;
  }
  return true;
}
bool in_front(const Round& round, const Shape& volume, const Bounds& bounds, int, double slack) {
  const auto* ball = std::get_if<Ball>(&volume);
  const double between = ball != nullptr ? glm::length(ball->center - round.center) : 0;
  if (round.solid == Face::outside) {
    const double far = ball != nullptr ? between + ball->radius : glm::length(farthest(bounds, round.center));
    return far <= round.radius + slack;
  }
  const double near = ball != nullptr ? between - ball->radius : glm::length(nearest(bounds, round.center));
  return near >= round.radius - slack;
}
template <class Other>
bool in_front(const Other&, const Shape&, const Bounds&, int, double) {
  return false;
}

}  // namespace

Bounds wall_bounds(const Wall& wall, int dimension, double dx, int layers) {
  return std::visit([&](const auto& each) { return extent(each, dimension, dx, layers); }, wall.shape);
}

bool surely_in_front(const Wall& wall, const Shape& volume, const Bounds& bounds, int dimension, double dx) {
  return std::visit([&](const auto& each) { return in_front(each, volume, bounds, dimension, behind * dx); },
                    wall.shape);
}

bool surely_clear(const Wall& wall, const Vec3& place, int dimension, double dx) {
  const auto* tank = std::get_if<Tank>(&wall.shape);
  if (tank == nullptr) return false;
  const double deep = (wall_merge_distance - 0.5 + 0.01) * dx;  // before the faces, whose first layer lies dx/2 behind
  return inside(Box{tank->min + deep, tank->max - deep}, place, dimension);
}

}  // namespace weir
