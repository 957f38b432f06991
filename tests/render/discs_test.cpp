// Properties of drawn particles, from their pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "render/colormap.h"
#include "render/palette.h"
#include "render/test_scene.h"
#include "support/golden.h"

namespace weir::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

// How much of a pixel a disc of viridis' lowest colour (68, 1, 84) covers on white: the green channel tells it best, in
// steps of 1/254.
double coverage(const Image& image, int x, int y) { return (255 - image.pixel(x, y)[1]) / 254.0; }

struct Blob {
  double area = 0;       // pixels
  glm::dvec2 center{0};  // pixels
};
Blob blob(const Image& image) {
  Blob found;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      found.area += coverage(image, x, y);
      found.center += coverage(image, x, y) * glm::dvec2(x + 0.5, y + 0.5);
    }
  found.center /= found.area;
  return found;
}

// One particle of `radius` pixels at an offset in pixels from the picture's centre.
Still one_disc(double radius, glm::dvec2 at) {
  Still still = blank(1);  // a metre is a pixel
  still.static_scene.particle_spacing = 2 * radius;
  still.frame.particles = {glm::vec4(at.x, at.y, 0, 0)};
  return still;
}

std::uint32_t rgb(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return static_cast<std::uint32_t>(p[0]) << 16 | static_cast<std::uint32_t>(p[1]) << 8 | p[2];
}

class DiscOfRadius : public testing::TestWithParam<double> {};

// Dots keep area and centre exactly. A disc's edge is a smooth step that has the right integral over the plane; what
// the sum over pixels makes of it was worked out in double precision for a thousand places of the centre between
// pixels: at a radius of 1.13 the area is off by up to 2.5 % and the centre by 0.023 pixels, at 1.5 by 0.9 % and 0.034,
// at 3.3 by 0.54 % and 0.011, at 10 by 0.03 % and 0.008. On top, each of the 8 r + 4 pixels on the edge is rounded to
// 1/254.
TEST_P(DiscOfRadius, CoversItsAreaAroundItsCentre) {
  const double radius = GetParam();
  const double area = std::numbers::pi * radius * radius;
  const bool is_dot = radius < 1.128;
  const double drawn_radius = std::max(radius, 1.0);
  const double sampling = is_dot ? 0 : radius < 1.5 ? 0.025 : 0.018 / radius;
  const double tolerance = sampling + (8 * drawn_radius + 4) * 0.5 / 254 / area;
  for (const glm::dvec2 at : {glm::dvec2(0), glm::dvec2(0.5, 0), glm::dvec2(0.25, 0.4), glm::dvec2(-3.37, 2.71)}) {
    const Blob found = blob(drawn(one_disc(radius, at)));
    EXPECT_NEAR(found.area / area, 1, tolerance) << radius;
    EXPECT_NEAR(found.center.x, 160 + at.x, is_dot ? 0.02 + 0.01 / area : 0.02 + 0.02 / radius);
    EXPECT_NEAR(found.center.y, 90 - at.y, is_dot ? 0.02 + 0.01 / area : 0.02 + 0.02 / radius);
  }
}
INSTANTIATE_TEST_SUITE_P(Discs, DiscOfRadius, testing::Values(0.35, 0.7, 1.13, 1.5, 3.3, 10, 60));

// The mean over 64 x 64 points of the pixel, each inside or outside; itself good to about 1/64 at a straight edge.
double counted_coverage(int x, int y, glm::dvec2 center, double radius) {
  int inside = 0;
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 64; ++j)
      if (glm::distance(glm::dvec2(x + (i + 0.5) / 64, y + (j + 0.5) / 64), center) < radius) ++inside;
  return inside / 4096.0;
}

// The smooth step differs from the share that a straight edge cuts off by up to 0.043: an edge along the pixels that
// just touches one leaves it 7/8 of the step, 1 - (7/8)^2 (3 - 7/4). Rounding and counting come on top.
TEST(Discs, EachPixelHasTheCoverageThatCountingPointsGives) {
  for (const double radius : {1.5, 4.2, 9.7}) {
    const glm::dvec2 at(0.3, -0.15);
    const Image image = drawn(one_disc(radius, at));
    for (int y = 78; y < 102; ++y)
      for (int x = 148; x < 172; ++x)
        EXPECT_NEAR(coverage(image, x, y), counted_coverage(x, y, {160.3, 90.15}, radius), 0.043 + 0.5 / 254 + 1.0 / 64)
            << x << " " << y << " " << radius;
  }
}

