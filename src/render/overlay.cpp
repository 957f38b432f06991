#include "render/overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/ticks.h"
#include "font/font.h"
#include "render/nice_numbers.h"

namespace weir {

namespace {

// Opacity of the panels behind items, of 255, which keeps them legible over fluid.
constexpr int panel_alpha = 190;

bool shows(const Scene& scene, OverlayItem item) {
  return std::find(scene.render.overlay.begin(), scene.render.overlay.end(), item) != scene.render.overlay.end();
}

// The mark repeats what the colour says, for readers who cannot tell the colours apart.
std::string cfl_text(double cfl, bool met) { return fmt::format("CFL {:.3f} {}", cfl, met ? "✓" : "✗"); }

}  // namespace

Overlay::Overlay(const Scene& scene, std::array<double, 2> range)
    : palette_(palette(scene.render.theme)),
      transparent_(scene.render.transparent),
      map_(colormap(scene.render.color.map)),
      font_(font_dejavu_sans()),
      bold_(font_dejavu_sans_bold()) {
  const QuantityFacts& facts = facts_of(scene.render.color.by);
  const DisplayUnit shown = display_unit(typeset(facts.unit), std::max(std::abs(range[0]), std::abs(range[1])));
  range_ = {range[0] * shown.factor, range[1] * shown.factor};
  quantity_ = shown.name.empty() ? std::string(facts.label) : fmt::format("{} ({})", facts.label, shown.name);
  const double duration = std::max(scene.duration, 1e-6);
  time_digits_ = std::max(1, static_cast<int>(std::floor(std::log10(duration))) + 1);
  // A resolution of 1 ms, or of a thousandth of a shorter run.
  time_decimals_ = std::max(3, 3 - static_cast<int>(std::floor(std::log10(duration * 10))));

  OverlayTexts texts;
  const std::string& title = scene.title.empty() ? scene.name : scene.title;
  if (shows(scene, OverlayItem::title) && !title.empty()) texts.title = title;
  if (shows(scene, OverlayItem::time)) texts.time = time_text(0);
  if (shows(scene, OverlayItem::cfl)) texts.cfl = cfl_text(0, false);
  if (shows(scene, OverlayItem::scalebar)) texts.scale = scene.dimension == 3 ? "500 mm at the centre" : "500 mm";
  if (shows(scene, OverlayItem::colorbar)) texts.quantity = quantity_;
  texts.ticks = [this](int most) {
    std::vector<std::string> labels;
    for (const Tick& tick : linear_ticks(range_[0], range_[1], most)) labels.push_back(tick.label);
    return labels;
  };
  layout_ = lay_out(
      scene.render.size[0], scene.render.size[1], texts,
      [this](const std::string& text, int size, bool bold) { return (bold ? bold_ : font_).width(text, size); });
}

std::string Overlay::time_text(double time) const {
  std::string digits = fmt::format("{:.{}f}", time, time_decimals_);
  // Padded with spaces of the width of a digit, so that digits keep their positions.
  const int width = time_digits_ + 1 + time_decimals_;
  std::string padding;
  for (int k = static_cast<int>(digits.size()); k < width; ++k) padding += "\u2007";
  return fmt::format("t = {}{} s", padding, digits);
}

int Overlay::baseline(const IntBox& row) const { return row.bottom - (row.height() * 6 + 12) / 25; }

void Overlay::draw_panel(const IntBox& box, Image& image) const {
  if (transparent_) return;
  const int rim = layout_.size / 4;
  fill(image, {box.left - rim, box.top - rim, box.right + rim, box.bottom + rim}, palette_.background, panel_alpha);
}

void Overlay::draw_fixed(const Projection& projection, Image& image) {
  if (layout_.title) {
    draw_panel(*layout_.title, image);
    draw_text(image, bold_, layout_.title_size, layout_.title->left, baseline(*layout_.title), layout_.title_text,
              palette_.text);
  }
  if (layout_.scale) draw_scale(projection, image);
  if (layout_.colorbar) draw_colorbar(image);
}

void Overlay::draw_changing(const Frame& frame, Image& image) {
  const int size = layout_.size;
  if (layout_.time) {
    draw_panel(*layout_.time, image);
    draw_text(image, font_, size, layout_.time->left, baseline(*layout_.time), time_text(frame.time), palette_.text);
  }
  if (layout_.cfl) {
    draw_panel(*layout_.cfl, image);
    draw_text(image, font_, size, layout_.cfl->left, baseline(*layout_.cfl), cfl_text(frame.cfl, frame.cfl_met),
              frame.cfl_met ? palette_.met : palette_.not_met);
  }
}

std::string Overlay::changing_text(const Frame& frame) const {
  return (layout_.time ? time_text(frame.time) : "") + (layout_.cfl ? cfl_text(frame.cfl, frame.cfl_met) : "");
}

std::vector<IntBox> Overlay::fixed_boxes() const { return with_rims({layout_.title, layout_.scale, layout_.colorbar}); }

std::vector<IntBox> Overlay::changing_boxes() const { return with_rims({layout_.time, layout_.cfl}); }

// Panels extend a quarter of the text size beyond their items, glyphs a pixel beyond their advance.
std::vector<IntBox> Overlay::with_rims(const std::vector<std::optional<IntBox>>& items) const {
  const int rim = layout_.size / 4 + 1;
  std::vector<IntBox> boxes;
  for (const std::optional<IntBox>& item : items)
    if (item) boxes.push_back({item->left - rim, item->top - rim, item->right + rim, item->bottom + rim});
  return boxes;
}

void Overlay::draw_colorbar(Image& image) {
  draw_panel(*layout_.colorbar, image);
  const IntBox& bar = layout_.bar;
  const int line = layout_.line;
  fill(image, {bar.left - line, bar.top - line, bar.right + line, bar.bottom + line}, palette_.text);
  for (int y = bar.top; y < bar.bottom; ++y) {
    const double along = (bar.bottom - 0.5 - y) / bar.height();
    const std::uint32_t color = map_[colormap_index(along, {0, 1})];
    fill(image, {bar.left, y, bar.right, y + 1},
         {static_cast<std::uint8_t>(color >> 16), static_cast<std::uint8_t>(color >> 8),
          static_cast<std::uint8_t>(color)});
  }
  const int mark = static_cast<int>(std::lround(0.35 * layout_.size));
  const int text_left = bar.right + mark + static_cast<int>(std::lround(0.25 * layout_.size));
  const int half_digit = static_cast<int>(std::lround(0.365 * layout_.size));  // half the height of DejaVu's digits
  for (const Tick& tick : linear_ticks(range_[0], range_[1], layout_.most_ticks)) {
    const double along = (tick.value - range_[0]) / (range_[1] - range_[0]);
    const int y = bar.bottom - static_cast<int>(std::lround(along * bar.height()));
    fill(image, {bar.right, y - line / 2, bar.right + mark, y - line / 2 + line}, palette_.text);
    draw_text(image, font_, layout_.size, text_left, y + half_digit, tick.label, palette_.text);
  }
  const int label = font_.width(quantity_, layout_.size);
  const int descent = static_cast<int>(std::lround(0.24 * layout_.size));
  draw_text_upwards(image, font_, layout_.size, layout_.colorbar->right - descent, (bar.top + bar.bottom + label) / 2,
                    quantity_, palette_.text);
}

void Overlay::draw_scale(const Projection& projection, Image& image) {
  const double pixels_per_metre = projection.pixels_per_metre();
  const double length = round_down_125(layout_.largest_scale / pixels_per_metre);
  const int pixels = std::max(1, static_cast<int>(std::lround(length * pixels_per_metre)));
  // In perspective the scale holds at one depth.
  const std::string text = length_text(length) + (projection.perspective ? " at the centre" : "");
  const IntBox& row = *layout_.scale;
  const int gap = static_cast<int>(std::lround(0.5 * layout_.size));
  draw_panel({row.left, row.top, row.left + pixels + gap + font_.width(text, layout_.size), row.bottom}, image);
  const int line = std::max(2, 2 * layout_.line);
  const int middle = baseline(row) - static_cast<int>(std::lround(0.365 * layout_.size));
  const int cap = static_cast<int>(std::lround(0.3 * layout_.size));
  fill(image, {row.left, middle - line / 2, row.left + pixels, middle - line / 2 + line}, palette_.text);
  fill(image, {row.left, middle - cap, row.left + line, middle + cap}, palette_.text);
  fill(image, {row.left + pixels - line, middle - cap, row.left + pixels, middle + cap}, palette_.text);
  draw_text(image, font_, layout_.size, row.left + pixels + gap, baseline(row), text, palette_.text);
}

}  // namespace weir
