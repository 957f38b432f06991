#include "scene/geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weir {

namespace {

double cross(const Vec3& a, const Vec3& b) { return a.x * b.y - a.y * b.x; }

Bounds around(const std::vector<Vec3>& points) {
  Bounds result{points.empty() ? Vec3(0) : points.front(), points.empty() ? Vec3(0) : points.front()};
  for (const Vec3& point : points) {
    result.min = glm::min(result.min, point);
    result.max = glm::max(result.max, point);
  }
  return result;
}

bool inside_of(const Box& box, const Vec3& point, int dimension) {
  for (int axis = 0; axis < dimension; ++axis) {
    if (point[axis] < box.min[axis] || point[axis] > box.max[axis]) return false;
  }
  return true;
}
bool inside_of(const Ball& ball, const Vec3& point, int) {
  return glm::dot(point - ball.center, point - ball.center) <= ball.radius * ball.radius;
}
bool inside_of(const Polygon& polygon, const Vec3& point, int) { return inside_polygon(polygon.points, point); }

Vec3 center_of(const Box& box) { return 0.5 * (box.min + box.max); }
Vec3 center_of(const Ball& ball) { return ball.center; }
Vec3 center_of(const Polygon& polygon) { return centroid(polygon.points); }

double measure_of(const Box& box, int dimension) {
  double product = 1;
  for (int axis = 0; axis < dimension; ++axis) product *= box.max[axis] - box.min[axis];
  return product;
}
double measure_of(const Ball& ball, int dimension) {
  const double disc = std::numbers::pi * ball.radius * ball.radius;
  return dimension == 2 ? disc : 4.0 / 3.0 * disc * ball.radius;
}
double measure_of(const Polygon& polygon, int) { return std::abs(signed_area(polygon.points)); }

Bounds bounds_of(const Box& box, int) { return {box.min, box.max}; }
Bounds bounds_of(const Ball& ball, int dimension) {
  const Vec3 reach(ball.radius, ball.radius, dimension == 3 ? ball.radius : 0);
  return {ball.center - reach, ball.center + reach};
}
Bounds bounds_of(const Polygon& polygon, int) { return around(polygon.points); }

}  // namespace

bool inside_polygon(const std::vector<Vec3>& polygon, const Vec3& point) {
  bool odd = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec3& a = polygon[i];
    const Vec3& b = polygon[j];
    if ((a.y > point.y) != (b.y > point.y) && point.x < a.x + (b.x - a.x) * ((point.y - a.y) / (b.y - a.y))) odd = !odd;
  }
  return odd;
}

void crossings(const std::vector<Vec3>& polygon, double y, std::vector<double>& result) {
  result.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3& a = polygon[i];
    const Vec3& b = polygon[(i + 1) % polygon.size()];
    if ((a.y > y) != (b.y > y)) result.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
  }
  std::sort(result.begin(), result.end());
}

double signed_area(const std::vector<Vec3>& polygon) {
  if (polygon.empty()) return 0;
  double twice = 0;  // about the first corner: a polygon far from the origin loses no digits
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return 0.5 * twice;
}

Vec3 centroid(const std::vector<Vec3>& polygon) {
  Vec3 sum(0);
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec3 a = polygon[i] - polygon[0];
    const Vec3 b = polygon[i + 1] - polygon[0];
    sum += cross(a, b) * (a + b) / 3.0;
    twice += cross(a, b);
  }
  return twice == 0 ? polygon.at(0) : polygon[0] + sum / twice;
}

double distance_to_segment(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 == 0 ? 0 : std::clamp(glm::dot(point - a, along) / length2, 0.0, 1.0);
  return glm::length(point - (a + t * along));
}

bool segments_cross(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const auto side = [](const Vec3& from, const Vec3& to, const Vec3& point) {
    const double value = cross(to - from, point - from);
    return value > 0 ? 1 : value < 0 ? -1 : 0;
  };
  const auto within = [](const Vec3& from, const Vec3& to, const Vec3& point) {
    return std::min(from.x, to.x) <= point.x && point.x <= std::max(from.x, to.x) &&
           std::min(from.y, to.y) <= point.y && point.y <= std::max(from.y, to.y);
  };
  const int c_side = side(a, b, c);
  const int d_side = side(a, b, d);
  const int a_side = side(c, d, a);
  const int b_side = side(c, d, b);
  if (c_side != d_side && a_side != b_side && c_side * d_side <= 0 && a_side * b_side <= 0) return true;
  return (c_side == 0 && within(a, b, c)) || (d_side == 0 && within(a, b, d)) || (a_side == 0 && within(c, d, a)) ||
         (b_side == 0 && within(c, d, b));
}

Polyline outline_of(const PolygonWall& polygon) {
  const bool counterclockwise = signed_area(polygon.points) > 0;  // then the inside is on the left
  return {polygon.points, true, counterclockwise == (polygon.solid == Face::inside) ? Flank::left : Flank::right};
}

bool inside(const Shape& shape, const Vec3& point, int dimension) {
  return std::visit([&](const auto& each) { return inside_of(each, point, dimension); }, shape);
}
Vec3 shape_center(const Shape& shape) {
  return std::visit([](const auto& each) { return center_of(each); }, shape);
}
double measure(const Shape& shape, int dimension) {
  return std::visit([&](const auto& each) { return measure_of(each, dimension); }, shape);
}
Bounds shape_bounds(const Shape& shape, int dimension) {
  return std::visit([&](const auto& each) { return bounds_of(each, dimension); }, shape);
}

bool apart(const Bounds& a, const Bounds& b, int dimension, double gap) {
  for (int axis = 0; axis < dimension; ++axis) {
    if (a.max[axis] <= b.min[axis] + gap || b.max[axis] <= a.min[axis] + gap) return true;
  }
  return false;
}

bool contains(const Bounds& box, const Vec3& point) {
  return glm::all(glm::lessThanEqual(box.min, point)) && glm::all(glm::lessThanEqual(point, box.max));
}

Bounds grown(const Bounds& box, double margin) { return {box.min - margin, box.max + margin}; }

Bounds around(const Bounds& a, const Bounds& b) { return {glm::min(a.min, b.min), glm::max(a.max, b.max)}; }

}  // namespace weir
