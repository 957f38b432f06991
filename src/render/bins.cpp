#include "render/bins.h"

namespace weir {

namespace {

int bins_across(int pixels, int block, int shift) {
  const int blocks = (pixels + block - 1) / block;
  return (blocks + (1 << shift) - 1) >> shift;
}

}  // namespace

Bins::Bins(int width, int height) : width_(width), height_(height) { reset(0); }

void Bins::reset(int shift) {
  shift_ = shift;
  columns_ = bins_across(width_, block_width, shift);
  const auto bins = static_cast<std::size_t>(columns_) * bins_across(height_, block_height, shift);
  next_.assign(bins, 0);
  ranges_.resize(bins);
}

std::size_t Bins::close(std::vector<std::uint8_t>& stale) {
  stale.resize(ranges_.size(), 1);
  std::uint32_t sum = 0;
  for (std::size_t bin = 0; bin < ranges_.size(); ++bin) {
    const std::uint32_t entries = next_[bin];
    next_[bin] = sum;
    ranges_[bin] = entries > 0 || stale[bin] != 0 ? Range{sum, sum + entries} : Range{};
    stale[bin] = entries > 0 ? 1 : 0;
    sum += entries;
  }
  return sum;
}

bool Bins::any_to_do(int column, int row, int blocks) const {
  const int rows = static_cast<int>(ranges_.size()) / columns_;
  const int last_row = std::min((row + blocks - 1) >> shift_, rows - 1);
  const int last_column = std::min((column + blocks - 1) >> shift_, columns_ - 1);
  for (int r = row >> shift_; r <= last_row; ++r)
    for (int c = column >> shift_; c <= last_column; ++c) {
      const Range& range = ranges_[static_cast<std::size_t>(r) * columns_ + c];
      if (range.first <= range.past) return true;
    }
  return false;
}

}  // namespace weir
