#include "scene/meeting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "scene/geometry.h"

namespace weir {

namespace {

// A part of a row inside a shape, in nodes; to rounding.
struct Stretch {
  double low;
  double high;
};

// Where a row lies inside one of several shapes.
class RowCut {
 public:
  explicit RowCut(const Lattice& lattice) : lattice_(lattice) {}

  template <class Shapes>
  void cut(std::int64_t y, std::int64_t z, const Shapes& shapes) {
    row_ = lattice_.point({0, y, z});
    node_ = {0, y, z};
    spans_.clear();
    shapes_.clear();
    for (const Shape& shape : shapes) {
      shapes_.push_back(&shape);
      std::visit([this](const auto& each) { this->add(each); }, shape);
    }
  }

  // Divides a run of the row into pieces that are inside any of the shapes, or outside all, as a whole. Calls
  // visit(piece, inside) from left to right, until it returns true; says whether it did.
  template <class Visit>
  bool any_piece(const Run& run, Visit visit) const {
    for (std::int64_t begin = run.begin; begin < run.end;) {
      const bool in = inside_any(begin);
      const std::int64_t end = std::max(begin + 1, in ? surely_in_to(begin, run.end) : surely_out_to(begin, run.end));
      if (visit(Run{begin, end}, in)) return true;
      begin = end;
    }
    return false;
  }

 private:
  void add(double low, double high) { spans_.push_back({lattice_.node_at(0, low), lattice_.node_at(0, high)}); }
  void add(const Box& box) {
    for (int axis = 1; axis < lattice_.dimension(); ++axis) {
      if (row_[axis] < box.min[axis] || row_[axis] > box.max[axis]) return;
    }
    add(box.min.x, box.max.x);
  }
  void add(const Ball& ball) {
    const double square = ball.radius * ball.radius;
    const Vec3 aside(0, row_.y - ball.center.y, row_.z - ball.center.z);
    const double rest = square - glm::dot(aside, aside);
    if (rest < -1e-12 * square) return;
    const double half = std::sqrt(std::max(rest, 0.0));
    add(ball.center.x - half, ball.center.x + half);
  }
  void add(const Polygon& polygon) {
    crossings(polygon.points, row_.y, crossed_);
    for (std::size_t k = 0; k + 1 < crossed_.size(); k += 2) add(crossed_[k], crossed_[k + 1]);
  }

  bool inside_any(std::int64_t column) const {
    const Vec3 point = lattice_.point({column, node_.y, node_.z});
    return std::any_of(shapes_.begin(), shapes_.end(),
                       [&](const Shape* shape) { return inside(*shape, point, lattice_.dimension()); });
  }
  // Both stop a node early, whose answer rounding could change: that one is asked again.
  std::int64_t surely_in_to(std::int64_t column, std::int64_t end) const {
    const auto at = static_cast<double>(column);
    double high = at;
    for (const Stretch& span : spans_) {
      if (span.low <= at) high = std::max(high, span.high);
    }
    return static_cast<std::int64_t>(std::floor(std::min(high, static_cast<double>(end))));
  }
  std::int64_t surely_out_to(std::int64_t column, std::int64_t end) const {
    const auto at = static_cast<double>(column);
    // Whatever ends at the next node or beyond it may hold that one.
    double low = static_cast<double>(end) + 1;
    for (const Stretch& span : spans_) {
      if (span.high >= at + 0.5) low = std::min(low, span.low);
    }
    return static_cast<std::int64_t>(std::ceil(std::max(low - 1, at)));
  }

  const Lattice& lattice_;
  Vec3 row_{0};
  glm::i64vec3 node_{0};
  std::vector<const Shape*> shapes_;
  std::vector<Stretch> spans_;
  std::vector<double> crossed_;
};

glm::i64vec3 nearest_node(const Lattice& lattice, const Vec3& point) {
  glm::i64vec3 node(0);
  for (int axis = 0; axis < lattice.dimension(); ++axis) node[axis] = std::llround(lattice.node_at(axis, point[axis]));
  return node;
}

bool nearer(const Vec3& a, const Vec3& b, double distance) { return glm::dot(a - b, a - b) < distance * distance; }

// The runs of the row asked for last.
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
  RowCut by_shape(lattice);
  RowCut by_holes(lattice);
  const auto outside_holes = [](const Run&, bool in) { return !in; };
  return lattice.any_row(box, [&](std::int64_t y, std::int64_t z, const std::vector<Run>& runs) {
    by_shape.cut(y, z, std::array<std::reference_wrapper<const Shape>, 1>{shape});
    by_holes.cut(y, z, holes);
    return std::any_of(runs.begin(), runs.end(), [&](const Run& run) {
      return by_shape.any_piece(
          run, [&](const Run& piece, bool in) { return in && by_holes.any_piece(piece, outside_holes); });
    });
  });
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
  RowCut by_shapes(lattice);
  lattice.any_row(box, [&](std::int64_t y, std::int64_t z, const std::vector<Run>& runs) {
    by_shapes.cut(y, z, shapes);
    for (const Run& run : runs) {
      by_shapes.any_piece(run, [&](const Run& piece, bool in) {
        if (in) return false;
        if (result.count == 0) result.first = lattice.point({piece.begin, y, z});
        result.count += piece.end - piece.begin;
        return false;
      });
    }
    return false;
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
