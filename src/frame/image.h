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

// A movie's frame: 8-bit Y'CbCr of BT.709, Y in 16 .. 235 and chroma in 16 .. 240, one sample of chroma for
// 2 x 2 pixels, level with the middle of their left edge as H.264 has it by default; rows from top to bottom, no padding.
struct MovieImage {
  int width = 0;  // even, as is the height
  int height = 0;
  std::vector<std::uint8_t> y;   // width * height
  std::vector<std::uint8_t> cb;  // a quarter of that
  std::vector<std::uint8_t> cr;
  // Set by the renderer that drew this, which then redraws only what has changed; 0: content unknown.
  std::int64_t known_as = 0;

  void resize(int new_width, int new_height) {
    width = new_width;
    height = new_height;
    const std::size_t pixels = static_cast<std::size_t>(width) * height;
    if (y.size() != pixels) known_as = 0;
    y.resize(pixels);
    cb.resize(pixels / 4);
    cr.resize(pixels / 4);
  }
};

}  // namespace weir
