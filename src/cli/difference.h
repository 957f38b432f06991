// How much two pictures differ, in numbers and as a picture.
#pragma once

#include <cstdint>
#include <string>

#include "frame/image.h"

namespace weir {

struct Difference {
  bool same_size = false;  // if not, nothing below is known
  std::int64_t pixels = 0;
  std::int64_t beyond = 0;  // pixels of which a channel differs by more than the tolerance
  int largest = 0;          // over pixels and channels, of 255
  double mean = 0;          // of the absolute difference over pixels and channels
  double mean_square = 0;
};
Difference difference(const Image& a, const Image& b, int tolerance);

double psnr(const Difference& difference);  // dB; infinite for equal pictures

// The absolute difference of the colours, stretched so that the largest is white; opaque. For pictures of equal size.
Image difference_picture(const Image& a, const Image& b);

// Differences of pictures that belong together, kept as totals and the worst of them.
class Comparison {
 public:
  Comparison(int tolerance, double fraction, bool keep_picture);

  void add(const std::string& name, const Image& a, const Image& b);
  // Something stands on one side only.
  void add_missing(const std::string& what);

  bool same() const { return different_ == 0 && missing_.empty(); }
  std::int64_t pictures() const { return pictures_; }
  std::string facts() const;                         // lines for the user
  const Image& picture() const { return picture_; }  // of the worst; empty without a pair of equal size

 private:
  int tolerance_;
  double fraction_;
  bool keep_picture_;
  std::int64_t pictures_ = 0;
  std::int64_t different_ = 0;
  std::string missing_;
  std::string worst_name_;
  Difference worst_;
  Image picture_;
};

}  // namespace weir
