// The particles of one volume as a lattice: rows of nodes by their first and last column. No particle is stored.
#pragma once

#include <algorithm>
#include <vector>

#include "scene/scene.h"

namespace weir {

// Columns [begin, end) of a row.
struct Run {
  std::int64_t begin;
  std::int64_t end;
};

// Nodes dx apart along every axis, of which the shape holds some. Rows run along x, numbered along y and z.
class Lattice {
 public:
  // Keeps a pointer to the shape.
  Lattice(const Shape& shape, int dimension, double dx);

  double dx() const { return dx_; }
  int dimension() const { return dimension_; }
  const Shape& shape() const { return *shape_; }
  const glm::i64vec3& size() const { return size_; }  // nodes in the box around all particles; some may be empty

  Vec3 point(const glm::i64vec3& node) const { return base_ + dx_ * (Vec3(node) + shift_); }
  // Node number of a coordinate along an axis; not rounded.
  double node_at(int axis, double coordinate) const { return (coordinate - base_[axis]) / dx_ - shift_[axis]; }

  // Runs of nodes in the row at (any, y, z), from left to right.
  void runs(std::int64_t y, std::int64_t z, std::vector<Run>& result) const;
  std::int64_t count() const;
  bool empty() const;
  // A box around the particles; exact for boxes, that of the shape for others.
  const Bounds& bounds() const { return bounds_; }

  // Calls visit(y, z, runs) for rows that hold anything, until it returns true; says whether it did. Only rows that may
  // lie in `within`.
  template <class Visit>
  bool any_row(const Bounds& within, Visit visit) const {
    const Run rows = clipped(1, within);
    const Run slices = clipped(2, within);
    std::vector<Run> held;
    for (std::int64_t z = slices.begin; z < slices.end; ++z) {
      for (std::int64_t y = rows.begin; y < rows.end; ++y) {
        runs(y, z, held);
        if (!held.empty() && visit(y, z, held)) return true;
      }
    }
    return false;
  }
  // Calls visit(point), x fastest, for particles that may lie in `within`, until it returns true; says whether it did.
  template <class Visit>
  bool any_point(const Bounds& within, Visit visit) const {
    const Run columns = clipped(0, within);
    return any_row(within, [&](std::int64_t y, std::int64_t z, const std::vector<Run>& held) {
      for (const Run& run : held) {
        const std::int64_t end = std::min(run.end, columns.end);
        for (std::int64_t x = std::max(run.begin, columns.begin); x < end; ++x) {
          if (visit(point({x, y, z}))) return true;
        }
      }
      return false;
    });
  }
  // Calls visit(point) for every particle, x fastest.
  template <class Visit>
  void for_each(Visit visit) const {
    any_point(bounds_, [&](const Vec3& point) {
      visit(point);
      return false;
    });
  }

 private:
  Run clipped(int axis, const Bounds& within) const;
  void lay(const Box& box);
  void lay(const Ball& ball);
  void lay(const Polygon& polygon);
  void lay_ball(const Ball& ball, std::int64_t parity);
  void runs_of(const Box& box, std::int64_t y, std::int64_t z, std::vector<Run>& result) const;
  void runs_of(const Ball& ball, std::int64_t y, std::int64_t z, std::vector<Run>& result) const;
  void runs_of(const Polygon& polygon, std::int64_t y, std::int64_t z, std::vector<Run>& result) const;

  const Shape* shape_;
  int dimension_;
  double dx_;
  Vec3 base_{0};
  Vec3 shift_{0};
  glm::i64vec3 size_{1};
  std::int64_t first_offset_ = 0;  // of a ball: node 0 from its centre, in half spacings
  Bounds bounds_;
};

}  // namespace weir
