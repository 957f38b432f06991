#include "scene/lattice.h"

#include <algorithm>
#include <cmath>

#include "scene/cells.h"
#include "scene/geometry.h"

namespace weir {

Lattice::Lattice(const Shape& shape, int dimension, double dx)
    : shape_(&shape), dimension_(dimension), dx_(dx), bounds_(shape_bounds(shape, dimension)) {
  std::visit([this](const auto& each) { lay(each); }, shape);
}

void Lattice::lay(const Box& box) {
  for (int axis = 0; axis < dimension_; ++axis) {
    size_[axis] = cells(box.max[axis] - box.min[axis], dx_);
    base_[axis] = box.min[axis];
    shift_[axis] = 0.5;
  }
  bounds_ = {point(glm::i64vec3(0)), point(size_ - std::int64_t{1})};
}

// Lattices with a cell's corner in the middle (odd offsets in half spacings) and with a cell there (even ones) are both
// symmetric about the centre; the one whose mass is nearer to the ball's is taken.
void Lattice::lay(const Ball& ball) {
  const double wanted = measure(Shape(ball), dimension_) / std::pow(dx_, dimension_);
  const auto error = [&] { return std::abs(static_cast<double>(count()) - wanted); };
  lay_ball(ball, 0);
  const double of_even = error();
  lay_ball(ball, 1);
  if (of_even < error()) lay_ball(ball, 0);
}

void Lattice::lay_ball(const Ball& ball, std::int64_t parity) {
  const std::int64_t reach = static_cast<std::int64_t>(2 * ball.radius / dx_) + 2;
  first_offset_ = -(reach + ((reach + parity) % 2));
  base_ = ball.center;
  for (int axis = 0; axis < dimension_; ++axis) {
    size_[axis] = 1 - first_offset_;
    shift_[axis] = 0.5 * static_cast<double>(first_offset_);
  }
}

void Lattice::lay(const Polygon& polygon) {
  const Bounds box = shape_bounds(Shape(polygon), dimension_);
  base_ = Vec3(box.min.x, box.min.y, 0);
  shift_ = Vec3(0.5, 0.5, 0);
  size_ = glm::i64vec3(static_cast<std::int64_t>((box.max.x - box.min.x) / dx_) + 1,
                       static_cast<std::int64_t>((box.max.y - box.min.y) / dx_) + 1, 1);
}

void Lattice::runs(std::int64_t y, std::int64_t z, std::vector<Run>& result) const {
  result.clear();
  std::visit([&](const auto& each) { runs_of(each, y, z, result); }, *shape_);
}

void Lattice::runs_of(const Box&, std::int64_t, std::int64_t, std::vector<Run>& result) const {
  result.push_back({0, size_.x});
}

void Lattice::runs_of(const Ball& ball, std::int64_t y, std::int64_t z, std::vector<Run>& result) const {
  const std::int64_t from_center = first_offset_ + 2 * y;
  const std::int64_t aside = dimension_ == 3 ? first_offset_ + 2 * z : 0;
  const std::int64_t square = from_center * from_center + aside * aside;
  const double limit = 4 * (ball.radius / dx_) * (ball.radius / dx_);
  const auto within = [&](std::int64_t offset) { return static_cast<double>(offset * offset + square) < limit; };
  // The root is a guess; whole numbers decide.
  auto last = static_cast<std::int64_t>(std::sqrt(std::max(0.0, limit - static_cast<double>(square))));
  last += (last + first_offset_) % 2 != 0 ? 1 : 0;
  while (last >= 0 && !within(last)) last -= 2;
  if (last < 0) return;
  while (within(last + 2)) last += 2;
  result.push_back({(-last - first_offset_) / 2, (last - first_offset_) / 2 + 1});
}

// Between the outline's crossings (even-odd), so that slivers cost their rows and not their bounding box.
void Lattice::runs_of(const Polygon& polygon, std::int64_t y, std::int64_t, std::vector<Run>& result) const {
  const auto x = [&](std::int64_t column) { return base_.x + dx_ * (static_cast<double>(column) + shift_.x); };
  std::vector<double> crossed;
  crossings(polygon.points, base_.y + dx_ * (static_cast<double>(y) + shift_.y), crossed);
  for (std::size_t k = 0; k + 1 < crossed.size(); k += 2) {
    const auto begin = static_cast<std::int64_t>(std::ceil(node_at(0, crossed[k])));
    auto end = std::max(begin, static_cast<std::int64_t>(std::ceil(node_at(0, crossed[k + 1]))));
    while (end > begin && x(end - 1) >= crossed[k + 1]) --end;
    while (x(end) < crossed[k + 1]) ++end;
    if (begin < end) result.push_back({begin, end});
  }
}

Run Lattice::clipped(int axis, const Bounds& within) const {
  if (axis >= dimension_) return {0, size_[axis]};
  // One node more at each end than rounding could cost.
  const double low = std::floor(node_at(axis, within.min[axis])) - 1;
  const double high = std::ceil(node_at(axis, within.max[axis])) + 2;
  const auto size = static_cast<double>(size_[axis]);
  return {static_cast<std::int64_t>(std::clamp(low, 0.0, size)),
          static_cast<std::int64_t>(std::clamp(high, 0.0, size))};
}

std::int64_t Lattice::count() const {
  if (std::holds_alternative<Box>(*shape_)) return size_.x * size_.y * size_.z;
  std::int64_t sum = 0;
  any_row(bounds_, [&](std::int64_t, std::int64_t, const std::vector<Run>& runs) {
    for (const Run& run : runs) sum += run.end - run.begin;
    return false;
  });
  return sum;
}

bool Lattice::empty() const {
  return !any_row(bounds_, [](std::int64_t, std::int64_t, const std::vector<Run>&) { return true; });
}

}  // namespace weir
