// Title, time, colour bar, scale bar and CFL indicator, drawn by the processor: the same pixels whichever device draws
// the particles. On a clear picture they become a layer to be laid over others.
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

  // What an automatic view leaves free for the overlay lies outside of this.
  const PixelBox& content() const { return layout_.content; }
  const OverlayLayout& layout() const { return layout_; }

  // What is the same for all frames of one view.
  void draw_fixed(const Projection& projection, Image& image);
  // What each frame says anew: time and CFL indicator.
  void draw_changing(const Frame& frame, Image& image);
  // The texts of the latter: while they stay, so does what it draws.
  std::string changing_text(const Frame& frame) const;

  // All pixels that the items may touch.
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
  std::array<double, 2> range_;  // in the unit shown
  std::string quantity_;
  int time_digits_;    // before the point
  int time_decimals_;  // behind it
  Font font_;
  Font bold_;
  OverlayLayout layout_;
};

}  // namespace weir
