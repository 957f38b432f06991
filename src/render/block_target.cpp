#include "render/block_target.h"

#include <fmt/format.h>

#include <array>
#include <cstring>

#include "core/error.h"
#include "render/squares.h"

namespace weir {

namespace {

int blocks_across(int width) { return (width + block_width - 1) / block_width; }
int padded(int width) { return blocks_across(width) * block_width; }

template <std::size_t Count>
void attach(GLuint framebuffer, const std::array<GLuint, Count>& textures, int width, int height) {
  std::array<GLenum, Count> buffers{};
  for (std::size_t k = 0; k < Count; ++k) {
    buffers[k] = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(k);
    glNamedFramebufferTexture(framebuffer, buffers[k], textures[k], 0);
  }
  glNamedFramebufferDrawBuffers(framebuffer, Count, buffers.data());
  const GLenum status = glCheckNamedFramebufferStatus(framebuffer, GL_DRAW_FRAMEBUFFER);
  if (status == GL_FRAMEBUFFER_COMPLETE) return;
  throw DeviceError(fmt::format("the driver cannot draw a picture of {} x {} pixels (framebuffer status 0x{:04x})",
                                width, height, status));
}

// How texels of one attachment come back: `texels` of them a row, `row_texels` from row to row in memory.
struct Plane {
  int attachment = 0;
  GLenum format = 0;
  GLenum type = 0;
  int texels = 0;
  int row_texels = 0;
};

void read_plane(GLuint framebuffer, const Plane& plane, int rows, std::uint8_t* to) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(plane.attachment));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, plane.row_texels);
  glReadPixels(0, 0, plane.texels, rows, plane.format, plane.type, to);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
}

void copy_rows(const void* from, std::size_t from_stride, std::vector<std::uint8_t>& to, std::size_t to_stride,
               int rows) {
  for (std::size_t row = 0; row < static_cast<std::size_t>(rows); ++row)
    std::memcpy(&to[row * to_stride], static_cast<const std::uint8_t*>(from) + row * from_stride, to_stride);
}

}  // namespace

ColorTarget::ColorTarget(int width, int height)
    : width_(width),
      height_(height),
      even_(make_texture(GL_RGBA32UI, blocks_across(width), height / 2)),
      odd_(make_texture(GL_RGBA32UI, blocks_across(width), height / 2)) {
  attach<2>(framebuffer_.id(), {even_.id(), odd_.id()}, width, height);
}

void ColorTarget::clear() {
  for (const GLuint rows : {even_.id(), odd_.id()}) glClearTexImage(rows, 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT, nullptr);
}

void ColorTarget::upload(const Image& image, const IntBox& box) {
  if (box.width() <= 0 || box.height() <= 0) return;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 2 * image.width / block_width);
  for (const int odd : {0, 1})
    glTextureSubImage2D(odd == 0 ? even_.id() : odd_.id(), 0, box.left / block_width, box.top / block_height,
                        box.width() / block_width, box.height() / block_height, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                        image.pixel(box.left, box.top + odd));
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

void ColorTarget::read(Image& image) {
  image.width = width_;
  image.height = height_;
  image.rgba.resize(std::size_t{4} * width_ * height_);
  if (padded(width_) == width_) {
    read_rows(image.rgba.data());
    return;
  }
  read(rows_);
  copy_rows(rows_.data(), std::size_t{4} * padded(width_), image.rgba, std::size_t{4} * width_, height_);
}

void ColorTarget::read(std::vector<Texel>& rows) const {
  rows.resize(static_cast<std::size_t>(blocks_across(width_)) * height_);
  read_rows(reinterpret_cast<std::uint8_t*>(rows.data()));
}

void ColorTarget::read_rows(std::uint8_t* to) const {
  const int texels = blocks_across(width_);
  for (const int odd : {0, 1})
    read_plane(framebuffer_.id(), {odd, GL_RGBA_INTEGER, GL_UNSIGNED_INT, texels, 2 * texels}, height_ / 2,
               to + odd * texels * sizeof(Texel));
}

Backdrop::Backdrop(int width, int height)
    : columns_(blocks_across(width)),
      rows_(height),
      texels_(make_buffer_texture(GL_RGBA32UI, buffer_.id())),
      pixels_(make_buffer_texture(GL_R32UI, buffer_.id())) {
  const std::size_t bytes = std::size_t{4} * block_width * columns_ * rows_;
  glNamedBufferData(buffer_.id(), static_cast<GLsizeiptr>(bytes), nullptr, GL_STATIC_DRAW);
}

void Backdrop::fill(std::uint32_t color) {
  glClearNamedBufferData(buffer_.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &color);
}

void Backdrop::take(const ColorTarget& target) {
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());  // then pointers are offsets
  for (const int odd : {0, 1})
    read_plane(target.framebuffer(), {odd, GL_RGBA_INTEGER, GL_UNSIGNED_INT, columns_, 2 * columns_}, rows_ / 2,
               reinterpret_cast<std::uint8_t*>(std::size_t{4} * block_width * columns_ * odd));
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
}

MovieTarget::MovieTarget(int width, int height)
    : width_(width),
      height_(height),
      even_(make_texture(GL_R32UI, blocks_across(width), height / 2)),
      odd_(make_texture(GL_R32UI, blocks_across(width), height / 2)),
      cb_(make_texture(GL_R16UI, blocks_across(width), height / 2)),
      cr_(make_texture(GL_R16UI, blocks_across(width), height / 2)) {
  attach<4>(framebuffer_.id(), {even_.id(), odd_.id(), cb_.id(), cr_.id()}, width, height);
}

void MovieTarget::read(MovieImage& image) {
  image.resize(width_, height_);
  const bool whole = padded(width_) == width_;
  const int texels = blocks_across(width_);
  const auto read_samples = [&](const Plane& plane, std::size_t bytes, int rows, int passes,
                                std::vector<std::uint8_t>& samples, int samples_a_row) {
    const std::size_t stride = bytes * texels;
    if (!whole) rows_.resize(stride * rows * passes);
    std::uint8_t* to = whole ? samples.data() : rows_.data();
    for (int pass = 0; pass < passes; ++pass) {
      Plane part = plane;
      part.attachment += pass;
      read_plane(framebuffer_.id(), part, rows, to + pass * stride);
    }
    if (!whole) copy_rows(rows_.data(), stride, samples, samples_a_row, rows * passes);
  };
  const int rows = height_ / 2;
  read_samples({0, GL_RED_INTEGER, GL_UNSIGNED_INT, texels, 2 * texels}, 4, rows, 2, image.y, width_);
  read_samples({2, GL_RED_INTEGER, GL_UNSIGNED_SHORT, texels, texels}, 2, rows, 1, image.cb, width_ / 2);
  read_samples({3, GL_RED_INTEGER, GL_UNSIGNED_SHORT, texels, texels}, 2, rows, 1, image.cr, width_ / 2);
}

}  // namespace weir
