#include "render/gl_renderer.h"

#include <algorithm>
#include <cmath>

#include "render/palette.h"

namespace weir {

namespace {

// In 3D walls would hide the fluid: small dots, nearly clear, behind it.
constexpr double deep_wall_size = 0.35;  // of the particle's radius
constexpr double deep_wall_opacity = 0.35;

bool finite(const glm::vec4& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

// Undoes the multiplication of colours with alpha.
void straighten(std::vector<std::uint8_t>& rgba) {
  for (std::size_t k = 0; k < rgba.size(); k += 4) {
    const int alpha = rgba[k + 3];
    if (alpha == 0 || alpha == 255) continue;
    for (std::size_t c = k; c < k + 3; ++c)
      rgba[c] = static_cast<std::uint8_t>(std::min(255, (rgba[c] * 255 + alpha / 2) / alpha));
  }
}

Colormap only(std::uint32_t color) {
  Colormap map;
  map.fill(color);
  return map;
}

}  // namespace

GlRenderer::Drawing::Drawing(int width, int height, const Coloring& color, bool deep)
    : discs(width, height),
      fluid(colormap(color.map), 1),
      walls(only(wall_color), deep ? deep_wall_opacity : 1),
      background(width, height),
      picture(width, height) {}

GlRenderer::GlRenderer(const Scene& scene, const StillLife& still_life, const DeviceChoice& choice)
    : width_(scene.render.size[0]),
      height_(scene.render.size[1]),
      deep_(scene.dimension == 3),
      theme_(scene.render.theme),
      transparent_(scene.render.transparent),
      fluid_style_{0.5 * still_life.particle_spacing, color_range(scene, still_life), deep_},
      wall_style_{0.5 * still_life.particle_spacing * (deep_ ? deep_wall_size : 1.0), {0, 1}, false},
      overlay_(scene, color_range(scene, still_life)),
      camera_(scene, still_life, overlay_.content()),
      context_(EglContext::open(choice)) {
  if (scene.render.walls)
    for (const glm::vec3& wall : still_life.walls)
      if (finite(glm::vec4(wall, 0))) walls_.emplace_back(wall, 0.0f);
  drawing_.emplace(width_, height_, scene.render.color, deep_);
}

GlRenderer::~GlRenderer() {
  try {
    context_->make_current();
  } catch (const std::exception&) {
    // Then the context is lost, and its objects with it.
  }
}

void GlRenderer::draw_background(const Projection& projection) {
  glBindFramebuffer(GL_FRAMEBUFFER, drawing_->background.framebuffer());
  const Rgb color = palette(theme_).background;
  if (transparent_)
    glClearColor(0, 0, 0, 0);
  else
    glClearColor(color.r / 255.0f, color.g / 255.0f, color.b / 255.0f, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  drawing_->discs.draw(walls_, projection, wall_style_, drawing_->walls);
  background_view_ = projection;
}

std::span<const glm::vec4> GlRenderer::drawable(const std::vector<glm::vec4>& particles, const Projection& projection) {
  if (!deep_ && std::all_of(particles.begin(), particles.end(), finite)) return particles;
  kept_.clear();
  std::copy_if(particles.begin(), particles.end(), std::back_inserter(kept_), finite);
  if (deep_) sort_back_to_front(kept_, projection);
  return kept_;
}

void GlRenderer::draw(const Frame& frame, Image& image) {
  context_->make_current();
  const Projection projection = camera_.at(frame.time);
  if (background_view_ != projection) draw_background(projection);
  const GLuint picture = drawing_->picture.framebuffer();
  glBlitNamedFramebuffer(drawing_->background.framebuffer(), picture, 0, 0, width_, height_, 0, 0, width_, height_,
                         GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, picture);
  drawing_->discs.draw(drawable(frame.particles, projection), projection, fluid_style_, drawing_->fluid);
  read_back(image);
  overlay_.draw(frame, projection, image);
}

void GlRenderer::read_back(Image& image) const {
  image.width = width_;
  image.height = height_;
  image.rgba.resize(std::size_t{4} * width_ * height_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawing_->picture.framebuffer());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  check_drawn();
  if (transparent_) straighten(image.rgba);
}

}  // namespace weir
