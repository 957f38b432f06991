#include "render/disc_painter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "render/assets.h"

namespace weir {

namespace {

void set(GLuint program, const char* name, const Vec3& v) {
  const glm::vec3 f(v);
  glProgramUniform3f(program, glGetUniformLocation(program, name), f.x, f.y, f.z);
}
void set(GLuint program, const char* name, double a, double b) {
  glProgramUniform2f(program, glGetUniformLocation(program, name), static_cast<float>(a), static_cast<float>(b));
}
void set(GLuint program, const char* name, double a) {
  glProgramUniform1f(program, glGetUniformLocation(program, name), static_cast<float>(a));
}
void set(GLuint program, const char* name, bool a) {
  glProgramUniform1i(program, glGetUniformLocation(program, name), a ? 1 : 0);
}

// Half the size of a disc's point or quad beyond its radius, pixels; as in disc.vert.
constexpr double rim = 0.51;

}  // namespace

DiscPainter::Variant DiscPainter::make_variant(const char* defines, GLuint buffer, GLuint step) {
  Variant variant{build_program(std::string(assets::disc_vert()), std::string(assets::disc_frag()), defines), {}};
  const GLuint vertices = variant.vertices.id();
  glVertexArrayVertexBuffer(vertices, 0, buffer, 0, sizeof(glm::vec4));
  glVertexArrayAttribFormat(vertices, 0, 4, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(vertices, 0, 0);
  glVertexArrayBindingDivisor(vertices, 0, step);
  glEnableVertexArrayAttrib(vertices, 0);
  return variant;
}

DiscPainter::DiscPainter(int width, int height)
    : width_(width),
      height_(height),
      points_(make_variant("#define POINTS\n", particles_.id(), 0)),
      quads_(make_variant("", particles_.id(), 1)) {
  std::array<GLfloat, 2> sizes{};
  glGetFloatv(GL_POINT_SIZE_RANGE, sizes.data());
  std::array<GLint, 2> largest_viewport{};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, largest_viewport.data());
  // A point whose centre lies outside the viewport is dropped even if its disc reaches into the picture. So the
  // viewport is larger than the picture by the largest point's half size, as far as the driver allows.
  const int room = (std::min(largest_viewport[0], largest_viewport[1]) - std::max(width, height)) / 2;
  border_ = std::clamp(static_cast<int>(std::ceil(0.5 * std::min(sizes[1], 256.0f))), 0, std::max(room, 0));
  point_limit_ = std::min<double>(sizes[1], 2.0 * border_);
}

DiscColors::DiscColors(const Colormap& map, double opacity) {
  std::array<glm::vec4, 256> colors{};
  for (std::size_t k = 0; k < colors.size(); ++k)
    colors[k] = glm::vec4(static_cast<float>(map[k] >> 16) / 255.0f, static_cast<float>(map[k] >> 8 & 0xff) / 255.0f,
                          static_cast<float>(map[k] & 0xff) / 255.0f, static_cast<float>(opacity));
  glNamedBufferData(buffer_.id(), sizeof(colors), colors.data(), GL_STATIC_DRAW);
}

double DiscPainter::largest_radius(std::span<const glm::vec4> particles, const Projection& projection, double radius) {
  if (!projection.perspective) return projection.focal * radius;
  double nearest = std::numeric_limits<double>::infinity();
  for (const glm::vec4& particle : particles) {
    const double depth = projection.depth(Vec3(particle));
    if (depth > radius) nearest = std::min(nearest, depth);
  }
  return projection.focal * radius / nearest;
}

void DiscPainter::set_uniforms(const Variant& variant, const Projection& projection, const DiscStyle& style) const {
  const GLuint program = variant.program.id();
  set(program, "eye", projection.eye);
  set(program, "right", projection.right);
  set(program, "up", projection.up);
  set(program, "forward", projection.forward);
  set(program, "perspective", projection.perspective);
  set(program, "focal", projection.focal);
  set(program, "principal", projection.principal.x, projection.principal.y);
  set(program, "radius", style.radius);
  set(program, "viewport", width_ + 2.0 * border_, height_ + 2.0 * border_);
  set(program, "border", static_cast<double>(border_));
  set(program, "range", style.range[0], style.range[1]);
  set(program, "shaded", style.shaded);
}

void DiscPainter::draw(std::span<const glm::vec4> particles, const Projection& projection, const DiscStyle& style,
                       const DiscColors& colors) {
  if (particles.empty()) return;
  const bool as_points = 2 * (largest_radius(particles, projection, style.radius) + rim) <= point_limit_;
  const Variant& variant = as_points ? points_ : quads_;
  glNamedBufferData(particles_.id(), static_cast<GLsizeiptr>(particles.size_bytes()), particles.data(), GL_STREAM_DRAW);
  set_uniforms(variant, projection, style);

  glUseProgram(variant.program.id());
  glBindVertexArray(variant.vertices.id());
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, colors.buffer());
  glViewport(-border_, -border_, width_ + 2 * border_, height_ + 2 * border_);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glEnable(GL_BLEND);
  // Colours are blended as they are encoded in sRGB, not as light: so does every program that lays a picture with alpha
  // over a page, hence a transparent picture looks there like one drawn on that background here. The alpha that results
  // is that of "over", and the colour stays multiplied with it until it is read back.
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const auto count = static_cast<GLsizei>(particles.size());
  if (as_points)
    glDrawArrays(GL_POINTS, 0, count);
  else
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
}

void sort_back_to_front(std::vector<glm::vec4>& particles, const Projection& projection) {
  std::vector<std::pair<float, std::uint32_t>> order;
  order.reserve(particles.size());
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const double depth = projection.depth(Vec3(particles[k]));
    if (depth > 0) order.emplace_back(-static_cast<float>(depth), static_cast<std::uint32_t>(k));
  }
  std::sort(order.begin(), order.end());
  std::vector<glm::vec4> sorted;
  sorted.reserve(order.size());
  for (const auto& [depth, index] : order) sorted.push_back(particles[index]);
  particles = std::move(sorted);
}

}  // namespace weir
