#include "render/disc_pixels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>

#include "render/taken_pixels.h"

namespace weir {
namespace {

constexpr int width = 90;  // neither whole squares nor whole blocks
constexpr int height = 50;

// Positions in pixels, in and around the picture, and places in the map.
std::vector<glm::vec4> scattered(int count, double margin) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(-margin, width + margin);
  std::uniform_real_distribution<double> y(-margin, height + margin);
  std::vector<glm::vec4> particles;
  for (int k = 0; k < count; ++k) particles.emplace_back(x(random), y(random), 0, static_cast<float>(random() % 256));
  return particles;
}

std::vector<std::uint32_t> pixels_of(DiscPixels& discs, const std::vector<glm::vec4>& particles, double radius) {
  discs.show(particles, glm::vec4(1), glm::vec4(0), radius, distinct_colors());
  return taken_pixels(discs, width, height);
}

double coverage(double distance, double radius) {
  const double edge = std::sqrt(std::max(radius * radius - 4.0 / 45, 0.0));
  const double along = std::clamp(0.5 + 0.75 * (edge - distance), 0.0, 1.0);
  return along * along * (3 - 2 * along);
}

struct Pixel {
  double alpha = 0;  // 0 .. 1
  glm::dvec3 color{0};
  double doubt = 0;  // between the distances of which two are taken, squared pixels
};

// All discs asked at every pixel.
Pixel looked_at(const std::vector<glm::vec4>& particles, double radius, int x, int y) {
  std::vector<std::pair<double, int>> near;
  for (const glm::vec4& particle : particles) {
    const double off_x = x + 0.5 - particle.x;
    const double off_y = y + 0.5 - particle.y;
    near.emplace_back(off_x * off_x + off_y * off_y, static_cast<int>(particle.w));
  }
  std::partial_sort(near.begin(), near.begin() + 3, near.end());
  const auto color = [&](int k) {
    const std::uint32_t rgb = distinct_colors()[near[k].second];
    return glm::dvec3(rgb >> 16, rgb >> 8 & 0xff, rgb & 0xff);
  };
  const double by_one = coverage(std::sqrt(near[0].first), radius);
  const double by_two = coverage(std::sqrt(near[1].first), radius);
  const double apart = near[1].first - near[0].first;
  const double side = by_two > 0 ? std::min(0.5 + apart / (4 * radius), 1.0) : 1;
  return {std::min(by_one + by_two, 1.0), side * color(0) + (1 - side) * color(1),
          std::min(apart, near[2].first - near[1].first)};
}

// A key keeps 15 bits of a squared distance below reach^2: which of two discs is nearer, or second, is open where they
// differ by less; a byte may be rounded to the other side.
TEST(DiscPixels, AreWhatAllDiscsAskedOneByOneSay) {
  for (const double radius : {1.2, 2.8, 6.5, 40.0}) {
    const std::vector<glm::vec4> particles = scattered(radius < 5 ? 300 : 40, radius + 2);
    DiscPixels discs(width, height);
    const std::vector<std::uint32_t> found = pixels_of(discs, particles, radius);
    int open = 0;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const Pixel wanted = looked_at(particles, radius, x, y);
        const std::uint32_t pixel = found[y * width + x];
        ASSERT_NEAR(pixel >> 24, wanted.alpha * 255, 1) << radius << " " << x << " " << y;
        if (wanted.doubt < std::exp2(-14) * (radius + 1) * (radius + 1)) {
          ++open;
          continue;
        }
        if (pixel >> 24 == 0) continue;
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(pixel >> 8 * c & 0xff, wanted.color[c], 1.5) << radius << " " << x << " " << y;
      }
    EXPECT_LT(open, width * height / 100);
  }
}

