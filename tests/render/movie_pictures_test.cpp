// Pictures drawn for a movie against the same pictures as PNG files would hold them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "render/test_scene.h"
#include "support/golden.h"
#include "support/movie_image.h"

namespace weir::test {
namespace {

MovieImage filmed(const Still& still) {
  const auto renderer = make_renderer(still.scene, still.still_life, device_choice(""));
  MovieImage image;
  renderer->start(still.frame);
  renderer->finish(image);
  return image;
}

int largest_error(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  EXPECT_EQ(a.size(), b.size());
  int largest = 0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

// The reference converts RGB that has been rounded to 8 bits. Half a step of each channel is 0.5 * 219/255 = 0.43 of Y,
// and of chroma at most 0.5 * 224/255 = 0.44 times the sum of its weights, 1; the last rounding adds a half.
void expect_converted(const Still& still) {
  const MovieImage wanted = testing::movie_image(drawn(still));
  const MovieImage found = filmed(still);
  EXPECT_EQ(found.width, wanted.width);
  EXPECT_EQ(found.height, wanted.height);
  EXPECT_LE(largest_error(found.y, wanted.y), 1);
  EXPECT_LE(largest_error(found.cb, wanted.cb), 1);
  EXPECT_LE(largest_error(found.cr, wanted.cr), 1);
}

TEST(MoviePicture, IsTheConvertedPicture) { expect_converted(dam_break()); }

TEST(MoviePicture, IsTheConvertedPictureOfEveryMapAndTheme) {
  Still still = dam_break();
  still.scene.camera.view = View2D{Vec3(1, 0.2, 0), 0.5};
  for (const ColormapName name : {ColormapName::turbo, ColormapName::coolwarm, ColormapName::magma}) {
    still.scene.render.color.map = name;
    still.scene.render.theme = still.scene.render.theme == Theme::light ? Theme::dark : Theme::light;
    expect_converted(still);
  }
}

TEST(MoviePicture, IsTheConvertedPictureOfDotsAndBalls) {
  Still small = dam_break();
  small.scene.camera.view = View2D{Vec3(1, 0.5, 0), 8};
  expect_converted(small);
  expect_converted(cup());
}

TEST(MoviePicture, MayBeOfAnyEvenSize) {
  for (const int width : {318, 320, 322, 16, 18}) {
    Still still = dam_break();
    still.scene.render.size = {width, 94};
    expect_converted(still);
  }
}

// A straight edge between pixels 99 and 100: the sample at pixel 100 takes a quarter from pixel 99, and no other mixes.
TEST(MoviePicture, HasItsChromaOnTheLeft) {
  Still still = blank(1);
  still.still_life.particle_spacing = 2e4;
  still.scene.render.color.map = ColormapName::turbo;
  still.frame.particles = {glm::vec4(-160 + 100 + 1e4, 0, 0, 0.2)};
  const MovieImage image = filmed(still);
  const auto row = image.cb.begin() + 45 * 160;
  const double before = row[48];
  const double behind = row[52];
  ASSERT_GT(std::abs(before - behind), 20);
  EXPECT_NEAR(row[49], before, 1);                         // pixels 97, 98, 99
  EXPECT_NEAR(row[50], 0.25 * before + 0.75 * behind, 1);  // pixels 99, 100, 101
  EXPECT_NEAR(row[51], behind, 1);
}

TEST(MoviePicture, OfATransparentSceneLiesBeforeTheBackground) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    Still still = dam_break();
    still.scene.render.overlay = {};
    still.scene.render.theme = theme;
    const MovieImage opaque = filmed(still);
    still.scene.render.transparent = true;
    const MovieImage clear = filmed(still);
    EXPECT_LE(largest_error(clear.y, opaque.y), 1);
    EXPECT_LE(largest_error(clear.cb, opaque.cb), 1);
    EXPECT_LE(largest_error(clear.cr, opaque.cr), 1);
  }
}

// Two under way, as a run has them; unchanged particles, times that change, and a camera that moves.
TEST(MoviePicture, OfARowIsWhatAFreshRendererDraws) {
  Still still = dam_break();
  still.scene.camera.keyframes = {{0.5, View2D{Vec3(0.5, 0.5, 0), 1}}, {0.6, View2D{Vec3(1, 0.5, 0), 4}}};
  std::vector<Frame> frames(9, still.frame);
  for (std::size_t k = 0; k < frames.size(); ++k) frames[k].time = 0.1 * static_cast<double>(k);
  for (const std::size_t k : {1, 6, 8})
    for (glm::vec4& particle : frames[k].particles) particle.x += 0.3f * static_cast<float>(k);
  frames[3] = frames[4];  // nothing changes at all
  frames[7].particles.clear();
  const auto renderer = make_renderer(still.scene, still.still_life, device_choice(""));
  const auto expect_next = [&](std::size_t k) {
    MovieImage found;
    renderer->finish(found);
    still.frame = frames[k];
    const MovieImage wanted = filmed(still);
    EXPECT_EQ(largest_error(found.y, wanted.y), 0) << k;
    EXPECT_EQ(largest_error(found.cb, wanted.cb), 0) << k;
    EXPECT_EQ(largest_error(found.cr, wanted.cr), 0) << k;
  };
  for (std::size_t k = 0; k < frames.size(); ++k) {
    renderer->start(frames[k]);
    if (k > 0) expect_next(k - 1);
  }
  expect_next(frames.size() - 1);
}

}  // namespace
}  // namespace weir::test
