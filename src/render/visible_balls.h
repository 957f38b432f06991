// Which of the balls are seen, and in which bins: a body of fluid in 3D shows little more than its skin, and what lies
// behind would cost the device most of its time.
//
// Balls are taken from the front to the back. For each pixel the shares of it that they cover are added up, as gather.frag
// does; where that makes a whole pixel, whatever lies behind them all adds nothing to it. A ball is listed in those bins
// where it touches a pixel that is not yet closed by balls that lie wholly in front of it. So the picture is the same to
// the last bit, and does not depend on the order in which the balls came.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/bins.h"
#include "render/lanes.h"

namespace weir {

// A ball smaller than this, pixels, is drawn with this radius and fainter; as in gather.frag.
inline constexpr float least_ball = 1;

struct ScreenBall {
  float x = 0;  // pixels
  float y = 0;
  std::uint32_t color = 0;
  float depth = 0;  // m, of the centre
};

class VisibleBalls {
 public:
  VisibleBalls(int width, int height);  // pixels

  // Balls of this radius, m, seen with so many pixels per metre at one metre of depth, of which `most` will be added;
  // for these bins, which have been reset.
  void begin(double radius, double focal, std::size_t most, const Bins& bins);
  // Adds those of four {x, y, color as bits, depth} that are `seen`: not 0.
  void add(const std::array<Lanes, 4>& four, Whole seen);
  // Counts the entries.
  void count(Bins& bins);
  // After the bins are closed: writes the entries to their places, those of a bin from the front to the back and equals in
  // an order of their own.
  void scatter(Bins& bins, ScreenBall* entries);

 private:
  struct Box {  // pixels, right and bottom not included
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;
  };
  struct Entry {
    std::uint32_t bin = 0;
    std::uint32_t ball = 0;  // in balls_
  };
  struct Place {
    std::uint32_t layer = 0;
    std::uint32_t bin = 0;  // the ball's centre, or what of the picture is nearest to it
  };

  void sort();
  float reach_of(const ScreenBall& ball) const;  // pixels
  Box pixels_of(const ScreenBall& ball) const;
  bool lists(std::uint32_t ball, Bins& bins);
  template <class Visit>
  void visit_near(int column, int row, const Visit& visit);
  bool is_closed(const Box& box) const;
  void cover(const ScreenBall& ball);

  int width_;
  int height_;
  std::size_t stride_;
  int bin_columns_ = 0;
  int bin_rows_ = 0;
  int column_shift_ = 0;  // a bin is 2^column_shift_ pixels wide
  int row_shift_ = 0;
  float radius_ = 0;  // m
  float focal_ = 0;
  std::vector<ScreenBall> balls_;  // as they came, and room for more
  std::vector<Place> places_;
  std::size_t size_ = 0;
  std::vector<std::uint32_t> begins_;    // of each layer in sorted_
  std::vector<Entry> sorted_;            // from the front to the back, layer by layer, with the bin of the centre
  std::vector<std::uint8_t> covered_;    // of pixels, in 1/65, with a margin on the right; see .cpp
  std::vector<std::uint8_t> closed_;     // bins, all of whose pixels are
  std::vector<std::uint8_t> open_near_;  // for each bin, how many around it are not
  std::vector<std::uint32_t> in_front_;  // listed balls of the last layer and of this
  std::vector<std::uint32_t> in_this_;
  std::vector<Entry> entries_;
  std::vector<ScreenBall> in_bins_;
};

}  // namespace weir
