// Render targets in blocks: a texel packs the pixels of one row of a block into an integer.
#pragma once

#include <cstdint>
#include <vector>

#include "frame/image.h"
#include "render/canvas.h"
#include "render/gl_objects.h"
#include "render/texel.h"

namespace weir {

// Red, green, blue and alpha: even and odd rows in a texture each, four pixels a texel. Throws DeviceError if the
// driver cannot.
class ColorTarget {
 public:
  ColorTarget(int width, int height);  // pixels; the height is even

  GLuint framebuffer() const { return framebuffer_.id(); }
  GLuint even_rows() const { return even_.id(); }
  GLuint odd_rows() const { return odd_.id(); }

  // Nothing is in any pixel; until then, or until it is drawn, anything is.
  void clear();
  // The blocks of `box`, whose sides lie between blocks, from an image as wide as whole blocks.
  void upload(const Image& image, const IntBox& box);
  // These wait until it is drawn.
  void read(Image& image);
  void read(std::vector<Texel>& rows) const;  // whole blocks

 private:
  void read_rows(std::uint8_t* to) const;

  int width_;
  int height_;
  GlTexture even_;
  GlTexture odd_;
  GlFramebuffer framebuffer_;
  std::vector<Texel> rows_;  // where the width is not that of whole blocks
};

// What pictures are drawn over, as a buffer of the texels of ColorTarget, row by row: the software renderer reads such
// a buffer in half the time that a texture takes.
class Backdrop {
 public:
  Backdrop(int width, int height);  // pixels; the height is even

  void fill(std::uint32_t color);  // every pixel 0xAABBGGRR
  void take(const ColorTarget& target);
  GLuint texels() const { return texels_.id(); }
  GLuint pixels() const { return pixels_.id(); }  // the same, one by one
  int columns() const { return columns_; }        // texels

 private:
  int columns_;
  int rows_;
  GlBuffer buffer_;
  GlTexture texels_;
  GlTexture pixels_;
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
