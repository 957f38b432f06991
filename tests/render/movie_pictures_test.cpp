// Movie frames against the same pictures as drawn for PNG files.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>

#include "render/test_scene.h"
#include "support/golden.h"
#include "support/movie_image.h"

namespace weir::test {
namespace {

std::unique_ptr<Renderer> renderer_of(const Still& still, MovieBy who) {
  DeviceChoice choice = device_choice("");
  choice.movie_by = who;
  return make_renderer(still.scene, still.static_scene, choice);
}

MovieImage filmed(const Still& still, MovieBy who) {
  const auto renderer = renderer_of(still, who);
  MovieImage image;
  renderer->start(still.frame);
  renderer->finish(image);
  return image;
}

// Composed by the device, as other pictures, and by the processor.
class MoviePicture : public ::testing::TestWithParam<MovieBy> {
 protected:
  MovieImage filmed(const Still& still) const { return test::filmed(still, GetParam()); }
  void expect_converted(const Still& still) const;
};
INSTANTIATE_TEST_SUITE_P(By, MoviePicture, ::testing::Values(MovieBy::device, MovieBy::processor),
                         [](const auto& test) { return test.param == MovieBy::device ? "Device" : "Processor"; });

int largest_error(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
  EXPECT_EQ(a.size(), b.size());
  int largest = 0;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

// The reference converts RGB that has been rounded to 8 bits. Half a step of each channel is 0.5 * 219/255 = 0.43 of Y,
// and of chroma at most 0.5 * 224/255 = 0.44 times the sum of its weights, 1; the last rounding adds a half.
void MoviePicture::expect_converted(const Still& still) const {
  const MovieImage wanted = testing::movie_image(drawn(still));
  const MovieImage found = filmed(still);
  EXPECT_EQ(found.width, wanted.width);
  EXPECT_EQ(found.height, wanted.height);
  EXPECT_LE(largest_error(found.y, wanted.y), 1);
  EXPECT_LE(largest_error(found.cb, wanted.cb), 1);
  EXPECT_LE(largest_error(found.cr, wanted.cr), 1);
}

TEST_P(MoviePicture, IsTheConvertedPicture) { expect_converted(dam_break()); }

TEST_P(MoviePicture, IsTheConvertedPictureOfEveryMapAndTheme) {
  Still still = dam_break();
  still.scene.camera.view = View2D{Vec3(1, 0.2, 0), 0.5};
  for (const ColormapName name : {ColormapName::turbo, ColormapName::coolwarm, ColormapName::magma}) {
    still.scene.render.color.map = name;
    still.scene.render.theme = still.scene.render.theme == Theme::light ? Theme::dark : Theme::light;
    expect_converted(still);
  }
}

TEST_P(MoviePicture, IsTheConvertedPictureOfDotsAndBalls) {
  Still small = dam_break();
  small.scene.camera.view = View2D{Vec3(1, 0.5, 0), 8};
  expect_converted(small);
  expect_converted(cup());
}

TEST_P(MoviePicture, MayBeOfAnyEvenSize) {
  for (const int width : {318, 320, 322, 16, 18}) {
    Still still = dam_break();
    still.scene.render.size = {width, 94};
    expect_converted(still);
  }
}

// A straight edge between pixels 99 and 100: the sample at pixel 100 has a weight of 1/4 for pixel 99; no other sample
// mixes.
TEST_P(MoviePicture, HasItsChromaOnTheLeft) {
  Still still = blank(1);
  still.static_scene.particle_spacing = 2e4;
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

TEST_P(MoviePicture, OfATransparentSceneLiesBeforeTheBackground) {
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

void expect_same(const MovieImage& a, const MovieImage& b, std::size_t k) {
  EXPECT_EQ(largest_error(a.y, b.y), 0) << k;
  EXPECT_EQ(largest_error(a.cb, b.cb), 0) << k;
  EXPECT_EQ(largest_error(a.cr, b.cr), 0) << k;
}

// Unchanged particles, times that change, and a camera that moves.
struct Row {
  Still still = dam_break();
  std::vector<Frame> frames{9, still.frame};

  Row() {
    still.scene.camera.keyframes = {{0.5, View2D{Vec3(0.5, 0.5, 0), 1}}, {0.6, View2D{Vec3(1, 0.5, 0), 4}}};
    for (std::size_t k = 0; k < frames.size(); ++k) frames[k].time = 0.1 * static_cast<double>(k);
    for (const std::size_t k : {1, 6, 8})
      for (glm::vec4& particle : frames[k].particles) particle.x += 0.3f * static_cast<float>(k);
    frames[3] = frames[4];  // nothing changes at all
    frames[7].particles.clear();
  }
};

// With as many started frames as in a run.
TEST_P(MoviePicture, OfARowIsWhatAFreshRendererDraws) {
  Row row;
  const auto renderer = renderer_of(row.still, GetParam());
  std::size_t next = 0;
  const auto expect_next = [&] {
    MovieImage found;
    renderer->finish(found);
    row.still.frame = row.frames[next];
    expect_same(found, filmed(row.still), next++);
  };
  for (std::size_t k = 0; k < row.frames.size(); ++k) {
    renderer->start(row.frames[k]);
    if (k + 1 - next == renderer->most_under_way()) expect_next();
  }
  while (next < row.frames.size()) expect_next();
}

// Reused images show older pictures, are copies, are of another renderer or size, or were overwritten and marked so.
TEST_P(MoviePicture, DrawnOverAnotherIsWhatAFreshRendererDraws) {
  Row row;
  const auto renderer = renderer_of(row.still, GetParam());
  std::vector<MovieImage> images(3);
  images[2] = filmed(row.still);
  constexpr std::array<std::size_t, 9> order = {0, 1, 0, 0, 1, 2, 1, 2, 0};
  for (std::size_t k = 0; k < row.frames.size(); ++k) {
    MovieImage& image = images[order[k]];
    if (k == 4) image = images[0];
    if (k == 6) image.resize(64, 36);
    if (k == 7) {
      std::fill(image.y.begin(), image.y.end(), std::uint8_t{0});
      image.known_as = 0;
    }
    renderer->start(row.frames[k]);
    renderer->finish(image);
    row.still.frame = row.frames[k];
    expect_same(image, filmed(row.still), k);
  }
}

// The tests use llvmpipe, a software device.
TEST(MoviePictures, AreComposedByTheProcessorOnASoftwareDevice) {
  const Still still = blank(1);
  const auto fitting = renderer_of(still, MovieBy::fitting);
  if (fitting->gl_renderer().find("llvmpipe") == std::string::npos) GTEST_SKIP() << fitting->gl_renderer();
  EXPECT_EQ(fitting->most_under_way(), renderer_of(still, MovieBy::processor)->most_under_way());
  EXPECT_NE(fitting->most_under_way(), renderer_of(still, MovieBy::device)->most_under_way());
}

TEST(MoviePictures, AreTheSameFromDeviceAndProcessor) {
  Still discs = dam_break();
  Still transparent = discs;
  transparent.scene.render.transparent = true;
  Still dots = discs;
  dots.scene.camera.view = View2D{Vec3(1, 0.5, 0), 8};
  for (const Still& still : {discs, transparent, dots, cup()}) {
    const MovieImage by_device = filmed(still, MovieBy::device);
    const MovieImage by_processor = filmed(still, MovieBy::processor);
    EXPECT_LE(largest_error(by_device.y, by_processor.y), 1);
    EXPECT_LE(largest_error(by_device.cb, by_processor.cb), 1);
    EXPECT_LE(largest_error(by_device.cr, by_processor.cr), 1);
  }
}

}  // namespace
}  // namespace weir::test