TEST(Discs, HaveTheMapsColourAtAKnownSpeed) {
  Still still = one_disc(10, {0, 0});
  still.scene.render.color.range = {{0, 5}};
  for (const ColormapName name : {ColormapName::viridis, ColormapName::cividis, ColormapName::magma,
                                  ColormapName::turbo, ColormapName::coolwarm}) {
    still.scene.render.color.map = name;
    for (const float speed : {0.0f, 1.0f, 2.5f, 4.9f, 5.0f, 77.0f, -1.0f}) {
      still.frame.particles[0].w = speed;
      EXPECT_EQ(rgb(drawn(still), 160, 90), colormap(name)[colormap_index(speed, {0, 5})]) << speed;
    }
  }
}

TEST(Discs, TheNearestCentreLiesOnTop) {
  Still still = one_disc(10, {0, 0});
  still.frame.particles = {glm::vec4(0, 0, 0, 0), glm::vec4(8, 0, 0, 1)};
  const Image image = drawn(still);
  EXPECT_EQ(rgb(image, 162, 90), colormap(ColormapName::viridis)[0]);    // 2.5 from one, 5.5 from the other
  EXPECT_EQ(rgb(image, 165, 90), colormap(ColormapName::viridis)[255]);  // the other way round
}

TEST(Discs, AreTheSamePixelsInAnyOrder) {
  for (const double radius : {0.4, 0.8, 1.3, 4.0, 30.0}) {  // dots of both kinds, discs that touch and that overlap
    Still still = one_disc(radius, {0, 0});
    auto& particles = still.frame.particles;
    particles.clear();
    for (int i = -40; i < 40; ++i)
      for (int j = -25; j < 25; ++j)  // half of them on a lattice, where distances are equal
        particles.emplace_back(1.9 * std::min(radius, 4.0) * i + (j % 2) * 0.3 * std::sin(12.9898 * i + 78.233 * j),
                               1.9 * std::min(radius, 4.0) * j, 0.0, 0.5 + 0.5 * std::sin(3.0 * i + 5.0 * j));
    const Image image = drawn(still);
    std::reverse(particles.begin(), particles.end());
    EXPECT_EQ(difference(drawn(still), image).pixels, 0) << radius;
    for (std::size_t k = 0; k < particles.size(); ++k)
      std::swap(particles[k], particles[(k * 7919) % particles.size()]);
    EXPECT_EQ(difference(drawn(still), image).pixels, 0) << radius;
  }
}

TEST(Discs, NoneLeaveTheBackground) {
  Still still = blank(1);
  const Image image = drawn(still);
  EXPECT_EQ(image.width, 320);
  EXPECT_EQ(image.height, 180);
  EXPECT_TRUE(std::all_of(image.rgba.begin(), image.rgba.end(), [](std::uint8_t v) { return v == 255; }));
  still.scene.render.theme = Theme::dark;
  const Rgb dark = palette(Theme::dark).background;
  EXPECT_EQ(rgb(drawn(still), 5, 5),
            static_cast<std::uint32_t>(dark.r) << 16 | static_cast<std::uint32_t>(dark.g) << 8 | dark.b);
}

TEST(Discs, OffThePictureAreNotDrawn) {
  Still still = one_disc(10, {0, 0});
  still.frame.particles = {glm::vec4(171, 0, 0, 0), glm::vec4(0, -101, 0, 0), glm::vec4(1e6f, 1e6f, 0, 0),
                           glm::vec4(-3e38f, 3e38f, 0, 0)};
  EXPECT_EQ(difference(drawn(still), drawn(blank(1))).pixels, 0);
}

// Points are dropped when their centre is outside the viewport; ours is larger than the picture.
TEST(Discs, ReachInFromOutside) {
  for (const double radius : {3.0, 12.0, 100.0}) {
    const double reach = 2;  // pixels of the disc that are inside
    const double off = radius - reach;
    EXPECT_GT(coverage(drawn(one_disc(radius, {160 + off, 0})), 319, 90), 0.9) << radius;
    EXPECT_GT(coverage(drawn(one_disc(radius, {-160 - off, 0})), 0, 90), 0.9) << radius;
    EXPECT_GT(coverage(drawn(one_disc(radius, {0, 90 + off})), 160, 0), 0.9) << radius;
    EXPECT_GT(coverage(drawn(one_disc(radius, {0, -90 - off})), 160, 179), 0.9) << radius;
  }
}

