// Title, time, colour bar, scale bar and CFL indicator, drawn by the processor, with the same pixels for every device.
// Drawn on a transparent picture they form a layer.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "frame/image.h"
#include "render/canvas.h"
#include "render/colormap.h"
#include "render/font.h"
#include "render/overlay_layout.h"
#include "render/palette.h"
#include "render/projection.h"
#include "scene/scene.h"

namespace weir {

class Overlay {
 public:
  Overlay(const Scene& scene, std::array<double, 2> range);

  // The part of the picture that an automatic view fills.
  const PixelBox& content() const { return layout_.content; }
  const OverlayLayout& layout() const { return layout_; }

  // Draws the items that are the same for all frames of one view.
  void draw_fixed(const Projection& projection, Image& image);
  // Draws time and CFL indicator.
  void draw_changing(const Frame& frame, Image& image);
  // Texts of draw_changing(), which determine its pixels.
  std::string changing_text(const Frame& frame) const;

  // Boxes around all pixels of the items.
  std::vector<IntBox> fixed_boxes() const;
  std::vector<IntBox> changing_boxes() const;

 private:
  std::string time_text(double time) const;
  int baseline(const IntBox& row) const;
  void draw_panel(const IntBox& box, Image& image) const;
  void draw_colorbar(Image& image);
  std::vector<IntBox> with_rims(const std::vector<std::optional<IntBox>>& items) const;
  void draw_scale(const Projection& projection, Image& image);

  Palette palette_;
  bool transparent_;
  Colormap map_;
  std::array<double, 2> range_;  // in the displayed unit
  std::string quantity_;
  int time_digits_;    // before the decimal point
  int time_decimals_;  // after it
  Font font_;
  Font bold_;
  OverlayLayout layout_;
};

}  // namespace weir
