// Implementation of the interface renderer.h.
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
  // Versions of the parts of a drawn picture.
  struct Shown {
    std::int64_t view = -1;  // numbers, see below
    std::int64_t particles = -1;
    std::int64_t texts = -1;
    std::vector<std::uint8_t> stale;  // squares with more than the background
  };
  // Parts that differ from the current versions. A change of view changes everything.
  struct Changes {
    bool view;
    bool particles;
    bool texts;
  };

  // A target and the versions drawn in it.
  template <class Target>
  struct Sheet {
    Sheet(int width, int height) : target(width, height), layer(width, height) { layer.clear(); }
    Target target;
    ColorTarget layer;  // the overlay, one per target: the next picture does not wait for the last
    Shown shown;
  };
  // Background colour and walls, drawn once per view.
  struct Background {
    Background(int width, int height) : backdrop(width, height) {}
    Backdrop backdrop;
    std::int64_t view = -1;
  };
  // State of movie frames that the processor composes.
  struct Composed {
    Composed(int width, int height, std::span<const IntBox> text_boxes) : pixels(width, height, text_boxes) {}
    MoviePixels pixels;
    std::vector<Texel> background;  // see MovieLayers
    std::int64_t background_view = -1;
    std::map<std::int64_t, Shown> shown;  // versions in the last images, by MovieImage::known_as
  };

  // Objects of the context, destroyed before it.
  struct Drawing {
    Drawing(int width, int height, bool transparent, int threads);
    ParticlePainter particles;
    Background background;
    std::optional<Background> movie_background;  // of movies, if the scene's is transparent
    ColorTarget walls;                           // intermediate target
    // Created at first use.
    std::optional<Sheet<ColorTarget>> picture;
    std::vector<Sheet<MovieTarget>> movie;  // two if a frame is started before the last is read, else one
    std::optional<Composed> composed;
  };

  // Updates the current versions to the frame.
  void see(const Frame& frame);
  void draw_changing_texts(const Frame& frame);
  void draw_walls(bool opaque, Backdrop& below);  // into the target of walls
  const Backdrop& drawn(Background& background, bool opaque);
  // Rasterises particles for the target if necessary, and sets its versions to the current ones.
  // `arranged` is called for each finished row of screen tiles, if particles are drawn.
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
  bool composes_;  // the processor composes movie frames
  std::optional<Drawing> drawing_;

  // Current parts of the picture, each with a version number.
  Projection projection_;
  std::int64_t view_ = 0;
  std::vector<glm::vec4> particles_;
  std::int64_t particles_number_ = 0;
  std::string texts_;
  std::int64_t texts_number_ = 0;
  Image layer_;                // the overlay, padded to whole blocks
  std::vector<IntBox> fixed_;  // boxes of the overlay, on block boundaries
  std::vector<IntBox> changing_;
  std::vector<IntBox> boxes_;  // both

  std::deque<std::size_t> under_way_;  // movie sheets, started and not yet read
  std::int64_t arranged_ = -1;         // version of the particles in the painter
};

}  // namespace weir