TEST(Discs, OneMayFillThePicture) {
  const Image image = drawn(one_disc(1e5, {0, 0}));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) ASSERT_EQ(rgb(image, x, y), 0x440154U) << x << " " << y;
}

TEST(Discs, ThatAreNotFiniteAreSkipped) {
  Still still = dam_break();
  const Image expected = drawn(still);
  auto& particles = still.frame.particles;
  particles.insert(particles.begin(), {not_a_number, 1, 0, 1});
  particles.insert(particles.begin() + 100, {1, infinity, 0, 1});
  particles.push_back({1, 1, 0, not_a_number});
  EXPECT_EQ(difference(drawn(still), expected).pixels, 0);
}

TEST(Discs, ASecondFrameIsWhatAFreshRendererDraws) {
  Still still = dam_break();
  const Image fresh = drawn(still);
  const auto renderer = make_renderer(still.scene, still.static_scene, device_choice(""));
  Frame other = still.frame;
  other.time = 0;
  for (glm::vec4& particle : other.particles) particle.x += 1;
  other.particles.resize(500);
  Image image;
  renderer->draw(other, image);
  EXPECT_GT(difference(image, fresh).pixels, 1000);
  renderer->draw(still.frame, image);
  EXPECT_EQ(difference(image, fresh).pixels, 0);
}

TEST(Discs, TwoRenderersLiveSideBySide) {
  const Still a = dam_break();
  const Still b = cup();
  const Image fresh_a = drawn(a);
  const Image fresh_b = drawn(b);
  const auto renderer_a = make_renderer(a.scene, a.static_scene, device_choice(""));
  const auto renderer_b = make_renderer(b.scene, b.static_scene, device_choice(""));
  Image image;
  renderer_a->draw(a.frame, image);
  EXPECT_EQ(difference(image, fresh_a).pixels, 0);
  list_devices();  // opens contexts of its own
  renderer_b->draw(b.frame, image);
  EXPECT_EQ(difference(image, fresh_b).pixels, 0);
  renderer_a->draw(a.frame, image);
  EXPECT_EQ(difference(image, fresh_a).pixels, 0);
}

TEST(Discs, FollowTheKeyframes) {
  Still still = dam_break();
  still.scene.camera.keyframes = {{0, View2D{Vec3(0.5, 0.5, 0), 1}}, {1, View2D{Vec3(1, 0.5, 0), 4}}};
  const auto renderer = make_renderer(still.scene, still.static_scene, device_choice(""));
  Image image;
  for (const double time : {0.0, 0.6, 5.0}) {  // walls are drawn again each time
    still.frame.time = time;
    renderer->draw(still.frame, image);
    EXPECT_EQ(difference(image, drawn(still)).pixels, 0);
  }
  Still fixed = still;
  fixed.scene.camera = {View2D{Vec3(1, 0.5, 0), 4}, {}};
  EXPECT_EQ(difference(image, drawn(fixed)).pixels, 0);
}

TEST(Walls, AreYellowAndCanBeLeftOut) {
  Still still = blank(20);
  still.static_scene.walls = {glm::vec3(0)};
  const Image image = drawn(still);
  EXPECT_EQ(rgb(image, 160, 90), wall_color);
  EXPECT_GT(image.pixel(160, 90)[0], 220);  // yellow to the eye, too: red and green high, blue low
  EXPECT_GT(image.pixel(160, 90)[1], 160);
  EXPECT_LT(image.pixel(160, 90)[2], 60);
  still.scene.render.walls = false;
  EXPECT_EQ(rgb(drawn(still), 160, 90), 0xffffffU);
}

TEST(Walls, LieBehindTheFluid) {
  Still still = blank(20);
  still.static_scene.walls = {glm::vec3(0)};
  still.frame.particles = {glm::vec4(0, 0, 0, 0)};
  EXPECT_EQ(rgb(drawn(still), 160, 90), 0x440154U);
}

