// CPU rasteriser of lit spheres: the nearest two spheres of each pixel, and their coverage. Spheres are added one by
// one, preferably front to back, so that most hidden ones are rejected before they are rasterised.
//
// It runs on the processor for every device: hidden spheres can be removed only where the visible ones are known, after
// which little is left to shade. A software device had to process each sphere again for all blocks near it.
//
// Coverage is summed in integers of 1/1024 and depths are compared, so pixels do not depend on the order of spheres,
// except for equal depths, where the first sphere counts as nearer.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "render/eight.h"
#include "render/squares.h"
#include "render/texel.h"

namespace weir {

// A ball smaller than this, pixels, is drawn with this radius and fainter.
inline constexpr float least_ball = 1;

// The widest square that is asked about in one, pixels.
inline constexpr int widest_area = 256;

struct ScreenBall {
  float x = 0;  // pixels
  float y = 0;
  float depth = 0;          // m, of the centre
  std::uint32_t color = 0;  // 0xRRGGBB
};

// Pixels, the last ones included.
struct PixelRange {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

class BallPixels {
 public:
  // These pixels of a picture: whole Squares on the left and above, and whole areas.
  explicit BallPixels(const PixelRange& pixels, bool wide_registers = has_wide_registers());
  const PixelRange& all() const { return all_; }

  // From now on balls of this radius, m, seen with so many pixels per metre at one metre of depth, which will have
  // about `typical_reach` pixels of radius in the picture. Forgets all others.
  void begin(double radius, double focal, double typical_reach);
  // Those of our pixels that a ball may touch. It must touch some.
  PixelRange pixels_of(const ScreenBall& ball) const;
  float front_of(const ScreenBall& ball) const { return ball.depth - radius_; }  // m, of the nearest point
  // Whether nothing changes those of these pixels that are ours if it lies wholly at `front` or further, m. May say no
  // where it could say yes.
  bool hides(const PixelRange& pixels, float front) const;
  void add(const ScreenBall& ball);
  std::size_t added() const { return added_.size(); }

  // Marks the squares for which there is anything to draw.
  void mark(Squares& squares) const;
  // Writes what our squares hold to where it belongs.
  void take(const Squares& squares, double opacity, Texel* texels) const;

  struct Block;  // of pixels; see .cpp
  struct Seen;
  struct Added {
    float x = 0;  // pixels
    float y = 0;
    float size = 0;  // radius, pixels
    std::uint32_t color = 0;
  };

 private:
  struct Free {
    void operator()(void* blocks) const { std::free(blocks); }
  };
  // Two blocks, one above the other.
  static constexpr int cell_side = block_width;  // pixels
  static constexpr int cell_blocks = cell_side / block_height;

  Seen seen_as(const ScreenBall& ball) const;
  void close(int column, int row);

  std::size_t cell_at(int column, int row) const { return static_cast<std::size_t>(row) * columns_ + column; }
  // Our first pixel has the place 0, 0.
  std::size_t area_at(int left, int top) const {
    return static_cast<std::size_t>(top >> area_shift_) * area_columns_ + (left >> area_shift_);
  }

  PixelRange all_;
  // The loops over pixels; see .cpp.
  struct Loops;
  static const Loops& loops(bool wide_registers);
  const Loops& loops_;
  int columns_;  // cells
  int rows_;
  float radius_ = 0;  // m
  float focal_ = 0;
  std::vector<Added> added_;
  std::unique_ptr<Block[], Free> blocks_;  // of the cells, two each
  std::vector<std::uint8_t> touched_;      // cells whose blocks hold something
  std::vector<float> hidden_from_;  // for each cell: what lies wholly at this depth or further changes nothing, m
  // Areas are squares of 2^area_shift_ pixels, about as wide as a ball, so that a few of them answer hides().
  struct Area {
    int open = 0;           // cells that hide nothing yet
    float hidden_from = 0;  // m, of the others
  };
  int area_shift_ = 0;
  int area_columns_ = 0;
  std::vector<Area> areas_;
};

}  // namespace weir
