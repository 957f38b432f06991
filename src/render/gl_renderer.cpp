#include "render/gl_renderer.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "core/error.h"
#include "render/palette.h"
#include "render/wall_view.h"

namespace weir {

namespace {

// Images that are drawn, queued and encoded at the same time, with some reserve.
constexpr std::size_t most_known = 8;

// Walls in 3D are paler than the fluid, which is drawn over them.
constexpr double deep_wall_opacity = 0.5;

std::uint32_t packed(Rgb color, std::uint32_t alpha) {
  return alpha << 24 | static_cast<std::uint32_t>(color.b) << 16 | static_cast<std::uint32_t>(color.g) << 8 | color.r;
}

Colormap only(std::uint32_t color) {
  Colormap map;
  map.fill(color);
  return map;
}

int round_up(int value, int unit) { return (value + unit - 1) / unit * unit; }

// The boxes, extended to whole blocks, within a picture of whole blocks.
std::vector<IntBox> on_blocks(const std::vector<IntBox>& boxes, int width, int height) {
  std::vector<IntBox> grown;
  for (const IntBox& box : boxes) {
    // One block more to the right: its chroma samples the pixel to its left.
    const IntBox whole{
        std::max(box.left, 0) / block_width * block_width, std::max(box.top, 0) / block_height * block_height,
        std::min(round_up(box.right + 1, block_width), width), std::min(round_up(box.bottom, block_height), height)};
    if (whole.width() > 0 && whole.height() > 0) grown.push_back(whole);
  }
  return grown;
}

void clear(Image& image, const IntBox& box) {
  for (int y = box.top; y < box.bottom; ++y) std::fill_n(image.pixel(box.left, y), 4 * box.width(), std::uint8_t{0});
}

}  // namespace

GlRenderer::Drawing::Drawing(int width, int height, bool transparent, int threads)
    : particles(width, height, threads), background(width, height), walls(width, height) {
  if (transparent) movie_background.emplace(width, height);
}

GlRenderer::GlRenderer(const Scene& scene, const StaticScene& static_scene, const DeviceChoice& choice, int threads)
    : scene_(scene),
      walls_(static_scene.walls),
      width_(scene.render.size[0]),
      height_(scene.render.size[1]),
      palette_(palette(scene.render.theme)),
      transparent_(scene.render.transparent),
      fluid_style_{0.5 * static_scene.particle_spacing, color_range(scene, static_scene),
                   colormap(scene.render.color.map), 1},
      wall_style_{0.5 * static_scene.particle_spacing, {0, 1}, only(wall_color), 1},
      overlay_(scene, color_range(scene, static_scene)),
      camera_(scene, static_scene, overlay_.content()),
      context_(EglContext::open(choice)),
      composes_(choice.movie_by == MovieBy::fitting ? context_->is_processor()
                                                    : choice.movie_by == MovieBy::processor) {
  if (scene.dimension == 3) wall_style_.opacity = deep_wall_opacity;
  const int padded = round_up(width_, block_width);
  fixed_ = on_blocks(overlay_.fixed_boxes(), padded, height_);
  changing_ = on_blocks(overlay_.changing_boxes(), padded, height_);
  boxes_ = fixed_;
  boxes_.insert(boxes_.end(), changing_.begin(), changing_.end());
  drawing_.emplace(width_, height_, transparent_ && !composes_, threads);
  layer_ = {padded, height_, std::vector<std::uint8_t>(std::size_t{4} * padded * height_)};
}

GlRenderer::~GlRenderer() {
  try {
    context_->make_current();
  } catch (const std::exception&) {
    // The context is lost, with its objects.
  }
}

void GlRenderer::see(const Frame& frame) {
  const Projection projection = camera_.at(frame.time);
  if (view_ == 0 || projection_ != projection) {
    ++view_;
    projection_ = projection;
    for (const IntBox& box : fixed_) clear(layer_, box);
    overlay_.draw_fixed(projection_, layer_);
    texts_number_ = 0;  // boxes may overlap
  }
  const std::string texts = overlay_.changing_text(frame);
  if (texts_number_ == 0 || texts_ != texts) {
    ++texts_number_;
    texts_ = texts;
    draw_changing_texts(frame);
  }
  if (particles_number_ == 0 || particles_ != frame.particles) {
    ++particles_number_;
    particles_ = frame.particles;
  }
}

void GlRenderer::draw_changing_texts(const Frame& frame) {
  for (const IntBox& box : changing_) clear(layer_, box);
  overlay_.draw_changing(frame, layer_);
}

void GlRenderer::draw_walls(bool opaque, Backdrop& below) {
  std::vector<glm::vec4> seen;
  if (scene_.render.walls)
    for (const glm::vec3& wall : walls_)
      if (!projection_.perspective || !hides_inside(scene_, Vec3(wall), projection_.eye)) seen.emplace_back(wall, 0.0f);
  std::vector<std::uint8_t> stale;
  drawing_->particles.arrange(seen, projection_, wall_style_, stale);
  arranged_ = -1;
  below.fill(opaque ? packed(palette_.background, 255) : packed(Rgb{}, 0));
  drawing_->particles.draw(drawing_->walls.framebuffer(), PixelsFor::backdrop, below);
}

const Backdrop& GlRenderer::drawn(Background& background, bool opaque) {
  if (background.view != view_) {
    draw_walls(opaque, background.backdrop);
    background.backdrop.take(drawing_->walls);
    background.view = view_;
  }
  return background.backdrop;
}

GlRenderer::Changes GlRenderer::bring_up(Shown& shown, const ParticlePixels::RowTaken& arranged) {
  const bool view = shown.view != view_;
  const Changes changes{view, view || shown.particles != particles_number_, view || shown.texts != texts_number_};
  if (changes.view) shown.stale.clear();
  if (changes.particles)
    drawing_->particles.arrange(particles_, projection_, fluid_style_, shown.stale, arranged);
  else if (changes.texts && arranged_ != particles_number_)
    drawing_->particles.arrange(particles_, projection_, fluid_style_, shown.stale);
  if (changes.particles || changes.texts) arranged_ = particles_number_;
  shown.view = view_;
  shown.particles = particles_number_;
  shown.texts = texts_number_;
  return changes;
}

template <class Target>
void GlRenderer::draw_on(Sheet<Target>& sheet, PixelsFor use) {
  const bool apart = use == PixelsFor::movie && drawing_->movie_background;
  const Backdrop& background =
      drawn(apart ? *drawing_->movie_background : drawing_->background, apart || !transparent_);
  const Changes changes = bring_up(sheet.shown);
  if (changes.texts)
    for (const IntBox& box : changes.view ? boxes_ : changing_) sheet.layer.upload(layer_, box);
  const GLuint target = sheet.target.framebuffer();
  if (changes.particles) drawing_->particles.draw(target, use, background);
  if (changes.particles || changes.texts)
    drawing_->particles.draw(target, use, background, sheet.layer, changes.particles ? boxes_ : changing_);
}

void GlRenderer::compose(Composed& movie, Shown& shown, MovieImage& image) {
  if (movie.background_view != view_) {
    drawing_->background.view = -1;  // borrowed
    draw_walls(true, drawing_->background.backdrop);
    drawing_->walls.read(movie.background);
    movie.background_view = view_;
  }
  const ParticlePainter& particles = drawing_->particles;
  const auto layers = [&] { return MovieLayers{movie.background, particles.squares(), particles.texels(), layer_}; };
  const Changes changes = bring_up(shown, [&](int row) { movie.pixels.draw(layers(), row, image); });
  if (changes.texts && !changes.view) movie.pixels.draw(layers(), changing_, image);
}

void GlRenderer::draw(const Frame& frame, Image& image) {
  context_->make_current();
  see(frame);
  if (!drawing_->picture) drawing_->picture.emplace(width_, height_);
  draw_on(*drawing_->picture, PixelsFor::picture);
  drawing_->picture->target.read(image);
  check_drawn();
}

void GlRenderer::start(const Frame& frame) {
  if (under_way_.size() == most_under_way()) throw DeviceError("more pictures begun than can be under way");
  context_->make_current();
  see(frame);
  // The same sheet again if it is free.
  const std::size_t sheet = under_way_.empty() ? 0 : 1 - under_way_.front();
  if (!composes_) {
    if (sheet == drawing_->movie.size()) drawing_->movie.emplace_back(width_, height_);
    draw_on(drawing_->movie[sheet], PixelsFor::movie);
    glFlush();  // starts the device
  }
  under_way_.push_back(sheet);
}

void GlRenderer::finish(MovieImage& image) {
  if (under_way_.empty()) throw DeviceError("no picture has been begun");
  context_->make_current();
  if (composes_) {
    compose(image);
  } else {
    drawing_->movie[under_way_.front()].target.read(image);
    image.known_as = 0;
  }
  check_drawn();
  under_way_.pop_front();
}

void GlRenderer::compose(MovieImage& image) {
  if (!drawing_->composed) drawing_->composed.emplace(width_, height_, boxes_);
  std::map<std::int64_t, Shown>& shown = drawing_->composed->shown;
  image.resize(width_, height_);
  auto known = shown.extract(image.known_as);
  if (known.empty()) {
    if (shown.size() == most_known) shown.erase(shown.begin());
    known = std::map<std::int64_t, Shown>{{0, {}}}.extract(0);
  }
  image.known_as = 0;  // undefined until it is drawn
  compose(*drawing_->composed, known.mapped(), image);
  static std::atomic<std::int64_t> last{0};  // of all renderers: an image may be passed between them
  known.key() = image.known_as = ++last;
  shown.insert(std::move(known));
}

}  // namespace weir