TEST(DiscPixels, AreTheSameInAnyOrderAndAnyRegisters) {
  std::vector<glm::vec4> particles = scattered(300, 4);
  for (int k = 0; k < 100; ++k)  // on a lattice, where distances are equal
    particles.emplace_back(4 * (k % 10), 4 * (k / 10), 0, static_cast<float>(k));
  for (const double radius : {1.3, 3.0}) {
    DiscPixels narrow(width, height, false);
    const std::vector<std::uint32_t> pixels = pixels_of(narrow, particles, radius);
    std::shuffle(particles.begin(), particles.end(), std::mt19937(3));
    EXPECT_EQ(pixels_of(narrow, particles, radius), pixels);  // and nothing was left of the last
    if (!has_wide_registers()) continue;
    DiscPixels wide(width, height, true);
    EXPECT_EQ(pixels_of(wide, particles, radius), pixels);
  }
}

TEST(DiscPixels, ThatAreNotFiniteAreLeftOut) {
  std::vector<glm::vec4> particles = scattered(50, 4);
  DiscPixels discs(width, height);
  const std::vector<std::uint32_t> pixels = pixels_of(discs, particles, 3);
  const float infinity = std::numeric_limits<float>::infinity();
  const float not_a_number = std::numeric_limits<float>::quiet_NaN();
  for (const glm::vec4& odd :
       {glm::vec4(not_a_number, 9, 0, 9), glm::vec4(9, not_a_number, 0, 9), glm::vec4(9, 9, 0, not_a_number),
        glm::vec4(infinity, 9, 0, 9), glm::vec4(9, -infinity, 0, 9), glm::vec4(3e38f, -3e38f, 0, 9)})
    particles.insert(particles.begin() + 7, odd);
  EXPECT_EQ(pixels_of(discs, particles, 3), pixels);
}

// A disc in the first square whose right-most pixels are the last of it: the next square's chroma takes from them.
TEST(DiscPixels, MarkTheSquareWhoseChromaTakesFromThem) {
  DiscPixels discs(width, height);
  const auto marked = [&](float x) {
    discs.show(std::vector{glm::vec4(x, 8, 0, 0)}, glm::vec4(1), glm::vec4(0), 2, distinct_colors());
    Squares squares(width, height);
    discs.mark(squares);
    std::vector<std::uint8_t> stale;
    std::vector<Texel> texels(squares.close(stale));
    discs.take(squares, 1, texels.data(), [](int) {});
    return std::tuple(squares.filled()[0], squares.filled()[1], squares.filled()[2]);
  };
  // The edge ends 2/3 of a pixel beyond the radius.
  EXPECT_EQ(marked(square_width - 4.5f), std::tuple(1, 0, 0));
  EXPECT_EQ(marked(square_width - 3.0f), std::tuple(1, 1, 0));
  EXPECT_EQ(marked(square_width + 4.0f), std::tuple(0, 1, 0));
}

// What is neither filled nor stale is not drawn; what was filled is stale once.
TEST(Squares, AreDrawnWhereTheTargetWouldBeWrong) {
  Squares squares(3 * square_width, square_height);
  const auto drawn = [&](std::vector<std::uint8_t>& stale) {
    squares.close(stale);
    return std::vector<std::uint32_t>(squares.to_draw().begin(), squares.to_draw().end());
  };
  std::vector<std::uint8_t> stale;
  squares.begin();
  squares.filled()[1] = 1;
  EXPECT_EQ(drawn(stale), (std::vector<std::uint32_t>{0, 1, 2}));  // a fresh target shows anything
  EXPECT_EQ(squares.first_texels()[0], Squares::empty);
  EXPECT_EQ(squares.first_texels()[1], square_texels);
  EXPECT_EQ(drawn(stale), (std::vector<std::uint32_t>{1}));
  squares.begin();
  squares.filled()[2] = 1;
  EXPECT_EQ(drawn(stale), (std::vector<std::uint32_t>{1, 2}));
  squares.begin();
  EXPECT_EQ(drawn(stale), (std::vector<std::uint32_t>{2}));
  EXPECT_EQ(drawn(stale), (std::vector<std::uint32_t>{}));
}

}  // namespace
}  // namespace weir
