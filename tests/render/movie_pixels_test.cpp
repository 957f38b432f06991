#include "render/movie_pixels.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "support/movie_image.h"

namespace weir {
namespace {

constexpr int width = 90;  // neither whole squares nor whole blocks
constexpr int height = 50;
constexpr int columns = 23;  // blocks

// Everything at random: the background, particles in some squares, texts in one box.
struct Layers {
  std::vector<Texel> background{static_cast<std::size_t>(columns) * height};
  Squares squares{width, height};
  std::vector<Texel> particles;
  Image texts{4 * columns, height, std::vector<std::uint8_t>(std::size_t{16} * columns * height)};
  IntBox box{28, 10, 68, 22};

  Layers() {
    std::mt19937 random(9);
    const auto pixel = [&] { return static_cast<std::uint32_t>(random()); };
    for (Texel& texel : background)
      for (std::uint32_t& each : texel) each = pixel();
    for (const std::size_t square : {0, 1, 4, 8, 11}) squares.filled()[square] = 1;
    std::vector<std::uint8_t> stale;
    particles.resize(squares.close(stale));
    for (Texel& texel : particles)
      for (std::uint32_t& each : texel) each = pixel() % 4 == 0 ? 0 : pixel();
    for (int y = box.top; y < box.bottom; ++y)
      for (int byte = 0; byte < 4 * box.width(); ++byte)
        texts.pixel(box.left, y)[byte] = static_cast<std::uint8_t>(pixel());
  }

  MovieLayers all() const { return {background, squares, particles.data(), texts}; }

  // What lies upon each other, one after the other, in 0 .. 255.
  std::array<double, 3> color(int x, int y) const {
    const std::uint32_t under = background[static_cast<std::size_t>(y) * columns + x / 4][x % 4];
    std::array<double, 3> rgb{};
    for (int c = 0; c < 3; ++c) rgb[c] = under >> (8 * c) & 255;
    const auto lay = [&](std::uint32_t top) {
      for (int c = 0; c < 3; ++c) rgb[c] += (top >> 24) / 255.0 * ((top >> (8 * c) & 255) - rgb[c]);
    };
    const std::uint32_t first = squares.first_texels()[y / square_height * squares.columns() + x / square_width];
    if (first != Squares::empty) {
      const int block = y % square_height / 2 * square_blocks + x % square_width / 4;
      lay(particles[first + 2 * block + y % 2][x % 4]);
    }
    const std::uint8_t* text = texts.pixel(x, y);
    lay(static_cast<std::uint32_t>(text[0] | text[1] << 8 | text[2] << 16) | static_cast<std::uint32_t>(text[3]) << 24);
    return rgb;
  }
};

MovieImage drawn(const Layers& layers, bool wide_registers) {
  const MoviePixels pixels(width, height, {&layers.box, 1}, wide_registers);
  MovieImage image;
  image.resize(width, height);
  for (int row = 0; row < layers.squares.rows(); ++row) pixels.draw(layers.all(), row, image);
  return image;
}

TEST(MoviePixels, AreTheLayersAsTheStandardHasThem) {
  const Layers layers;
  const MovieImage image = drawn(layers, false);
  const auto color = [&](int x, int y) { return layers.color(std::max(x, 0), y); };
  // Within a rounding, and within what floats are off by before it.
  constexpr double bound = 0.501;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) ASSERT_NEAR(image.y[y * width + x], testing::ycc(color(x, y))[0], bound);
  for (int y = 0; y < height / 2; ++y)
    for (int x = 0; x < width / 2; ++x) {
      std::array<double, 3> mean{};
      for (int row = 0; row < 2; ++row)
        for (int column = -1; column < 2; ++column)
          for (std::size_t c = 0; c < 3; ++c)
            mean[c] += color(2 * x + column, 2 * y + row)[c] * (column == 0 ? 2 : 1) / 8;
      ASSERT_NEAR(image.cb[y * (width / 2) + x], testing::ycc(mean)[1], bound) << x << " " << y;
      ASSERT_NEAR(image.cr[y * (width / 2) + x], testing::ycc(mean)[2], bound) << x << " " << y;
    }
}

TEST(MoviePixels, AreTheSameInAnyRegisters) {
  if (!has_wide_registers()) GTEST_SKIP() << "this processor has no AVX2";
  const Layers layers;
  const MovieImage narrow = drawn(layers, false);
  const MovieImage wide = drawn(layers, true);
  EXPECT_EQ(narrow.y, wide.y);
  EXPECT_EQ(narrow.cb, wide.cb);
  EXPECT_EQ(narrow.cr, wide.cr);
}

// Only squares that are to be drawn, or that a box touches.
TEST(MoviePixels, AreLeftAloneElsewhere) {
  Layers layers;
  std::vector<std::uint8_t> stale(layers.squares.filled().size(), 0);
  layers.squares.begin();
  layers.squares.filled()[4] = 1;
  layers.squares.close(stale);
  const MoviePixels pixels(width, height, {&layers.box, 1});
  const auto changed = [&](const auto& draw) {
    MovieImage image;
    image.resize(width, height);
    draw(image);
    std::set<int> squares;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (image.y[y * width + x] != 0) squares.insert(y / square_height * 3 + x / square_width);
    return squares;
  };
  EXPECT_EQ(changed([&](MovieImage& image) { pixels.draw(layers.all(), 0, image); }), std::set<int>{});
  EXPECT_EQ(changed([&](MovieImage& image) { pixels.draw(layers.all(), 1, image); }), std::set<int>{4});
  const IntBox box{36, 12, 60, 18};
  EXPECT_EQ(changed([&](MovieImage& image) { pixels.draw(layers.all(), {&box, 1}, image); }), (std::set<int>{1, 4}));
}

}  // namespace
}  // namespace weir
