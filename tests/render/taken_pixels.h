// Converts the texels of the rasterisers to the pixels of a picture.
#pragma once

#include <cstdint>
#include <vector>

#include "render/colormap.h"
#include "render/particle_pixels.h"

namespace weir {

// A map of 256 different colours.
inline const Colormap& distinct_colors() {
  static const Colormap made = [] {
    Colormap map;
    for (std::uint32_t k = 0; k < map.size(); ++k) map[k] = k << 16 | (255 - k) << 8 | (k * 37 & 0xff);
    return map;
  }();
  return made;
}

// 0xAABBGGRR, row by row; 0 where squares have nothing.
inline std::vector<std::uint32_t> taken_pixels(const Squares& squares, const std::vector<Texel>& texels, int width,
                                               int height) {
  std::vector<std::uint32_t> pixels(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::uint32_t first = squares.first_texels()[y / square_height * squares.columns() + x / square_width];
      if (first == Squares::empty) continue;
      const int block = y % square_height / 2 * (square_width / 4) + x % square_width / 4;
      pixels[y * width + x] = texels[first + 2 * block + y % 2][x % 4];
    }
  return pixels;
}

inline std::vector<std::uint32_t> taken_pixels(ParticlePixels& particles, int width, int height) {
  Squares squares(width, height);
  particles.mark(squares);
  std::vector<std::uint8_t> stale;
  std::vector<Texel> texels(squares.close(stale));
  particles.take(squares, 1, texels.data(), [](int) {});
  return taken_pixels(squares, texels, width, height);
}

}  // namespace weir
