#include "render/canvas.h"

#include <algorithm>

namespace weir {

namespace {

// Calls place(along, down, coverage) for each pixel of the text: `along` from its start, `down` from the baseline.
template <class Place>
void rasterise(Font& font, int size, std::string_view utf8, Place&& place) {
  int pen = 0;
  for (const char32_t character : code_points(utf8)) {
    const Glyph& glyph = font.glyph(character, size);
    for (int row = 0; row < glyph.height; ++row)
      for (int column = 0; column < glyph.width; ++column)
        place(pen + glyph.left + column, row - glyph.top,
              glyph.coverage[static_cast<std::size_t>(row) * glyph.width + column]);
    pen += glyph.advance;
  }
}

}  // namespace

void blend(Image& image, int x, int y, Rgb color, int alpha) {
  if (alpha == 0 || x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  std::uint8_t* pixel = image.pixel(x, y);
  if (pixel[0] == color.r && pixel[1] == color.g && pixel[2] == color.b && pixel[3] == 255) return;
  if (pixel[3] == 255) {  // the common case, with a division by a constant
    const auto mix = [alpha](std::uint8_t top, std::uint8_t bottom) {
      return static_cast<std::uint8_t>((top * alpha + bottom * (255 - alpha) + 127) / 255);
    };
    pixel[0] = mix(color.r, pixel[0]);
    pixel[1] = mix(color.g, pixel[1]);
    pixel[2] = mix(color.b, pixel[2]);
    return;
  }
  const int under = pixel[3] * (255 - alpha);  // remaining alpha of the picture, times 255
  const int total = 255 * alpha + under;       // the new alpha, times 255
  const auto mix = [&](std::uint8_t top, std::uint8_t bottom) {
    return static_cast<std::uint8_t>((top * 255 * alpha + bottom * under + total / 2) / total);
  };
  pixel[0] = mix(color.r, pixel[0]);
  pixel[1] = mix(color.g, pixel[1]);
  pixel[2] = mix(color.b, pixel[2]);
  pixel[3] = static_cast<std::uint8_t>((total + 127) / 255);
}

void fill(Image& image, const IntBox& box, Rgb color, int alpha) {
  const int left = std::max(box.left, 0);
  const int right = std::min(box.right, image.width);
  for (int y = std::max(box.top, 0); y < std::min(box.bottom, image.height); ++y)
    for (int x = left; x < right; ++x) blend(image, x, y, color, alpha);
}

void draw_text(Image& image, Font& font, int size, int x, int baseline, std::string_view utf8, Rgb color) {
  rasterise(font, size, utf8,
            [&](int along, int down, int coverage) { blend(image, x + along, baseline + down, color, coverage); });
}

void draw_text_upwards(Image& image, Font& font, int size, int baseline, int y, std::string_view utf8, Rgb color) {
  rasterise(font, size, utf8,
            [&](int along, int down, int coverage) { blend(image, baseline + down, y - 1 - along, color, coverage); });
}

}  // namespace weir
