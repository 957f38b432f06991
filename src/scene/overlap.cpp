#include "scene/overlap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/geometry.h"

namespace weir {

namespace {

// Whether points lie inside a shape. A polygon's crossings with a row are computed once for all points of the row.
class Inside {
 public:
  Inside(const Shape& shape, int dimension) : shape_(&shape), dimension_(dimension) {}

  bool operator()(const Vec3& point) {
    const auto* polygon = std::get_if<Polygon>(shape_);
    if (polygon == nullptr) return inside(*shape_, point, dimension_);
    if (point.y != row_) {
      row_ = point.y;
      crossings(polygon->points, row_, crossed_);
    }
    const auto to_the_right = crossed_.end() - std::upper_bound(crossed_.begin(), crossed_.end(), point.x);
    return to_the_right % 2 == 1;
  }

 private:
  const Shape* shape_;
  int dimension_;
  double row_ = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> crossed_;
};

class InsideAny {
 public:
  InsideAny(const std::vector<Shape>& shapes, int dimension) {
    for (const Shape& shape : shapes) all_.emplace_back(shape, dimension);
  }
  bool operator()(const Vec3& point) {
    return std::any_of(all_.begin(), all_.end(), [&](Inside& each) { return each(point); });
  }

 private:
  std::vector<Inside> all_;
};

glm::i64vec3 nearest_node(const Lattice& lattice, const Vec3& point) {
  glm::i64vec3 node(0);
  for (int axis = 0; axis < lattice.dimension(); ++axis) node[axis] = std::llround(lattice.node_at(axis, point[axis]));
  return node;
}

bool nearer(const Vec3& a, const Vec3& b, double distance) { return glm::dot(a - b, a - b) < distance * distance; }

// Caches the runs of the last row.
class RowMemory {
 public:
  explicit RowMemory(const Lattice& lattice) : lattice_(lattice) {}
  const std::vector<Run>& runs(std::int64_t y, std::int64_t z) {
    if (y == y_ && z == z_) return runs_;
    y_ = y;
    z_ = z;
    runs_.clear();
    const glm::i64vec3& size = lattice_.size();
    if (y >= 0 && y < size.y && z >= 0 && z < size.z) lattice_.runs(y, z, runs_);
    return runs_;
  }

 private:
  const Lattice& lattice_;
  std::int64_t y_ = -1;
  std::int64_t z_ = -1;
  std::vector<Run> runs_;
};

}  // namespace

bool any_inside(const Lattice& lattice, const Shape& shape, const std::vector<Shape>& holes) {
  const Bounds box = shape_bounds(shape, lattice.dimension());
  if (apart(box, lattice.bounds(), lattice.dimension(), -1e-6 * lattice.dx())) return false;
  Inside in_shape(shape, lattice.dimension());
  InsideAny in_hole(holes, lattice.dimension());
  return lattice.any_point(box, [&](const Vec3& point) { return in_shape(point) && !in_hole(point); });
}

Outsiders outside_all(const Lattice& lattice, const std::vector<Shape>& shapes) {
  Outsiders result;
  const Bounds& box = lattice.bounds();
  for (const Shape& shape : shapes) {
    if (std::holds_alternative<Box>(shape) && inside(shape, box.min, lattice.dimension()) &&
        inside(shape, box.max, lattice.dimension())) {
      return result;
    }
  }
  InsideAny in_any(shapes, lattice.dimension());
  lattice.for_each([&](const Vec3& point) {
    if (in_any(point)) return;
    if (result.count++ == 0) result.first = point;
  });
  return result;
}

bool any_near(const Lattice& a, const Lattice& b, double distance) {
  if (apart(a.bounds(), b.bounds(), a.dimension(), -distance)) return false;
  // Both lattices have one spacing, so that every node of a is equally far from the nearest of b; to rounding.
  const Vec3 origin = a.point(glm::i64vec3(0));
  const glm::i64vec3 beside = nearest_node(b, origin);
  if (!nearer(origin, b.point(beside), distance + 1e-5 * a.dx())) return false;
  RowMemory memory(b);
  return a.any_row(grown(b.bounds(), distance), [&](std::int64_t y, std::int64_t z, const std::vector<Run>& runs) {
    const std::vector<Run>& others = memory.runs(y + beside.y, z + beside.z);
    for (const Run& run : runs) {
      for (const Run& other : others) {
        const std::int64_t end = std::min(run.end, other.end - beside.x);
        for (std::int64_t x = std::max(run.begin, other.begin - beside.x); x < end; ++x) {
          const glm::i64vec3 node(x, y, z);
          if (nearer(a.point(node), b.point(node + beside), distance)) return true;
        }
      }
    }
    return false;
  });
}

bool any_near(const Lattice& lattice, const std::vector<Vec3>& points, double distance) {
  const Bounds reach = grown(lattice.bounds(), distance);
  RowMemory memory(lattice);
  const auto first = std::lower_bound(points.begin(), points.end(), reach.min.y,
                                      [](const Vec3& point, double y) { return point.y < y; });
  for (auto point = first; point != points.end() && point->y <= reach.max.y; ++point) {
    if (!contains(reach, *point)) continue;
    const glm::i64vec3 node = nearest_node(lattice, *point);
    if (!nearer(*point, lattice.point(node), distance)) continue;
    const std::vector<Run>& runs = memory.runs(node.y, node.z);
    if (std::any_of(runs.begin(), runs.end(),
                    [&](const Run& run) { return run.begin <= node.x && node.x < run.end; })) {
      return true;
    }
  }
  return false;
}

}  // namespace weir
