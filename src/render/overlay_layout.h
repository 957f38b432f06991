// Where the overlay's items lie. Sizes follow the picture's height; items that do not fit are left out, the least
// needed first, so that nothing overlaps at any size.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "render/canvas.h"
#include "render/projection.h"

namespace weir {

// The texts that the items need room for; an item that is not asked for has none.
struct OverlayTexts {
  std::optional<std::string> title;
  std::optional<std::string> time;                     // the longest that will be shown
  std::optional<std::string> cfl;                      // the longest that will be shown
  std::optional<std::string> scale;                    // the longest that will be shown
  std::optional<std::string> quantity;                 // the colour bar's label
  std::function<std::vector<std::string>(int)> ticks;  // the colour bar's tick labels, at most that many
};

// The width of a text at a size, pixels.
using Measure = std::function<int(const std::string& text, int size, bool bold)>;

struct OverlayLayout {
  int size = 0;        // em of the text, pixels
  int title_size = 0;  // of the title
  int line = 0;        // thickness of thin lines, pixels
  int most_ticks = 0;
  std::string title_text;  // shortened if it has to be

  // Boxes of the items that are shown.
  std::optional<IntBox> title;
  std::optional<IntBox> time;
  std::optional<IntBox> cfl;
  std::optional<IntBox> scale;     // bar and text
  std::optional<IntBox> colorbar;  // all of it
  IntBox bar;                      // the coloured part of the colour bar
  int largest_scale = 0;           // the longest that the scale bar itself may be, pixels
  PixelBox content;                // what is left for the scene
};

OverlayLayout lay_out(int width, int height, const OverlayTexts& texts, const Measure& measure);

}  // namespace weir
