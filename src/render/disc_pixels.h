// CPU rasteriser of flat discs: each pixel keeps the two discs with the nearest centres, which contain its whole
// covered part, divided along the bisector of the two centres.
//
// It runs on the processor for every device: gathering discs by blocks of pixels on a software device took a third
// longer.
//
// Selection is by minima, so pixels do not depend on the order of discs.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "render/colormap.h"
#include "render/eight.h"
#include "render/particle_pixels.h"

namespace weir {

class DiscPixels final : public ParticlePixels {
 public:
  DiscPixels(int width, int height, bool wide_registers = has_wide_registers());  // pixels

  // What is shown from now on, discs of this radius, pixels: a particle times `scale` plus `offset` is the disc's place
  // in the picture, pixels, then nothing, then the place of its colour (0xRRGGBB) in the map. What is not a number is
  // left out.
  void show(std::span<const glm::vec4> particles, const glm::vec4& scale, const glm::vec4& offset, double radius,
            const Colormap& colors);

  void mark(Squares& squares) override;
  void take(const Squares& squares, double opacity, Texel* texels, const RowTaken& taken) override;

  // Of each pixel of a block the squared distances, pixels, to the two nearest centres, as bits of a float of which the
  // lowest 8 are the disc's place in the colour map: so among equals the colour decides. 64 bytes, a line of the cache.
  struct alignas(sizeof(EightWhole)) Block {
    EightWhole nearest;
    EightWhole second;
  };
  struct Disc {
    float x = 0;  // of the centre, pixels
    float y = 0;
    std::int32_t place = 0;  // in the colour map
  };
  // What the loops over pixels work on; see .cpp.
  struct Sheet;
  struct Look;

 private:
  struct Loops;
  static const Loops& loops(bool wide_registers);

  const Loops& loops_;
  int width_;
  int height_;
  std::vector<Disc> discs_;
  // Row by row of squares, those of one together: its blocks stay in the cache from disc to disc to texels.
  std::vector<Disc> by_rows_;
  std::vector<std::size_t> row_ends_;  // where the discs of a row end
  std::vector<Block> blocks_;          // of one row, square by square
  std::vector<std::uint8_t> holds_;    // for each square of the row whether its blocks hold something
  float reach_ = 0;                    // pixels
  double radius_ = 1;                  // pixels
  Colormap colors_{};
};

}  // namespace weir