TEST(Transparent, BackgroundHasNoAlphaAndDiscsHaveAll) {
  Still still = one_disc(10, {0, 0});
  still.scene.render.transparent = true;
  const Image image = drawn(still);
  EXPECT_EQ(image.pixel(5, 5)[3], 0);
  EXPECT_EQ(image.pixel(160, 90)[3], 255);
  double area = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) area += image.pixel(x, y)[3] / 255.0;
  EXPECT_NEAR(area / (100 * std::numbers::pi), 1, 0.005);
  // Alpha is straight: at the edge the colour is still the disc's, but for rounding at low alpha.
  for (int x = 145; x < 175; ++x) {
    if (image.pixel(x, 90)[3] > 64) {
      EXPECT_NEAR(image.pixel(x, 90)[2], 84, 3);
    }
  }
}

// A page that shows the picture lays it over its colour; on white this is the picture drawn on white. Two roundings
// more: the colour with alpha, and alpha itself.
TEST(Transparent, OverWhiteIsThePictureOnWhite) {
  Still still = dam_break();
  const Image opaque = drawn(still);
  still.scene.render.transparent = true;
  const Image clear = drawn(still);
  for (std::size_t k = 0; k < clear.rgba.size(); k += 4)
    for (std::size_t c = k; c < k + 3; ++c) {
      const double alpha = clear.rgba[k + 3] / 255.0;
      ASSERT_NEAR(alpha * clear.rgba[c] + (1 - alpha) * 255, opaque.rgba[c], 3) << k / 4 % 320 << " " << k / 4 / 320;
    }
}

TEST(Balls, NearOnesHideFarOnesWhateverTheirOrder) {
  Still still = blank(1);
  still.scene.dimension = 3;
  still.scene.camera.view = View3D{Vec3(0, -10, 0), Vec3(0), 30};
  still.scene.render.color.map = ColormapName::turbo;
  still.frame.particles = {glm::vec4(0, -1, 0, 0.1), glm::vec4(0, 1, 0, 0.9)};  // bluish in front of reddish
  const Image image = drawn(still);
  EXPECT_GT(image.pixel(160, 90)[2], image.pixel(160, 90)[0]);
  std::swap(still.frame.particles[0], still.frame.particles[1]);
  EXPECT_EQ(difference(drawn(still), image).pixels, 0);
}

TEST(Balls, AreTheSamePixelsInAnyOrder) {
  Still still = cup();
  const Image image = drawn(still);
  std::reverse(still.frame.particles.begin(), still.frame.particles.end());
  EXPECT_EQ(difference(drawn(still), image).pixels, 0);
}

TEST(Balls, HaveTheSizeThatPerspectiveGives) {
  Still still = blank(1);
  still.scene.dimension = 3;
  still.scene.camera.view = View3D{Vec3(0, -10, 0), Vec3(0), 30};
  still.scene.render.transparent = true;  // alpha does not depend on the shading
  still.frame.particles = {glm::vec4(0.3, 0, 0.2, 0)};
  const Image image = drawn(still);
  double area = 0;
  for (std::size_t k = 3; k < image.rgba.size(); k += 4) area += image.rgba[k] / 255.0;
  const double radius = 0.5 * 90 / (10 * std::tan(glm::radians(15.0)));  // pixels
  EXPECT_NEAR(area / (std::numbers::pi * radius * radius), 1, 0.005);
}

TEST(Balls, BehindTheEyeOrAtItAreNotDrawn) {
  Still still = blank(1);
  still.scene.dimension = 3;
  still.scene.camera.view = View3D{Vec3(0, -10, 0), Vec3(0), 30};
  still.frame.particles = {glm::vec4(0, -12, 0, 0), glm::vec4(0, -10, 0, 0), glm::vec4(0, -9.9, 0, 0)};
  const Image image = drawn(still);
  EXPECT_TRUE(std::all_of(image.rgba.begin(), image.rgba.end(), [](std::uint8_t v) { return v == 255; }));
}

TEST(Balls, AreNotHiddenByWalls) {
  Still still = blank(1);
  still.scene.dimension = 3;
  still.scene.camera.view = View3D{Vec3(0, -10, 0), Vec3(0), 30};
  still.frame.particles = {glm::vec4(0, 0, 0, 0.5)};
  const Image without = drawn(still);
  still.static_scene.walls = {glm::vec3(0, -2, 0), glm::vec3(2.5, 0, 0)};
  const Image with = drawn(still);
  EXPECT_EQ(rgb(with, 160, 90), rgb(without, 160, 90));
  EXPECT_GT(difference(with, without).pixels, 10);  // the one beside the ball is seen
}

}  // namespace
}  // namespace weir::test
