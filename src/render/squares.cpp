#include "render/squares.h"

#include <algorithm>

#include "render/texel.h"

namespace weir {

namespace {

int across(int pixels, int unit) { return (pixels + unit - 1) / unit; }

}  // namespace

Squares::Squares(int width, int height)
    : columns_(across(width, square_width)),
      rows_(across(height, square_height)),
      filled_(static_cast<std::size_t>(columns_) * rows_, 0),
      first_(filled_.size(), empty),
      first_to_draw_(rows_ + 1, 0) {}

void Squares::begin() { std::fill(filled_.begin(), filled_.end(), std::uint8_t{0}); }

std::size_t Squares::close(std::vector<std::uint8_t>& stale) {
  stale.resize(filled_.size(), 1);
  to_draw_.clear();
  std::uint32_t texels = square_texels;
  for (std::size_t square = 0; square < filled_.size(); ++square) {
    const std::size_t row = square / columns_;
    const bool is_filled = filled_[square] != 0;
    first_[square] = is_filled ? texels : empty;
    if (is_filled) texels += square_texels;
    if (is_filled || stale[square] != 0) {
      to_draw_.push_back(static_cast<std::uint32_t>(row << 16 | (square - row * columns_)));
    }
    stale[square] = filled_[square];
    first_to_draw_[row + 1] = to_draw_.size();
  }
  return texels;
}

}  // namespace weir
