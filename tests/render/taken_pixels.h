// Texels, as dots and balls leave them for the device, as the pixels of a picture.
#pragma once

#include <cstdint>
#include <vector>

#include "render/bins.h"
#include "render/texel.h"

namespace weir {

// 0xAABBGGRR, row by row; 0 where the bins have nothing.
inline std::vector<std::uint32_t> taken_pixels(const Bins& bins, const std::vector<Texel>& texels, int width,
                                               int height) {
  std::vector<std::uint32_t> pixels(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Bins::Range range = bins.ranges()[y / square_height * bins.columns() + x / square_width];
      if (range.first >= range.past) continue;
      const int block = y % square_height / 2 * (square_width / 4) + x % square_width / 4;
      pixels[y * width + x] = texels[range.first + 2 * block + y % 2][x % 4];
    }
  return pixels;
}

}  // namespace weir
