#include "sph/cell_grid.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace weir {

namespace {

constexpr int digit_bits = 8;
constexpr int max_key_bits = 62;

struct KeyedPoint {
  std::uint64_t key;
  std::int32_t point;
};

// Stable counting sort by each digit of the key in turn, the lowest first.
void radix_sort(std::vector<KeyedPoint>& points, int key_bits) {
  std::vector<KeyedPoint> sorted(points.size());
  for (int shift = 0; shift < key_bits; shift += digit_bits) {
    constexpr std::uint64_t mask = (1U << digit_bits) - 1;
    std::array<std::size_t, mask + 2> start{};
    for (const KeyedPoint& p : points) ++start[(p.key >> shift & mask) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (const KeyedPoint& p : points) sorted[start[p.key >> shift & mask]++] = p;
    points.swap(sorted);
  }
}

}  // namespace

template <int Dim>
typename CellGrid<Dim>::Cell CellGrid<Dim>::cell_of(const Vec<Dim, double>& point) const {
  Cell cell;
  for (int d = 0; d < Dim; ++d) cell[d] = static_cast<std::int64_t>(std::floor(point[d] / cell_size_));
  return cell;
}

template <int Dim>
std::uint64_t CellGrid<Dim>::key(const Cell& cell) const {
  std::uint64_t key = 0;
  for (int d = 0; d < Dim; ++d) key |= static_cast<std::uint64_t>(cell[d] - low_[d]) << shift_[d];
  return key;
}

template <int Dim>
std::vector<std::int32_t> CellGrid<Dim>::sort(const std::vector<Vec<Dim, double>>& points, double cell_size) {
  cell_size_ = cell_size;
  keys_.clear();
  first_point_.assign(1, 0);
  if (points.empty()) return {};

  low_ = high_ = cell_of(points[0]);
  for (const auto& point : points) {
    const Cell cell = cell_of(point);
    for (int d = 0; d < Dim; ++d) {
      low_[d] = std::min(low_[d], cell[d]);
      high_[d] = std::max(high_[d], cell[d]);
    }
  }
  key_bits_ = 0;
  for (int d = Dim - 1; d >= 0; --d) {
    shift_[d] = key_bits_;
    key_bits_ += static_cast<int>(std::bit_width(static_cast<std::uint64_t>(high_[d] - low_[d])));
  }
  if (key_bits_ > max_key_bits) {
    throw std::range_error("particles have flown too far apart to be sorted (more than 2^62 cells between them)");
  }

  std::vector<KeyedPoint> keyed(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) keyed[i] = {key(cell_of(points[i])), static_cast<std::int32_t>(i)};
  radix_sort(keyed, key_bits_);

  std::vector<std::int32_t> order(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    order[k] = keyed[k].point;
    if (k == 0 || keyed[k].key != keyed[k - 1].key) {
      keys_.push_back(keyed[k].key);
      first_point_.back() = static_cast<std::int32_t>(k);
      first_point_.push_back(0);
    }
  }
  first_point_.back() = static_cast<std::int32_t>(points.size());
  return order;
}

template <int Dim>
std::array<PointRange, CellGrid<Dim>::rows> CellGrid<Dim>::neighbourhood(const Cell& cell) const {
  std::array<PointRange, rows> ranges{};
  if (keys_.empty()) return ranges;
  constexpr int last = Dim - 1;
  for (int row = 0; row < rows; ++row) {
    Cell from = cell;
    from[0] += row % 3 - 1;
    if constexpr (Dim == 3) from[1] += row / 3 - 1;
    bool outside = false;
    for (int d = 0; d < last; ++d) outside = outside || from[d] < low_[d] || from[d] > high_[d];
    Cell to = from;
    from[last] = std::max(from[last] - 1, low_[last]);
    to[last] = std::min(to[last] + 1, high_[last]);
    if (outside || from[last] > to[last]) continue;
    const auto begin = std::lower_bound(keys_.begin(), keys_.end(), key(from));
    const auto end = std::upper_bound(begin, keys_.end(), key(to));
    ranges[row] = {first_point_[begin - keys_.begin()], first_point_[end - keys_.begin()]};
  }
  return ranges;
}

template class CellGrid<2>;
template class CellGrid<3>;

}  // namespace weir
