// The renderer behind renderer.h.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/camera.h"
#include "render/disc_painter.h"
#include "render/egl_context.h"
#include "render/gl_objects.h"
#include "render/overlay.h"
#include "render/renderer.h"

namespace weir {

class GlRenderer final : public Renderer {
 public:
  GlRenderer(const Scene& scene, const StillLife& still_life, const DeviceChoice& choice);
  ~GlRenderer() override;

  void draw(const Frame& frame, Image& image) override;
  const std::string& gl_renderer() const override { return context_->gl_renderer(); }

 private:
  // Everything that lives in the context, so that it can go before the context does.
  struct Drawing {
    Drawing(int width, int height, const Coloring& color, bool deep);
    DiscPainter discs;
    DiscColors fluid;
    DiscColors walls;
    RenderTarget background;  // what does not move: drawn once for each view
    RenderTarget picture;
  };

  void draw_background(const Projection& projection);
  std::span<const glm::vec4> drawable(const std::vector<glm::vec4>& particles, const Projection& projection);
  void read_back(Image& image) const;

  int width_;
  int height_;
  bool deep_;  // 3D
  Theme theme_;
  bool transparent_;
  DiscStyle fluid_style_;
  DiscStyle wall_style_;
  std::vector<glm::vec4> walls_;
  Overlay overlay_;
  CameraPath camera_;
  std::unique_ptr<EglContext> context_;
  std::optional<Drawing> drawing_;
  std::optional<Projection> background_view_;  // of what `background` shows
  std::vector<glm::vec4> kept_;
};

}  // namespace weir
