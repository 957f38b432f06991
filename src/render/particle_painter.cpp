#include "render/particle_painter.h"

#include <algorithm>

#include "render/assets.h"
#include "render/unroll.h"

namespace weir {

namespace {

void set(GLuint program, const char* name, int a) {
  glProgramUniform1i(program, glGetUniformLocation(program, name), a);
}

}  // namespace

ParticlePainter::ParticlePainter(int width, int height, int threads)
    : squares_(width, height),
      discs_(width, height),
      dots_(width, height),
      balls_(width, height, thread_count(threads)),
      texels_(GL_RGBA32UI),
      first_texels_(GL_R32UI),
      to_draw_(GL_R32UI) {}

ParticlePixels& ParticlePainter::pixels_of(std::span<const glm::vec4> particles, const Projection& projection,
                                           const ParticleStyle& style) {
  if (projection.perspective) {
    balls_.show(particles, projection, {style.radius, style.range}, style.colors);
    return balls_;
  }
  const double radius = projection.focal * style.radius;
  const auto meters = static_cast<float>(projection.focal);
  // Multiplied with a quantity less the lower end of the range: its place in the map.
  const auto steps = static_cast<float>(255 / (style.range[1] - style.range[0]));
  const glm::vec4 scale(meters, -meters, 0, steps);
  const glm::vec4 offset(projection.principal.x - projection.focal * projection.eye.x,
                         projection.principal.y + projection.focal * projection.eye.y, 0, -style.range[0] * steps);
  if (radius < largest_dot) {
    dots_.add(particles, scale, offset, radius, style.colors);
    return dots_;
  }
  discs_.show(particles, scale, offset, radius, style.colors);
  return discs_;
}

void ParticlePainter::arrange(std::span<const glm::vec4> particles, const Projection& projection,
                              const ParticleStyle& style, std::vector<std::uint8_t>& stale,
                              const ParticlePixels::RowTaken& arranged) {
  ParticlePixels& pixels = pixels_of(particles, projection, style);
  squares_.begin();
  pixels.mark(squares_);
  const std::size_t texels = squares_.close(stale);
  first_texels_.write(squares_.first_texels());
  to_draw_.write(squares_.to_draw());
  arranged_texels_ = static_cast<Texel*>(texels_.begin(texels * sizeof(Texel)));
  std::fill_n(arranged_texels_, square_texels, Texel{});  // where the texels of squares without pixels are
  pixels.take(squares_, style.opacity, arranged_texels_, arranged);
}

const GlProgram& ParticlePainter::program(bool movie, bool overlay) {
  std::string defines;
  if (movie) defines += "#define YUV\n";
  if (overlay) defines += "#define OVERLAY\n";
  const auto found = programs_.find(defines);
  if (found != programs_.end()) return found->second;
  const int columns = movie ? 5 : 4;  // as in compose.frag
  const std::string fragment =
      unrolled(std::string(assets::compose_frag()), {{"columns", columns}, {"count", 2 * columns}});
  GlProgram made = build_program(std::string(assets::compose_vert()), fragment, defines);
  int unit = 0;
  for (const char* name : {"first_texels", "particle_texels", "particle_pixels", "under_texels", "under_pixels",
                           "squares", "over_even", "over_odd"})
    set(made.id(), name, unit++);
  return programs_.emplace(defines, std::move(made)).first->second;
}

void ParticlePainter::prepare(GLuint framebuffer, PixelsFor use, const Backdrop& background, bool overlay) {
  const GLuint id = program(use == PixelsFor::movie, overlay).id();
  set(id, "straight", use == PixelsFor::picture ? 1 : 0);
  set(id, "square_columns", squares_.columns());
  set(id, "under_columns", background.columns());
  glUseProgram(id);
  glBindTextureUnit(0, first_texels_.texture());
  glBindTextureUnit(1, texels_.texture());
  glBindTextureUnit(2, texels_.single());
  glBindTextureUnit(3, background.texels());
  glBindTextureUnit(4, background.pixels());
  glBindTextureUnit(5, to_draw_.texture());
  // Whole squares, or the middle of one at the edge would be outside, and a point there is not drawn.
  const int columns = squares_.columns() * square_blocks;
  const int rows = squares_.rows() * square_blocks;
  glProgramUniform2i(id, glGetUniformLocation(id, "blocks"), columns, rows);
  set(id, "square_size", square_blocks);
  glBindVertexArray(no_vertices_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, columns, rows);
}

void ParticlePainter::draw(GLuint framebuffer, PixelsFor use, const Backdrop& background) {
  prepare(framebuffer, use, background, false);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(squares_.to_draw().size()));
  drawn();
}

void ParticlePainter::draw(GLuint framebuffer, PixelsFor use, const Backdrop& background, const ColorTarget& layer,
                           std::span<const IntBox> boxes) {
  if (boxes.empty()) return;
  prepare(framebuffer, use, background, true);
  glBindTextureUnit(6, layer.even_rows());
  glBindTextureUnit(7, layer.odd_rows());
  glEnable(GL_SCISSOR_TEST);
  for (const IntBox& box : boxes) {
    glScissor(box.left / block_width, box.top / block_height, box.width() / block_width, box.height() / block_height);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  glDisable(GL_SCISSOR_TEST);
  drawn();
}

void ParticlePainter::drawn() {
  for (StreamBuffer* buffer : {&texels_, &first_texels_, &to_draw_}) buffer->drawn();
}

}  // namespace weir
