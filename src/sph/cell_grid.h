// Index sort: points sorted by the grid cell that they lie in, and the ranges of points in a row of cells.
//
// [Hinsch24 ch. 5.2] with one departure: only cells that hold points are stored, so that memory and time follow the
// points and not the box in which they fly.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/types.h"

namespace weir {

// [begin, end) of sorted points.
struct PointRange {
  std::int32_t begin = 0;
  std::int32_t end = 0;
};

template <int Dim>
class CellGrid {
 public:
  using Cell = std::array<std::int64_t, Dim>;
  // Neighbouring cells lie in this many rows along the last axis.
  static constexpr int rows = Dim == 2 ? 3 : 9;

  // Sorts the points by cell, keeping the order of those that share one. Returns the order: point order[k] comes to
  // place k. Coordinates must be finite. Throws std::range_error when they lie more cells apart than a key can count.
  std::vector<std::int32_t> sort(const std::vector<Vec<Dim, double>>& points, double cell_size);

  Cell cell_of(const Vec<Dim, double>& point) const;

  // The sorted points in the cells at most one away from `cell`, as one range per row; empty rows have begin == end.
  std::array<PointRange, rows> neighbourhood(const Cell& cell) const;

 private:
  std::uint64_t key(const Cell& cell) const;

  double cell_size_ = 1;
  Cell low_{};  // smallest and largest cell that holds a point
  Cell high_{};
  std::array<int, Dim> shift_{};  // where a coordinate's bits begin in a key; the last axis varies fastest
  int key_bits_ = 0;
  std::vector<std::uint64_t> keys_;        // of cells that hold points, ascending
  std::vector<std::int32_t> first_point_;  // of each such cell; one more at the end
};

extern template class CellGrid<2>;
extern template class CellGrid<3>;

}  // namespace weir
