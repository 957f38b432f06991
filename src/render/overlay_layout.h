// Layout of the overlay's items. Sizes are proportional to the picture's height; items that do not fit are omitted, the
// least important first, so that items never overlap.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "render/canvas.h"
#include "render/projection.h"

namespace weir {

// Texts of the items, for their sizes; an omitted item has none.
struct OverlayTexts {
  std::optional<std::string> title;
  std::optional<std::string> time;                     // the longest
  std::optional<std::string> cfl;                      // the longest
  std::optional<std::string> scale;                    // the longest
  std::optional<std::string> quantity;                 // the colour bar's label
  std::function<std::vector<std::string>(int)> ticks;  // the colour bar's tick labels, at most so many
};

// The width of a text at a size, pixels.
using Measure = std::function<int(const std::string& text, int size, bool bold)>;

struct OverlayLayout {
  int size = 0;        // em of the text, pixels
  int title_size = 0;  // of the title
  int line = 0;        // thickness of thin lines, pixels
  int most_ticks = 0;
  std::string title_text;  // shortened to fit

  // Boxes of the items.
  std::optional<IntBox> title;
  std::optional<IntBox> time;
  std::optional<IntBox> cfl;
  std::optional<IntBox> scale;     // bar and text
  std::optional<IntBox> colorbar;  // including ticks and label
  IntBox bar;                      // the coloured part of the colour bar
  int largest_scale = 0;           // longest scale bar, pixels
  PixelBox content;                // the rest, for the scene
};

OverlayLayout lay_out(int width, int height, const OverlayTexts& texts, const Measure& measure);

}  // namespace weir
