#include "render/visible_balls.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <tuple>

#include "render/lanes.h"

namespace weir {

namespace {

// Layers are a radius thick, counted from the eye, so that all in one lie wholly in front of the one after the next; the
// last takes all the rest, and hides nothing.
constexpr std::size_t layers = 1 << 15;

// A byte of covered_ counts from `none` up to where its highest bit is set: then the pixel is closed, and adding ends.
constexpr int full = 65;
constexpr std::uint8_t none = 128 - full;
constexpr std::uint64_t closed_bits = 0x8080808080808080;

// "Around" a bin: so many to each side, and up and down. As bins are made for their balls, most balls lie within.
constexpr int columns_near = 1;
constexpr int rows_near = 2;

// Pixels are covered four at a time and looked at eight at a time, from any on.
constexpr int margin = 8;

}  // namespace

VisibleBalls::VisibleBalls(int width, int height) : width_(width), height_(height), stride_(width + margin) {}

inline float VisibleBalls::reach_of(const ScreenBall& ball) const {
  return std::max(radius_ * focal_ / ball.depth, least_ball);
}

inline VisibleBalls::Box VisibleBalls::pixels_of(const ScreenBall& ball) const {
  const float reach = reach_of(ball);
  return {static_cast<int>(std::max(ball.x - reach, 0.0f)), static_cast<int>(std::max(ball.y - reach, 0.0f)),
          static_cast<int>(std::min(ball.x + reach, static_cast<float>(width_ - 1))) + 1,
          static_cast<int>(std::min(ball.y + reach, static_cast<float>(height_ - 1))) + 1};
}

void VisibleBalls::begin(double radius, double focal, std::size_t most, const Bins& bins) {
  radius_ = static_cast<float>(radius);
  focal_ = static_cast<float>(focal);
  column_shift_ = std::countr_zero(static_cast<unsigned>(block_width)) + bins.shift();
  row_shift_ = std::countr_zero(static_cast<unsigned>(block_height)) + bins.shift();
  bin_columns_ = bins.columns();
  bin_rows_ = static_cast<int>(bins.size()) / bin_columns_;
  size_ = 0;
  if (balls_.size() < most + 4) {
    balls_.resize(most + 4);
    places_.resize(most + 4);
    sorted_.resize(most + 4);
  }
  begins_.assign(layers + 2, 0);
}

void VisibleBalls::add(const std::array<Lanes, 4>& four, Whole seen) {
  const auto& [x, y, color, depth] = four;
  const Whole layer = truncated(smaller(depth * (1 / radius_), all(layers - 1)));
  const auto pixel = [](Lanes at, int size) {
    return truncated(larger(smaller(at, all(static_cast<float>(size - 1))), all(0)));
  };
  const Whole column = pixel(x, width_) >> column_shift_;
  const Whole row = pixel(y, height_) >> row_shift_;
  const std::array<Lanes, 4> balls = transposed(four);
  for (int k = 0; k < 4; ++k) {
    balls_[size_] = std::bit_cast<ScreenBall>(balls[k]);
    places_[size_] = {static_cast<std::uint32_t>(layer[k]),
                      static_cast<std::uint32_t>(row[k] * bin_columns_ + column[k])};
    if (seen[k] == 0) continue;
    ++size_;
    ++begins_[layer[k] + 2];
  }
}

void VisibleBalls::sort() {
  for (std::size_t k = 2; k < begins_.size(); ++k) begins_[k] += begins_[k - 1];
  // Each beginning moves on to its end, which is the next one's beginning.
  for (std::uint32_t k = 0; k < size_; ++k) sorted_[begins_[places_[k].layer + 1]++] = {places_[k].bin, k};
}

void VisibleBalls::count(Bins& bins) {
  sort();
  covered_.assign(stride_ * height_, none);
  closed_.assign(bins.size(), 0);
  open_near_.assign(bins.size(), 0);
  for (int row = 0; row < bin_rows_; ++row)
    for (int column = 0; column < bin_columns_; ++column) visit_near(column, row, [](std::uint8_t& open) { ++open; });
  entries_.clear();
  in_front_.clear();
  // One to the right of a ball as well: the chroma of a block takes from the pixel to its left.
  const auto near = static_cast<float>(std::min((columns_near << column_shift_) - 1, rows_near << row_shift_));
  for (std::size_t layer = 0; layer < layers && begins_[layer] < size_; ++layer) {
    in_this_.clear();
    const bool small = std::max(focal_ / static_cast<float>(layer), least_ball) < near;
    for (std::size_t k = begins_[layer]; k < begins_[layer + 1]; ++k) {
      // All that most balls are asked.
      if (small && open_near_[sorted_[k].bin] == 0) continue;
      __builtin_prefetch(&balls_[sorted_[k].ball]);  // they lie anywhere
      in_this_.push_back(sorted_[k].ball);
    }
    std::erase_if(in_this_, [&](std::uint32_t ball) { return !lists(ball, bins); });
    for (const std::uint32_t ball : in_front_) cover(balls_[ball]);
    std::swap(in_front_, in_this_);
  }
}

template <class Visit>
void VisibleBalls::visit_near(int column, int row, const Visit& visit) {
  for (int r = std::max(row - rows_near, 0); r <= std::min(row + rows_near, bin_rows_ - 1); ++r)
    for (int c = std::max(column - columns_near, 0); c <= std::min(column + columns_near, bin_columns_ - 1); ++c)
      visit(open_near_[static_cast<std::size_t>(r) * bin_columns_ + c]);
}

bool VisibleBalls::lists(std::uint32_t ball, Bins& bins) {
  const Box touched = pixels_of(balls_[ball]);
  const int last_column = std::min(touched.right >> column_shift_, bin_columns_ - 1);
  const int last_row = (touched.bottom - 1) >> row_shift_;
  bool listed = false;
  for (int row = touched.top >> row_shift_; row <= last_row; ++row)
    for (int column = touched.left >> column_shift_; column <= last_column; ++column) {
      const auto bin = static_cast<std::uint32_t>(row * bin_columns_ + column);
      if (closed_[bin] != 0) continue;
      // The pixels that matter to the bin: its own, and those on its left.
      const Box all{std::max((column << column_shift_) - 1, 0), row << row_shift_,
                    std::min((column + 1) << column_shift_, width_), std::min((row + 1) << row_shift_, height_)};
      const Box part{std::max(all.left, touched.left), std::max(all.top, touched.top),
                     std::min(all.right, touched.right), std::min(all.bottom, touched.bottom)};
      if (is_closed(part)) {
        if (is_closed(all)) {
          closed_[bin] = 1;
          visit_near(column, row, [](std::uint8_t& open) { --open; });
        }
        continue;
      }
      entries_.push_back({bin, ball});
      bins.count(bin, 1);
      listed = true;
    }
  return listed;
}

bool VisibleBalls::is_closed(const Box& box) const {
  for (int x = box.left; x < box.right; x += 8) {
    std::uint64_t all = closed_bits;
    const std::uint8_t* at = &covered_[box.top * stride_ + x];
    for (int y = box.top; y < box.bottom; ++y, at += stride_) {
      std::uint64_t eight = 0;
      std::memcpy(&eight, at, sizeof(eight));
      all &= eight;
    }
    // Bytes beyond the right do not count; the first byte is the lowest.
    const int bytes = box.right - x;
    const std::uint64_t wanted = bytes < 8 ? closed_bits >> 8 * (8 - bytes) : closed_bits;
    if ((all & wanted) != wanted) return false;
  }
  return true;
}

void VisibleBalls::cover(const ScreenBall& ball) {
  const Box box = pixels_of(ball);
  const float reach = reach_of(ball);
  const float seen = radius_ * focal_ / ball.depth / reach;
  const float most = static_cast<float>(full) * seen * seen;
  const float middle = most * (0.5f + 0.5f * reach);
  const float slope = most * 0.5f / reach;
  const Lanes first = Lanes{0.5f, 1.5f, 2.5f, 3.5f} - ball.x;
  for (int y = box.top; y < box.bottom; ++y) {
    const float down = static_cast<float>(y) + 0.5f - ball.y;
    const float at_top = middle - slope * down * down;
    std::uint8_t* at = &covered_[y * stride_ + box.left];
    for (int x = box.left; x < box.right; x += 4, at += 4) {
      std::uint32_t sums = 0;
      std::memcpy(&sums, at, sizeof(sums));
      const std::uint32_t closed = sums & static_cast<std::uint32_t>(closed_bits);
      if (closed == static_cast<std::uint32_t>(closed_bits)) continue;
      const Lanes across = first + static_cast<float>(x);
      const Lanes share = larger(smaller(at_top - slope * (across * across), all(most)), all(0));
      // Each in its byte.
      const Whole units = truncated(floats(truncated(share)) * Lanes{1, 0x100, 0x10000, 0x1000000});
      sums += static_cast<std::uint32_t>(units[0] | units[1] | units[2] | units[3]) & ~((closed >> 7) * 0xff);
      std::memcpy(at, &sums, sizeof(sums));
    }
  }
}

void VisibleBalls::scatter(Bins& bins, ScreenBall* entries) {
  in_bins_.resize(entries_.size());
  for (const Entry& entry : entries_) in_bins_[bins.next(entry.bin)] = balls_[entry.ball];
  const auto order = [](const ScreenBall& ball) { return std::tuple(ball.depth, ball.x, ball.y, ball.color); };
  for (const Bins::Range& range : bins.ranges())
    if (range.first < range.past)
      std::sort(in_bins_.begin() + range.first, in_bins_.begin() + range.past,
                [&](const ScreenBall& a, const ScreenBall& b) { return order(a) < order(b); });
  std::copy(in_bins_.begin(), in_bins_.end(), entries);
}

}  // namespace weir
