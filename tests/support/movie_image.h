// What a movie's frame must hold of an opaque picture, computed as the standards have it, without haste.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "frame/image.h"

namespace weir::testing {

// BT.709 [Rec. ITU-R BT.709-6, 3.2 to 3.5]: Y', Cb, Cr of 8 bits, not rounded, from RGB of 0 .. 255.
inline std::array<double, 3> ycc(const std::array<double, 3>& rgb) {
  const double luma = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
  return {16 + 219 * luma / 255, 128 + 224 * (rgb[2] - luma) / 1.8556 / 255,
          128 + 224 * (rgb[0] - luma) / 1.5748 / 255};
}

// Chroma beside the left edge of its 2 x 2 pixels: 1 2 1 across around there, both rows alike.
inline MovieImage movie_image(const Image& image) {
  MovieImage result;
  result.resize(image.width, image.height);
  const auto rgb = [&](int x, int y) {
    const std::uint8_t* p = image.pixel(std::max(x, 0), y);
    return std::array<double, 3>{static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
  };
  const auto rounded = [](double v) { return static_cast<std::uint8_t>(std::floor(v + 0.5)); };
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      result.y[static_cast<std::size_t>(y) * image.width + x] = rounded(ycc(rgb(x, y))[0]);
  for (int j = 0; j < image.height / 2; ++j)
    for (int i = 0; i < image.width / 2; ++i) {
      std::array<double, 3> mean{};
      for (int row = 0; row < 2; ++row)
        for (int column = -1; column < 2; ++column)
          for (std::size_t c = 0; c < 3; ++c)
            mean[c] += rgb(2 * i + column, 2 * j + row)[c] * (column == 0 ? 2 : 1) / 8;
      const std::size_t at = static_cast<std::size_t>(j) * (image.width / 2) + i;
      result.cb[at] = rounded(ycc(mean)[1]);
      result.cr[at] = rounded(ycc(mean)[2]);
    }
  return result;
}

}  // namespace weir::testing
