#include "render/gl_renderer.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "render/palette.h"
#include "render/wall_view.h"

namespace weir {

namespace {

constexpr std::size_t movie_sheets = 2;

// Walls in 3D are paler than the fluid, which is drawn over them wherever it is.
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

// The boxes, grown to whole blocks, within a picture of whole blocks.
std::vector<IntBox> on_blocks(const std::vector<IntBox>& boxes, int width, int height) {
  std::vector<IntBox> grown;
  for (const IntBox& box : boxes) {
    // One block more to the right: its chroma takes from the pixel to its left.
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

GlRenderer::GlRenderer(const Scene& scene, const StillLife& still_life, const DeviceChoice& choice, int threads)
    : scene_(scene),
      walls_(still_life.walls),
      width_(scene.render.size[0]),
      height_(scene.render.size[1]),
      palette_(palette(scene.render.theme)),
      transparent_(scene.render.transparent),
      fluid_style_{0.5 * still_life.particle_spacing, color_range(scene, still_life), colormap(scene.render.color.map),
                   1},
      wall_style_{0.5 * still_life.particle_spacing, {0, 1}, only(wall_color), 1},
      overlay_(scene, color_range(scene, still_life)),
      camera_(scene, still_life, overlay_.content()),
      context_(EglContext::open(choice)) {
  if (scene.dimension == 3) wall_style_.opacity = deep_wall_opacity;
  const int padded = round_up(width_, block_width);
  fixed_ = on_blocks(overlay_.fixed_boxes(), padded, height_);
  changing_ = on_blocks(overlay_.changing_boxes(), padded, height_);
  boxes_ = fixed_;
  boxes_.insert(boxes_.end(), changing_.begin(), changing_.end());
  drawing_.emplace(width_, height_, transparent_, threads);
  layer_ = {padded, height_, std::vector<std::uint8_t>(std::size_t{4} * padded * height_)};
}

GlRenderer::~GlRenderer() {
  try {
    context_->make_current();
  } catch (const std::exception&) {
    // Then the context is lost, and its objects with it.
  }
}

void GlRenderer::see(const Frame& frame) {
  const Projection projection = camera_.at(frame.time);
  if (view_ == 0 || projection_ != projection) {
    ++view_;
    projection_ = projection;
    draw_background();
    for (const IntBox& box : fixed_) clear(layer_, box);
    overlay_.draw_fixed(projection_, layer_);
    texts_number_ = 0;  // one box may reach into another
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

void GlRenderer::draw_background() {
  std::vector<glm::vec4> seen;
  if (scene_.render.walls)
    for (const glm::vec3& wall : walls_)
      if (!projection_.perspective || !hides_inside(scene_, Vec3(wall), projection_.eye)) seen.emplace_back(wall, 0.0f);
  std::vector<std::uint8_t> stale;
  drawing_->particles.arrange(seen, projection_, wall_style_, stale);
  const std::uint32_t opaque = packed(palette_.background, 255);
  draw_walls(transparent_ ? packed(Rgb{}, 0) : opaque, drawing_->background);
  if (drawing_->movie_background) draw_walls(opaque, *drawing_->movie_background);
  arranged_ = -1;
}

void GlRenderer::draw_walls(std::uint32_t color, Backdrop& background) {
  background.fill(color);
  drawing_->particles.draw(drawing_->walls.framebuffer(), PixelsFor::backdrop, background);
  background.take(drawing_->walls);
}

void GlRenderer::draw_changing_texts(const Frame& frame) {
  for (const IntBox& box : changing_) clear(layer_, box);
  overlay_.draw_changing(frame, layer_);
}

template <class Target>
void GlRenderer::draw_on(Sheet<Target>& sheet, PixelsFor use) {
  const bool same_view = sheet.view == view_;
  const bool same_particles = same_view && sheet.particles == particles_number_;
  const bool same_texts = same_view && sheet.texts == texts_number_;
  if (same_particles && same_texts) return;
  if (!same_view) sheet.stale.clear();
  if (!same_particles || arranged_ != particles_number_) {
    drawing_->particles.arrange(particles_, projection_, fluid_style_, sheet.stale);
    arranged_ = particles_number_;
  }
  if (!same_texts)
    for (const IntBox& box : same_view ? changing_ : boxes_) sheet.layer.upload(layer_, box);
  const GLuint target = sheet.target.framebuffer();
  const bool opaque = use == PixelsFor::movie && drawing_->movie_background;
  const Backdrop& background = opaque ? *drawing_->movie_background : drawing_->background;
  if (!same_particles) drawing_->particles.draw(target, use, background);
  drawing_->particles.draw(target, use, background, sheet.layer, same_particles ? changing_ : boxes_);
  sheet.view = view_;
  sheet.particles = particles_number_;
  sheet.texts = texts_number_;
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
  if (under_way_.size() == movie_sheets) throw DeviceError("more pictures begun than can be under way");
  context_->make_current();
  see(frame);
  // The same one again if that is free: its memory is in the caches, where the processor is the device.
  const std::size_t sheet = under_way_.empty() ? 0 : 1 - under_way_.front();
  if (sheet == drawing_->movie.size()) drawing_->movie.emplace_back(width_, height_);
  draw_on(drawing_->movie[sheet], PixelsFor::movie);
  glFlush();  // the device may begin
  under_way_.push_back(sheet);
}

void GlRenderer::finish(MovieImage& image) {
  if (under_way_.empty()) throw DeviceError("no picture has been begun");
  context_->make_current();
  drawing_->movie[under_way_.front()].target.read(image);
  check_drawn();
  under_way_.pop_front();
}

}  // namespace weir
