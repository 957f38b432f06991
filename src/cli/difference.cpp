#include "cli/difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace weir {

Difference difference(const Image& a, const Image& b, int tolerance) {
  Difference result;
  result.same_size = a.width == b.width && a.height == b.height;
  if (!result.same_size) return result;
  result.pixels = static_cast<std::int64_t>(a.rgba.size() / 4);
  std::int64_t sum = 0;
  std::int64_t sum_of_squares = 0;
  for (std::size_t pixel = 0; pixel < a.rgba.size(); pixel += 4) {
    int largest = 0;
    for (std::size_t channel = pixel; channel < pixel + 4; ++channel) {
      const int distance = std::abs(a.rgba[channel] - b.rgba[channel]);
      largest = std::max(largest, distance);
      sum += distance;
      sum_of_squares += distance * distance;
    }
    result.largest = std::max(result.largest, largest);
    result.beyond += largest > tolerance ? 1 : 0;
  }
  const double channels = static_cast<double>(std::max<std::size_t>(a.rgba.size(), 1));
  result.mean = static_cast<double>(sum) / channels;
  result.mean_square = static_cast<double>(sum_of_squares) / channels;
  return result;
}

double psnr(const Difference& difference) {
  if (difference.mean_square == 0) return std::numeric_limits<double>::infinity();
  return 10 * std::log10(255.0 * 255.0 / difference.mean_square);
}

Image difference_picture(const Image& a, const Image& b) {
  Image picture = a;
  int largest = 1;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const int distance = std::abs(a.rgba[i] - b.rgba[i]);
    picture.rgba[i] = static_cast<std::uint8_t>(distance);
    if (i % 4 != 3) largest = std::max(largest, distance);
  }
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    picture.rgba[i] = i % 4 == 3 ? 255 : static_cast<std::uint8_t>(picture.rgba[i] * 255 / largest);
  }
  return picture;
}

Comparison::Comparison(int tolerance, double fraction, bool keep_picture)
    : tolerance_(tolerance), fraction_(fraction), keep_picture_(keep_picture) {}

void Comparison::add(const std::string& name, const Image& a, const Image& b) {
  ++pictures_;
  const Difference found = difference(a, b, tolerance_);
  if (!found.same_size) {
    ++different_;
    missing_ += fmt::format("size of {}: {} x {} against {} x {}\n", name, a.width, a.height, b.width, b.height);
    return;
  }
  if (static_cast<double>(found.beyond) > fraction_ * static_cast<double>(found.pixels)) ++different_;
  const bool worse = worst_name_.empty() || found.beyond > worst_.beyond ||
                     (found.beyond == worst_.beyond && found.mean_square > worst_.mean_square);
  if (!worse) return;
  worst_ = found;
  worst_name_ = name;
  if (keep_picture_) picture_ = difference_picture(a, b);
}

void Comparison::add_missing(const std::string& what) { missing_ += what + "\n"; }

std::string Comparison::facts() const {
  std::string text = missing_;
  if (pictures_ > 0) text += fmt::format("pictures: {} compared, {} different\n", pictures_, different_);
  if (!worst_name_.empty()) {
    text += fmt::format("worst: {}\n", worst_name_);
    text += fmt::format(
        "  pixels that differ by more than {}: {} of {} ({:.4f} %)\n", tolerance_, worst_.beyond, worst_.pixels,
        100 * static_cast<double>(worst_.beyond) / static_cast<double>(std::max<std::int64_t>(worst_.pixels, 1)));
    text += fmt::format("  largest difference: {} of 255\n  mean difference: {:.4f}\n  PSNR: {:.2f} dB\n",
                        worst_.largest, worst_.mean, psnr(worst_));
  }
  return text;
}

}  // namespace weir
