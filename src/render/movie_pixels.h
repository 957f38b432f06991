// Composition of movie frames on the processor: particles over the background, texts on top, converted to Y'CbCr. On a
// software device this replaces compose.frag, in less time and without read-back.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "frame/image.h"
#include "render/canvas.h"
#include "render/eight.h"
#include "render/squares.h"
#include "render/texel.h"

namespace weir {

// What lies upon each other, from the back to the front.
struct MovieLayers {
  std::span<const Texel> background;  // rows of the whole picture, as wide as whole blocks; its alpha is not looked at
  const Squares& squares;             // which of them the particles fill
  const Texel* particles;             // as those say
  const Image& texts;                 // as wide as whole blocks
};

class MoviePixels {
 public:
  // Pixels, both even. Nothing of the texts is ever outside of `text_boxes`.
  MoviePixels(int width, int height, std::span<const IntBox> text_boxes, bool wide_registers = has_wide_registers());

  // Into an image of that size: the squares of a row that are to be drawn (Squares::to_draw).
  void draw(const MovieLayers& layers, int row, MovieImage& image) const;
  // All that the boxes touch.
  void draw(const MovieLayers& layers, std::span<const IntBox> boxes, MovieImage& image) const;

 private:
  struct Place {
    int column, row;
  };
  void mark(std::span<const IntBox> boxes, std::vector<std::uint8_t>& squares) const;
  void draw_square(const MovieLayers& layers, Place square, MovieImage& image) const;

  int columns_;         // blocks
  int rows_;            // blocks
  int square_columns_;  // squares
  bool wide_registers_;
  std::vector<std::uint8_t> has_texts_;  // for each square
};

}  // namespace weir
