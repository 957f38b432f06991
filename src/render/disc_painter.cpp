#include "render/disc_painter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include "render/assets.h"
#include "render/unroll.h"

namespace weir {

namespace {

constexpr int square_size = 1 << square_shift;  // blocks

// Bins grow with the discs, so that a disc has about ten entries at any zoom.
int bin_shift(double reach) {
  return std::clamp(static_cast<int>(std::floor(std::log2(std::max(reach, 1.0) / 1.2))), 0, 12);
}

int across(int pixels, int unit) { return (pixels + unit - 1) / unit; }

void set(GLuint program, const char* name, int a) {
  glProgramUniform1i(program, glGetUniformLocation(program, name), a);
}
void set(GLuint program, const char* name, double a) {
  glProgramUniform1f(program, glGetUniformLocation(program, name), static_cast<float>(a));
}

// What gather.frag reads of a disc: a texel.
struct Entry {
  float x = 0;  // pixels
  float y = 0;
  std::uint32_t color = 0;  // as in Disc
  std::uint32_t unused = 0;
};

// A colour and its place in the map, as in Disc.
std::array<std::uint32_t, 256> packed(Colormap colors) {
  for (std::uint32_t k = 0; k < colors.size(); ++k)
    colors[k] = k << 24 | (colors[k] & 0xff) << 16 | (colors[k] & 0xff00) | colors[k] >> 16;
  return colors;
}

// Multiplied with a quantity less the lower end of the range: its place in the map.
float steps_per_unit(const DiscStyle& style) { return static_cast<float>(255 / (style.range[1] - style.range[0])); }

}  // namespace

DiscPainter::DiscPainter(int width, int height)
    : width_(width),
      height_(height),
      bins_(width, height),
      dots_(width, height),
      balls_(width, height, thread_count(0)),
      entries_(GL_RGBA32UI),
      ranges_(GL_RG32UI),
      square_texels_(GL_R32UI) {}

void DiscPainter::project_flat(std::span<const glm::vec4> particles, const Projection& projection,
                               const DiscStyle& style) {
  radius_ = projection.focal * style.radius;
  const auto meters = static_cast<float>(projection.focal);
  const float steps = steps_per_unit(style);
  const glm::vec4 scale(meters, -meters, 0, steps);
  const glm::vec4 offset(projection.principal.x - projection.focal * projection.eye.x,
                         projection.principal.y + projection.focal * projection.eye.y, 0, -style.range[0] * steps);
  are_dots_ = radius_ < largest_dot;
  if (are_dots_) {
    dots_.add(particles, scale, offset, radius_, style.colors);
    return;
  }
  const auto reach = static_cast<float>(radius_);
  const glm::vec2 limit(static_cast<float>(width_) + reach, static_cast<float>(height_) + reach);
  const Colormap colors = packed(style.colors);
  for (const glm::vec4& particle : particles) {
    const glm::vec4 at = particle * scale + offset;
    const float place = std::clamp(at.w, 0.0f, 255.0f);
    // Written so that what is not a number is left out.
    if (at.x > -reach && at.x < limit.x && at.y > -reach && at.y < limit.y && place >= 0)
      discs_.push_back({at.x, at.y, reach, colors[static_cast<std::size_t>(place + 0.5f)]});
  }
  bins_.reset(bin_shift(radius_));
}

void DiscPainter::arrange(std::span<const glm::vec4> particles, const Projection& projection, const DiscStyle& style,
                          std::vector<std::uint8_t>& stale) {
  are_balls_ = projection.perspective;
  opacity_ = style.opacity;
  discs_.clear();
  if (are_balls_) {
    are_dots_ = false;
    balls_.show(particles, projection, {style.radius, style.range}, style.colors);
    balls_.count(bins_);
  } else {
    project_flat(particles, projection, style);
    if (are_dots_)
      dots_.count(bins_);
    else
      bins_.count(std::span<const Disc>(discs_));
  }
  const std::size_t entries = bins_.close(stale);
  ranges_.write(bins_.ranges());
  list_squares();
  static_assert(sizeof(Entry) == sizeof(Texel));
  void* to = entries_.map(entries * sizeof(Entry));
  if (are_balls_)
    balls_.take(bins_, opacity_, static_cast<Texel*>(to));
  else if (are_dots_)
    dots_.take(bins_, opacity_, static_cast<Texel*>(to));
  else
    bins_.scatter(std::span<const Disc>(discs_), static_cast<Entry*>(to), [](const Disc& disc) {
      return Entry{disc.x, disc.y, disc.color, 0};
    });
  entries_.unmap();
}

void DiscPainter::list_squares() {
  squares_.clear();
  const int columns = across(width_, block_width * square_size);
  const int rows = across(height_, block_height * square_size);
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      if (bins_.any_to_do(column * square_size, row * square_size, square_size))
        squares_.push_back(static_cast<std::uint32_t>(row) << 16 | static_cast<std::uint32_t>(column));
  square_texels_.write(std::span<const std::uint32_t>(squares_));
}

const GlProgram& DiscPainter::program(bool movie, bool overlay) {
  std::string defines;
  if (movie) defines += "#define YUV\n";
  if (overlay) defines += "#define OVERLAY\n";
  if (are_balls_ || are_dots_) defines += "#define PIXELS\n";
  const auto found = programs_.find(defines);
  if (found != programs_.end()) return found->second;
  const int columns = movie ? 5 : 4;  // as in gather.frag
  const std::string fragment =
      unrolled(std::string(assets::gather_frag()), {{"columns", columns}, {"count", 2 * columns}});
  GlProgram made = build_program(std::string(assets::gather_vert()), fragment, defines);
  int unit = 0;
  for (const char* name : {"bins", "entries", "squares", "under", "over_even", "over_odd"})
    set(made.id(), name, unit++);
  return programs_.emplace(defines, std::move(made)).first->second;
}

void DiscPainter::prepare(GLuint framebuffer, const DiscOutput& output, const Backdrop& background, bool overlay) {
  const GLuint id = program(output.movie, overlay).id();
  set(id, "bin_shift", bins_.shift());
  set(id, "bin_columns", bins_.columns());
  set(id, "radius", radius_);
  // The smooth step's spread about its middle, (4/3)^2 / 20, adds as much to the area as this takes away.
  set(id, "edge", std::sqrt(std::max(radius_ * radius_ - 4.0 / 45, 0.0)));
  set(id, "opacity", opacity_);
  set(id, "straight", output.straight ? 1 : 0);
  glProgramUniform3f(id, glGetUniformLocation(id, "background"), output.background.r, output.background.g,
                     output.background.b);
  glUseProgram(id);
  glBindTextureUnit(0, ranges_.texture());
  glBindTextureUnit(1, entries_.texture());
  glBindTextureUnit(2, square_texels_.texture());
  // Whole squares, or the middle of one at the edge would be outside, and a point there is not drawn.
  const int columns = across(width_, block_width * square_size) * square_size;
  const int rows = across(height_, block_height * square_size) * square_size;
  glProgramUniform2i(id, glGetUniformLocation(id, "blocks"), columns, rows);
  set(id, "square_size", square_size);
  glBindTextureUnit(3, background.texels());
  set(id, "under_columns", background.columns());
  glBindVertexArray(no_vertices_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, columns, rows);
}

void DiscPainter::draw(GLuint framebuffer, const DiscOutput& output, const Backdrop& background) {
  prepare(framebuffer, output, background, false);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(squares_.size()));
}

void DiscPainter::draw(GLuint framebuffer, const DiscOutput& output, const Backdrop& background,
                       const ColorTarget& layer, std::span<const IntBox> boxes) {
  if (boxes.empty()) return;
  prepare(framebuffer, output, background, true);
  glBindTextureUnit(4, layer.even_rows());
  glBindTextureUnit(5, layer.odd_rows());
  glEnable(GL_SCISSOR_TEST);
  for (const IntBox& box : boxes) {
    glScissor(box.left / block_width, box.top / block_height, box.width() / block_width, box.height() / block_height);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace weir
