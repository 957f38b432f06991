// Title, time, colour bar, scale bar and CFL indicator, drawn over a finished picture by the processor: the same pixels
// whichever device draws the particles.
#pragma once

#include <array>
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

  void draw(const Frame& frame, const Projection& projection, Image& image);

 private:
  std::string time_text(double time) const;
  int baseline(const IntBox& row) const;
  void draw_panel(const IntBox& box, Image& image) const;
  void draw_colorbar(Image& image);
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
