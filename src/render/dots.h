// CPU rasteriser of dots, discs too small to look round: coverage is summed per pixel. Sorting dots into lists for the
// device costs the processor more than summing them.
//
// Sums are integers, so they do not depend on the order of dots; they overflow at a coverage of 8,000.
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <glm/glm.hpp>
#include <memory>
#include <numbers>
#include <span>
#include <vector>

#include "render/colormap.h"
#include "render/particle_pixels.h"

namespace weir {

// Up to this radius, pixels, a disc is spread as a dot: the largest of which no pixel has more than its own area.
inline constexpr double largest_dot = std::numbers::inv_sqrtpi * 2;

class Dots final : public ParticlePixels {
 public:
  Dots(int width, int height);  // pixels

  // Adds dots of this radius, pixels: a particle times `scale` plus `offset` is the dot's place in the picture, pixels,
  // then nothing, then the place of its colour (0xRRGGBB) in the map. What is not a number is left out.
  void add(std::span<const glm::vec4> particles, const glm::vec4& scale, const glm::vec4& offset, double radius,
           const Colormap& colors);

  void mark(Squares& squares) override;
  // Nothing is left then.
  void take(const Squares& squares, double opacity, Texel* texels, const RowTaken& taken) override;

 private:
  // Red, green and blue, each times the share of the pixel in 1/1024, and the sum of those shares.
  using Sum = std::uint32_t __attribute__((vector_size(16)));
  struct Free {
    void operator()(Sum* sums) const { std::free(sums); }
  };

  template <int Side>
  void add_to_pixels(std::span<const glm::vec4> particles, const glm::vec4& scale, const glm::vec4& offset,
                     double radius, const Colormap& colors);
  static Texel resolved(const Sum* sums, float opacity);

  int width_;
  int height_;
  // Squares with one more on every side for what lies just outside of the picture, so that nobody has to ask.
  std::size_t square_stride_;
  std::size_t square_rows_;
  std::unique_ptr<Sum[], Free> sums_;  // of pixels, all 0 between pictures
  std::vector<std::uint8_t> filled_;   // for each square
};

}  // namespace weir
