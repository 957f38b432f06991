// A picture in memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace weir {

// 8-bit sRGB with straight (not premultiplied) alpha, rows from top to bottom, no padding.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;  // 4 * width * height

  std::uint8_t* pixel(int x, int y) { return &rgba[4 * (static_cast<std::size_t>(y) * width + x)]; }
  const std::uint8_t* pixel(int x, int y) const { return &rgba[4 * (static_cast<std::size_t>(y) * width + x)]; }
};

}  // namespace weir
