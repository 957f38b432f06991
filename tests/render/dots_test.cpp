#include "render/dots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "render/taken_pixels.h"

namespace weir {
namespace {

constexpr int width = 90;
constexpr int height = 50;

struct Pixel {
  double share = 0;
  glm::dvec3 color{0};
};

// The part of a dot's width that falls on a pixel so far away: two pixels share it, or, spread, up to three.
double part(double off, double spread) {
  return (1 - spread) * std::max(1 - std::abs(off), 0.0) + spread * 0.5 * std::clamp(1.5 - std::abs(off), 0.0, 1.0);
}

std::vector<std::uint32_t> pixels_of(Dots& dots) { return taken_pixels(dots, width, height); }

// Against the formula in double precision: a share may be rounded to the other side, and a byte after it.
TEST(Dots, AreWhatTheirFormulaSays) {
  const Colormap& colors = distinct_colors();
  for (const double radius : {0.2, 0.45, 0.6, 0.9, 1.12}) {
    const double side = std::sqrt(std::numbers::pi) * radius;
    const double spread = std::max(0.0, 2 - 2 / side);
    std::mt19937 random(5);
    std::vector<glm::vec4> particles;
    for (int k = 0; k < 1501; ++k)
      particles.emplace_back(static_cast<float>(random() % 10000) * 0.0094f - 2,
                             static_cast<float>(random() % 10000) * 0.0054f - 2, 0.0f,
                             static_cast<float>(random() % 256));
    std::vector<Pixel> wanted(width * height);
    for (const glm::vec4& particle : particles)
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
          const double share = std::floor(
              1024 * side * side * part(x + 0.5 - particle.x, spread) * part(y + 0.5 - particle.y, spread) + 0.5);
          const std::uint32_t rgb = colors[static_cast<std::size_t>(particle.w)];
          Pixel& pixel = wanted[y * width + x];
          pixel.share += share;
          pixel.color += share * glm::dvec3(rgb >> 16, rgb >> 8 & 0xff, rgb & 0xff);
        }
    Dots dots(width, height);
    dots.add(particles, glm::vec4(1), glm::vec4(0), radius, colors);
    const std::vector<std::uint32_t> found = pixels_of(dots);
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      EXPECT_NEAR(found[k] >> 24, std::min(wanted[k].share / 1024, 1.0) * 255, 1) << radius << " " << k;
      if (wanted[k].share < 32) continue;  // of which one more or less changes the colour
      const glm::dvec3 color = wanted[k].color / wanted[k].share;
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[k] >> 8 * c & 0xff, color[c], 1 + 255 * 3 / wanted[k].share);
    }
    std::reverse(particles.begin(), particles.end());
    dots.add(particles, glm::vec4(1), glm::vec4(0), radius, colors);
    EXPECT_EQ(pixels_of(dots), found);  // any order, and nothing was left of the last
  }
}

}  // namespace
}  // namespace weir
