#include "render/overlay_layout.h"

#include <algorithm>
#include <cmath>

namespace weir {

namespace {

constexpr int smallest_text = 9;           // pixels; DejaVu Sans is illegible below
constexpr double text_per_height = 0.023;  // 25 pixels at 1080
constexpr double ascent = 0.76;            // of the em: capitals and ascenders of DejaVu Sans
constexpr double descent = 0.24;
constexpr double longest_bar = 25;    // em; a longer colour bar adds no information
constexpr double scale_share = 0.16;  // longest scale bar over the picture's width

int times(double factor, int size) { return static_cast<int>(std::lround(factor * size)); }

// The title, shortened with an ellipsis to the width; empty if fewer than a few letters fit.
std::string shortened(const std::string& title, int width, int size, const Measure& measure) {
  if (measure(title, size, true) <= width) return title;
  std::string kept = title;
  while (!kept.empty()) {
    // Removes whole code points: continuation bytes of UTF-8 start with the bits 10.
    while (!kept.empty() && (static_cast<unsigned char>(kept.back()) & 0xc0) == 0x80) kept.pop_back();
    if (!kept.empty()) kept.pop_back();
    while (!kept.empty() && kept.back() == ' ') kept.pop_back();
    if (kept.size() >= 3 && measure(kept + "…", size, true) <= width) return kept + "…";
  }
  return {};
}

class Layouter {
 public:
  Layouter(int width, int height, const OverlayTexts& texts, const Measure& measure)
      : width_(width), height_(height), texts_(texts), measure_(measure) {
    const double reference = std::min<double>(height, 0.75 * width);  // tall pictures are limited by their width
    layout_.size = std::max(smallest_text, static_cast<int>(std::lround(text_per_height * reference)));
    layout_.title_size = times(1.2, layout_.size);
    layout_.line = std::max(1, times(0.06, layout_.size));
    margin_ = times(0.8, layout_.size);
    gap_ = times(1.2, layout_.size);
  }

  OverlayLayout layout() {
    top_row();
    bottom_row();
    const int top = layout_.title || layout_.time ? margin_ + row_height(layout_.title_size) : 0;
    const int bottom = layout_.scale || layout_.cfl ? margin_ + row_height(layout_.size) : 0;
    const int right = colorbar(top, bottom);
    layout_.content = {static_cast<double>(margin_), static_cast<double>(top + margin_),
                       static_cast<double>(width_ - right - margin_), static_cast<double>(height_ - bottom - margin_)};
    // A picture smaller than the margins has no overlay.
    if (layout_.content.width() < 1 || layout_.content.height() < 1)
      layout_.content = {0, 0, static_cast<double>(width_), static_cast<double>(height_)};
    return layout_;
  }

 private:
  static int row_height(int size) { return times(ascent + descent, size); }

  IntBox row_box(int left, int width, bool at_top) const {
    const int height = at_top ? row_height(layout_.title_size) : row_height(layout_.size);
    const int top = at_top ? margin_ : height_ - margin_ - height;
    return {left, top, left + width, top + height};
  }
  // A row of text takes two lines including its margin, on either side of the scene.
  bool row_fits() const { return height_ >= 5 * layout_.size; }
  bool two_rows_fit() const { return height_ >= 8 * layout_.size; }

  void top_row() {
    if (!row_fits()) return;
    int free = width_ - 2 * margin_;
    if (texts_.time) {
      const int needed = measure_(*texts_.time, layout_.size, false);
      if (needed <= free) {
        layout_.time = row_box(width_ - margin_ - needed, needed, true);
        free -= needed + gap_;
      }
    }
    if (texts_.title) {
      layout_.title_text = shortened(*texts_.title, free, layout_.title_size, measure_);
      if (!layout_.title_text.empty())
        layout_.title = row_box(margin_, measure_(layout_.title_text, layout_.title_size, true), true);
    }
  }

  void bottom_row() {
    if (!two_rows_fit()) return;
    int free = width_ - 2 * margin_;
    if (texts_.cfl) {
      const int needed = measure_(*texts_.cfl, layout_.size, false);
      if (needed <= free) {
        layout_.cfl = row_box(width_ - margin_ - needed, needed, false);
        free -= needed + gap_;
      }
    }
    if (texts_.scale) {
      const int text = times(0.5, layout_.size) + measure_(*texts_.scale, layout_.size, false);
      layout_.largest_scale = std::min(static_cast<int>(scale_share * width_), free - text);
      if (layout_.largest_scale >= 2 * layout_.size)
        layout_.scale = row_box(margin_, layout_.largest_scale + text, false);
    }
  }

  // Returns the width of the column of the colour bar at the right edge.
  int colorbar(int top, int bottom) {
    if (!texts_.quantity) return 0;
    const int size = layout_.size;
    const int room = height_ - top - bottom - 2 * margin_;
    const int label = measure_(*texts_.quantity, size, false);
    const int length = std::min({room, times(longest_bar, size), std::max(times(0.72, room), label + size)});
    layout_.most_ticks = std::min(7, length / times(2.6, size) + 1);
    if (layout_.most_ticks < 2 || label > length) return 0;
    int widest = 0;
    for (const std::string& text : texts_.ticks(layout_.most_ticks))
      widest = std::max(widest, measure_(text, size, false));
    const int bar = size;
    const int tick = times(0.35, size);   // the mark
    const int space = times(0.25, size);  // between mark and number
    const int label_height = times(1.4, size);
    const int column = bar + tick + space + widest + label_height;
    if (column > 0.35 * width_) return 0;
    const int left = width_ - margin_ - column;
    // Half a line above and below, for the numbers at the bar's ends.
    const int overhang = times(0.5, size);
    const int middle = top + margin_ + room / 2;
    const int half = length / 2 - overhang;
    layout_.bar = {left, middle - half, left + bar, middle + half};
    layout_.colorbar = IntBox{left, middle - half - overhang, left + column, middle + half + overhang};
    return column + margin_;
  }

  int width_;
  int height_;
  const OverlayTexts& texts_;
  const Measure& measure_;
  int margin_ = 0;
  int gap_ = 0;  // between two items of a row
  OverlayLayout layout_;
};

}  // namespace

OverlayLayout lay_out(int width, int height, const OverlayTexts& texts, const Measure& measure) {
  return Layouter(width, height, texts, measure).layout();
}

}  // namespace weir
