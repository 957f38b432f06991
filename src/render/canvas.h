// Rectangles and text laid over a picture in memory, "over" with straight alpha.
#pragma once

#include <string_view>

#include "frame/image.h"
#include "render/font.h"
#include "render/palette.h"

namespace weir {

struct IntBox {  // pixels, right and bottom not included
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

// Lays one colour over one pixel; `alpha` 0 .. 255.
void blend(Image& image, int x, int y, Rgb color, int alpha);

// The part of the box that lies in the picture.
void fill(Image& image, const IntBox& box, Rgb color, int alpha = 255);

// From (x, baseline) to the right.
void draw_text(Image& image, Font& font, int size, int x, int baseline, std::string_view utf8, Rgb color);
// From (baseline, y) upwards: turned a quarter to the left.
void draw_text_upwards(Image& image, Font& font, int size, int baseline, int y, std::string_view utf8, Rgb color);

}  // namespace weir
