#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "output/compare.h"

namespace weir {

PictureDifference difference_of(const Image& a, const Image& b, int max) {
  PictureDifference difference;
  const std::size_t pixels = a.rgba.size() / 4;
  std::int64_t sum = 0;
  std::int64_t squares = 0;
  std::int64_t above = 0;
  for (std::size_t i = 0; i < pixels; ++i) {
    int of_pixel = 0;
    for (std::size_t channel = 0; channel < 4; ++channel) {
      const int apart = std::abs(a.rgba[4 * i + channel] - b.rgba[4 * i + channel]);
      of_pixel = std::max(of_pixel, apart);
      if (channel == 3) continue;
      sum += apart;
      squares += apart * apart;
    }
    difference.max = std::max(difference.max, of_pixel);
    if (of_pixel > max) ++above;
  }
  const double samples = 3 * static_cast<double>(std::max<std::size_t>(pixels, 1));
  difference.mean = static_cast<double>(sum) / samples;
  difference.psnr = squares == 0 ? std::numeric_limits<double>::infinity()
                                 : 10 * std::log10(255.0 * 255.0 * samples / static_cast<double>(squares));
  difference.fraction_above = 3 * static_cast<double>(above) / samples;
  return difference;
}

Image difference_picture(const Image& a, const Image& b) {
  const int largest = std::max(difference_of(a, b, 0).max, 1);
  Image picture{.width = a.width, .height = a.height, .rgba = a.rgba};
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    const int alpha_apart = std::abs(a.rgba[i + 3] - b.rgba[i + 3]);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const int apart = std::max(std::abs(a.rgba[i + channel] - b.rgba[i + channel]), alpha_apart);
      picture.rgba[i + channel] = static_cast<std::uint8_t>((255 * apart + largest / 2) / largest);
    }
    picture.rgba[i + 3] = 255;
  }
  return picture;
}

}  // namespace weir
