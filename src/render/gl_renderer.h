// The renderer behind renderer.h.
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/block_target.h"
#include "render/camera.h"
#include "render/egl_context.h"
#include "render/overlay.h"
#include "render/particle_painter.h"
#include "render/renderer.h"

namespace weir {

class GlRenderer final : public Renderer {
 public:
  GlRenderer(const Scene& scene, const StillLife& still_life, const DeviceChoice& choice, int threads);
  ~GlRenderer() override;

  void draw(const Frame& frame, Image& image) override;
  void start(const Frame& frame) override;
  void finish(MovieImage& image) override;
  const std::string& gl_renderer() const override { return context_->gl_renderer(); }

 private:
  // A target, and what it shows.
  template <class Target>
  struct Sheet {
    Sheet(int width, int height) : target(width, height), layer(width, height) { layer.clear(); }
    Target target;
    ColorTarget layer;       // the overlay; one each, so that the next picture's need not wait for the last to be drawn
    std::int64_t view = -1;  // numbers of what is shown, see below
    std::int64_t particles = -1;
    std::int64_t texts = -1;
    std::vector<std::uint8_t> stale;  // squares that show more than the background
  };

  // Everything that lives in the context, so that it can go before the context does.
  struct Drawing {
    Drawing(int width, int height, bool transparent, int threads);
    ParticlePainter particles;
    Backdrop background;                        // colour and walls: drawn once for each view
    std::optional<Backdrop> movie_background;   // where that is transparent: a movie's
    ColorTarget walls;                          // on the way there
    std::optional<Sheet<ColorTarget>> picture;  // made when first asked for
    std::vector<Sheet<MovieTarget>> movie;      // one, or two if one is begun before the last is read
  };

  // Brings what is to be shown up to the frame, with its numbers.
  void see(const Frame& frame);
  void draw_background();
  void draw_walls(std::uint32_t color, Backdrop& background);
  void draw_changing_texts(const Frame& frame);
  template <class Target>
  void draw_on(Sheet<Target>& sheet, PixelsFor use);

  Scene scene_;
  std::vector<glm::vec3> walls_;
  int width_;
  int height_;
  Palette palette_;
  bool transparent_;
  ParticleStyle fluid_style_;
  ParticleStyle wall_style_;
  Overlay overlay_;
  CameraPath camera_;
  std::unique_ptr<EglContext> context_;
  std::optional<Drawing> drawing_;

  // What is to be shown, each with a number that grows when it changes.
  Projection projection_;
  std::int64_t view_ = 0;
  std::vector<glm::vec4> particles_;
  std::int64_t particles_number_ = 0;
  std::string texts_;
  std::int64_t texts_number_ = 0;
  Image layer_;                // the overlay, as wide as whole blocks
  std::vector<IntBox> fixed_;  // boxes of the overlay, between blocks
  std::vector<IntBox> changing_;
  std::vector<IntBox> boxes_;  // both

  std::deque<std::size_t> under_way_;  // movie sheets, begun and not yet read
  std::int64_t arranged_ = -1;         // number of the particles that the painter shows
};

}  // namespace weir
