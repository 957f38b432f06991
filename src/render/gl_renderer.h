// The renderer behind renderer.h.
#pragma once

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/block_target.h"
#include "render/camera.h"
#include "render/egl_context.h"
#include "render/movie_pixels.h"
#include "render/overlay.h"
#include "render/particle_painter.h"
#include "render/renderer.h"

namespace weir {

class GlRenderer final : public Renderer {
 public:
  GlRenderer(const Scene& scene, const StaticScene& static_scene, const DeviceChoice& choice, int threads);
  ~GlRenderer() override;

  void draw(const Frame& frame, Image& image) override;
  std::size_t most_under_way() const override { return composes_ ? 1 : 2; }
  void start(const Frame& frame) override;
  void finish(MovieImage& image) override;
  const std::string& gl_renderer() const override { return context_->gl_renderer(); }

 private:
  // What a picture shows.
  struct Shown {
    std::int64_t view = -1;  // numbers, see below
    std::int64_t particles = -1;
    std::int64_t texts = -1;
    std::vector<std::uint8_t> stale;  // squares that show more than the background
  };
  // What of that is no longer what is to be shown. A view changes everything.
  struct Changes {
    bool view;
    bool particles;
    bool texts;
  };

  // A target, and what it shows.
  template <class Target>
  struct Sheet {
    Sheet(int width, int height) : target(width, height), layer(width, height) { layer.clear(); }
    Target target;
    ColorTarget layer;  // the overlay; one each, so that the next picture's need not wait for the last to be drawn
    Shown shown;
  };
  // Colour and walls: drawn once for each view.
  struct Background {
    Background(int width, int height) : backdrop(width, height) {}
    Backdrop backdrop;
    std::int64_t view = -1;
  };
  // Of a movie's pictures that the processor composes.
  struct Composed {
    Composed(int width, int height, std::span<const IntBox> text_boxes) : pixels(width, height, text_boxes) {}
    MoviePixels pixels;
    std::vector<Texel> background;  // as MovieLayers has it
    std::int64_t background_view = -1;
    std::map<std::int64_t, Shown> shown;  // what the last images show, by MovieImage::known_as
  };

  // Everything that lives in the context, so that it can go before the context does.
  struct Drawing {
    Drawing(int width, int height, bool transparent, int threads);
    ParticlePainter particles;
    Background background;
    std::optional<Background> movie_background;  // where that is transparent: a movie's
    ColorTarget walls;                           // on the way there
    // Made when first asked for.
    std::optional<Sheet<ColorTarget>> picture;
    std::vector<Sheet<MovieTarget>> movie;  // one, or two if one is begun before the last is read
    std::optional<Composed> composed;
  };

  // Brings what is to be shown up to the frame, with its numbers.
  void see(const Frame& frame);
  void draw_changing_texts(const Frame& frame);
  void draw_walls(bool opaque, Backdrop& below);  // into the target of walls
  const Backdrop& drawn(Background& background, bool opaque);
  // Arranges particles for it if need be, and counts it as showing all that is to be shown.
  // If particles are to be drawn, says what rows are arranged.
  Changes bring_up(
      Shown& shown, const ParticlePixels::RowTaken& arranged = [](int) {});
  template <class Target>
  void draw_on(Sheet<Target>& sheet, PixelsFor use);
  void compose(MovieImage& image);
  void compose(Composed& movie, Shown& shown, MovieImage& image);

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
  bool composes_;  // the processor puts a movie's pictures together
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
