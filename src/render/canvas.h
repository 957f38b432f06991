// Rectangles and text, composited over a picture in memory with straight alpha.
#pragma once

#include <string_view>

#include "frame/image.h"
#include "render/font.h"
#include "render/palette.h"

namespace weir {

struct IntBox {  // pixels; right and bottom are exclusive
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

// Composites a colour over a pixel; `alpha` 0 .. 255.
void blend(Image& image, int x, int y, Rgb color, int alpha);

// Fills the box, clipped to the picture.
void fill(Image& image, const IntBox& box, Rgb color, int alpha = 255);

// Text from (x, baseline) to the right.
void draw_text(Image& image, Font& font, int size, int x, int baseline, std::string_view utf8, Rgb color);
// Text from (baseline, y) upwards, rotated by 90 degrees.
void draw_text_upwards(Image& image, Font& font, int size, int baseline, int y, std::string_view utf8, Rgb color);

}  // namespace weir
