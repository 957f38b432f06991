// Pictures that are drawn block by block: a texel holds the pixels of a row of one block, packed into an integer.
#pragma once

#include <cstdint>
#include <vector>

#include "frame/image.h"
#include "render/canvas.h"
#include "render/gl_objects.h"

namespace weir {

// Red, green, blue and alpha: even and odd rows in a texture each, four pixels a texel. Throws DeviceError if the driver
// cannot.
class ColorTarget {
 public:
  ColorTarget(int width, int height);  // pixels; the height is even

  GLuint framebuffer() const { return framebuffer_.id(); }
  GLuint even_rows() const { return even_.id(); }
  GLuint odd_rows() const { return odd_.id(); }

  void fill(std::uint32_t color);  // every pixel 0xAABBGGRR
  // The blocks of `box`, whose sides lie between blocks, from an image as wide as whole blocks.
  void upload(const Image& image, const IntBox& box);
  void read(Image& image);  // waits until it is drawn

 private:
  int width_;
  int height_;
  GlTexture even_;
  GlTexture odd_;
  GlFramebuffer framebuffer_;
  std::vector<std::uint8_t> rows_;  // of whole blocks, where the width is not
};

// Y'CbCr as in MovieImage. Throws DeviceError if the driver cannot.
class MovieTarget {
 public:
  MovieTarget(int width, int height);  // pixels; even

  GLuint framebuffer() const { return framebuffer_.id(); }
  void read(MovieImage& image);  // waits until it is drawn

 private:
  int width_;
  int height_;
  GlTexture even_;
  GlTexture odd_;
  GlTexture cb_;
  GlTexture cr_;
  GlFramebuffer framebuffer_;
  std::vector<std::uint8_t> rows_;
};

}  // namespace weir
