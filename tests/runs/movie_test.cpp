// The movie of a run shows what its PNG files show: decoded frames against the files, pixel by pixel.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "output/decode.h"
#include "render/colormap.h"
#include "render/palette.h"
#include "runs/scenes.h"

namespace weir::test {
namespace {

// dB, over red, green and blue.
double psnr(const Image& a, const Image& b) {
  double squares = 0;
  for (std::size_t k = 0; k < a.rgba.size(); ++k)
    if (k % 4 != 3) squares += std::pow(a.rgba[k] - b.rgba[k], 2);
  return 10 * std::log10(255.0 * 255.0 * 3 * a.width * a.height / squares);
}

// What is left of a picture whose chroma is kept once per 2 x 2 pixels, beside their left edge, and spread again, both
// by the plainest linear filters (1 2 1 across, the mean of two rows; straight lines between samples), in BT.709
// [Rec. ITU-R BT.709-6, 3.2] without rounding: the cost of 4:2:0 and nothing else.
Image with_halved_chroma(const Image& image) {
  const int width = image.width;
  const int height = image.height;
  const auto luma = [&](int x, int y) {
    const std::uint8_t* rgb = image.pixel(x, y);
    return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
  };
  // Channel 0 or 2 less luma at chroma sample (i, j); beyond the edge the picture goes on as it ends.
  const auto sample = [&](int i, int j, std::size_t channel) {
    const int x = 2 * std::clamp(i, 0, width / 2 - 1);
    const int y = 2 * std::clamp(j, 0, height / 2 - 1);
    double sum = 0;
    for (int row = y; row < y + 2; ++row)
      for (const auto& [column, weight] : {std::pair(std::max(x - 1, 0), 1), std::pair(x, 2), std::pair(x + 1, 1)})
        sum += weight * (image.pixel(column, row)[channel] - luma(column, row)) / 8;
    return sum;
  };
  const auto chroma = [&](int x, int y, std::size_t channel) {
    const int i = x / 2;
    const int j = y / 2;
    const int other_row = y % 2 == 0 ? j - 1 : j + 1;  // samples lie between rows: a quarter and three quarters
    const auto across = [&](int row) {
      return x % 2 == 0 ? sample(i, row, channel) : (sample(i, row, channel) + sample(i + 1, row, channel)) / 2;
    };
    return 0.75 * across(j) + 0.25 * across(other_row);
  };
  Image result = image;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double red = chroma(x, y, 0);
      const double blue = chroma(x, y, 2);
      const double green = -(0.2126 * red + 0.0722 * blue) / 0.7152;
      for (const auto& [channel, difference] : {std::pair(0, red), std::pair(1, green), std::pair(2, blue)})
        result.pixel(x, y)[channel] =
            static_cast<std::uint8_t>(std::lround(std::clamp(luma(x, y) + difference, 0.0, 255.0)));
    }
  return result;
}

// Whether all pixels within `reach` have the colour of this one.
bool uniform_around(const Image& image, int x, int y, int reach) {
  if (x < reach || y < reach || x + reach >= image.width || y + reach >= image.height) return false;
  const std::uint8_t* center = image.pixel(x, y);
  for (int v = y - reach; v <= y + reach; ++v)
    for (int u = x - reach; u <= x + reach; ++u)
      if (!std::equal(center, center + 3, image.pixel(u, v))) return false;
  return true;
}

struct Area {
  long long pixels = 0;
  int largest = 0;  // error of any channel, of 255
};
Area uniform_areas(const Image& picture, const Image& decoded, int reach) {
  Area area;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      if (!uniform_around(picture, x, y, reach)) continue;
      ++area.pixels;
      for (int c = 0; c < 3; ++c)
        area.largest = std::max(area.largest, std::abs(picture.pixel(x, y)[c] - decoded.pixel(x, y)[c]));
    }
  return area;
}

// Two bounds at the best quality. The error's power is at most twice (3 dB) what 4:2:0 costs by the plainest filters:
// room for libswscale's, which work in integers, for the rounding to 8 bits and for the encoder. And where a picture is
// uniform, 8 pixels around (beyond the filters' reach, and another block of the encoder's transform), rounding leaves
// 2/255 (see output/test_movie.cpp) and the encoder 1/255 more.
TEST(RunMovie, ShowsTheFrames) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    Scene scene = dam_break_run();
    scene.render.theme = theme;
    scene.output.movie = Movie{.quality = 0};
    const FinishedRun run(scene);
    int decoded = 0;
    decode_movie(run.movie(), [&](std::int64_t index, const Image& image) {
      SCOPED_TRACE(fmt::format("{} theme, frame {}", theme == Theme::light ? "light" : "dark", index));
      const Image picture = run.frame(static_cast<int>(index));
      ++decoded;
      ASSERT_EQ(image.width, picture.width);
      ASSERT_EQ(image.height, picture.height);
      EXPECT_GT(psnr(picture, image), psnr(picture, with_halved_chroma(picture)) - 3);
      const Area area = uniform_areas(picture, image, 8);
      EXPECT_GT(area.pixels, picture.width * picture.height / 4);
      EXPECT_LE(area.largest, 3);
    });
    EXPECT_EQ(decoded, run.frames());
  }
}

// Both the files and the movie show this colour everywhere. A flat picture leaves rounding alone (at most 2/255: see
// output/test_movie.cpp); by BT.601's matrix, red would be off by 20.
void expect_one_color(const Scene& scene, std::uint32_t rgb) {
  const std::array<int, 3> wanted{static_cast<int>(rgb >> 16), static_cast<int>(rgb >> 8 & 0xff),
                                  static_cast<int>(rgb & 0xff)};
  const auto largest_error = [&](const Image& image) {
    int largest = 0;
    for (std::size_t k = 0; k < image.rgba.size(); ++k)
      if (k % 4 != 3) largest = std::max(largest, std::abs(image.rgba[k] - wanted[k % 4]));
    return largest;
  };
  const FinishedRun run(scene);
  decode_movie(run.movie(), [&](std::int64_t index, const Image& image) {
    EXPECT_EQ(largest_error(run.frame(static_cast<int>(index))), 0) << "frame " << index;
    EXPECT_LE(largest_error(image), 2) << "frame " << index;
  });
}

// A square that drifts, faster than the colour range, and a view into its middle particle, of radius 0.01 m.
Scene inside_a_particle() {
  Scene scene = dam_break_run();
  scene.gravity = Vec3(0);
  scene.walls.clear();
  scene.fluid.volumes = {{.shape = Box{Vec3(0), Vec3(0.1, 0.1, 0)}, .velocity = Vec3(1e-3, 0, 0)}};
  scene.camera.view = View2D{Vec3(0.05, 0.05, 0), 0.005};
  scene.render.color.range = {{0, 5e-4}};
  scene.render.overlay = {};
  scene.output.movie = Movie{.quality = 0};
  return scene;
}

TEST(RunMovie, GivesRedBack) {
  for (const ColormapName name : {ColormapName::coolwarm, ColormapName::turbo}) {
    Scene scene = inside_a_particle();
    scene.render.color.map = name;
    expect_one_color(scene, colormap(name).back());
  }
}

TEST(RunMovie, GivesTheWallsYellowBack) {
  Scene scene = inside_a_particle();
  scene.walls = {{.shape = Block{Vec3(0.2, 0, 0), Vec3(0.3, 0.1, 0)}, .layers = 2, .holes = {}}};
  scene.camera.view = View2D{Vec3(0.21, 0.05, 0), 0.005};
  expect_one_color(scene, wall_color);
}

}  // namespace
}  // namespace weir::test
