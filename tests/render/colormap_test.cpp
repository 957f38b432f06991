#include "render/colormap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

#include "render/test_scene.h"

namespace weir {
namespace {

// Entries as published: viridis and magma in matplotlib's _cm_listed.py (van der Walt and Smith), cividis in Nunez et
// al. 2018 (S1 table), turbo in Mikhailov's table, coolwarm's ends in Moreland 2009.
TEST(Colormap, HasThePublishedAnchors) {
  EXPECT_EQ(colormap(ColormapName::viridis)[0], 0x440154U);
  EXPECT_EQ(colormap(ColormapName::viridis)[128], 0x21918cU);
  EXPECT_EQ(colormap(ColormapName::viridis)[255], 0xfde725U);
  EXPECT_EQ(colormap(ColormapName::cividis)[0], 0x00224eU);
  EXPECT_EQ(colormap(ColormapName::cividis)[255], 0xfee838U);
  EXPECT_EQ(colormap(ColormapName::magma)[0], 0x000004U);
  EXPECT_EQ(colormap(ColormapName::magma)[255], 0xfcfdbfU);
  EXPECT_EQ(colormap(ColormapName::turbo)[0], 0x30123bU);
  EXPECT_EQ(colormap(ColormapName::turbo)[255], 0x7a0403U);
  EXPECT_EQ(colormap(ColormapName::coolwarm)[0], 0x3b4cc0U);
  EXPECT_EQ(colormap(ColormapName::coolwarm)[255], 0xb40426U);
}

// Mikhailov 2019 gives a polynomial of degree five beside the table, a fit with an error of at most 0.125, at the dark
// end. A reversed or shifted table, or exchanged channels, would have several times this error.
glm::dvec3 turbo_polynomial(double x) {
  const std::array<std::array<double, 6>, 3> c = {
      {{0.13572138, 4.61539260, -42.66032258, 132.13108234, -152.94239396, 59.28637943},
       {0.09140261, 2.19418839, 4.84296658, -14.18503333, 4.27729857, 2.82956604},
       {0.10667330, 12.64194608, -60.58204836, 110.36276771, -89.90310912, 27.34824973}}};
  glm::dvec3 rgb(0);
  for (int channel = 0; channel < 3; ++channel)
    for (int power = 5; power >= 0; --power) rgb[channel] = rgb[channel] * x + c[channel][power];
  return rgb;
}

glm::dvec3 entry(ColormapName name, int k) {
  const std::uint32_t color = colormap(name)[k];
  return glm::dvec3(color >> 16, color >> 8 & 0xff, color & 0xff) / 255.0;
}

TEST(Colormap, TurboFollowsItsPolynomial) {
  double worst = 0;
  for (int k = 0; k < 256; ++k) {
    const glm::dvec3 off = glm::abs(entry(ColormapName::turbo, k) - turbo_polynomial(k / 255.0));
    worst = std::max({worst, off.x, off.y, off.z});
  }
  EXPECT_LT(worst, 0.13);
}

// CIE lightness of an sRGB colour, 0 .. 100.
double lightness(const glm::dvec3& srgb) {
  glm::dvec3 linear;
  for (int c = 0; c < 3; ++c)
    linear[c] = srgb[c] <= 0.04045 ? srgb[c] / 12.92 : std::pow((srgb[c] + 0.055) / 1.055, 2.4);
  const double y = glm::dot(linear, glm::dvec3(0.2126, 0.7152, 0.0722));
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

// These maps are perceptually uniform: equal steps of the quantity are equal steps of lightness.
TEST(Colormap, SequentialMapsRiseEvenlyInLightness) {
  for (const ColormapName name : {ColormapName::viridis, ColormapName::cividis, ColormapName::magma})
    for (int k = 1; k < 256; ++k) {
      const double step = lightness(entry(name, k)) - lightness(entry(name, k - 1));
      EXPECT_GT(step, -0.35) << k;  // rounding to 8 bits moves lightness by up to a third
      EXPECT_LT(step, 1.2) << k;
    }
}

// Moreland 2009: lightness rises to the middle and falls behind it, the same on both sides.
TEST(Colormap, CoolwarmIsLightestInTheMiddle) {
  for (int k = 1; k < 128; ++k) {
    EXPECT_GT(lightness(entry(ColormapName::coolwarm, k)), lightness(entry(ColormapName::coolwarm, k - 1)) - 0.35);
    EXPECT_GT(lightness(entry(ColormapName::coolwarm, 255 - k)),
              lightness(entry(ColormapName::coolwarm, 256 - k)) - 0.35);
  }
  const glm::dvec3 middle = entry(ColormapName::coolwarm, 128);
  EXPECT_NEAR(middle.x, 221 / 255.0, 1.5 / 255);  // (221, 221, 221) in the paper's table
  EXPECT_NEAR(middle.y, 221 / 255.0, 1.5 / 255);
  EXPECT_NEAR(middle.z, 221 / 255.0, 1.5 / 255);
}

TEST(Colormap, TakesTheNearestEntryAndClampsOutside) {
  EXPECT_EQ(colormap_index(-1, {0, 5}), 0);
  EXPECT_EQ(colormap_index(9, {0, 5}), 255);
  EXPECT_EQ(colormap_index(5 * 100.4 / 255, {0, 5}), 100);
  EXPECT_EQ(colormap_index(5 * 100.6 / 255, {0, 5}), 101);
}

TEST(ColorRange, IsTheScenesIfGiven) {
  test::Still still = test::dam_break();
  still.scene.render.color.range = {{1, 2.5}};
  EXPECT_EQ(color_range(still.scene, still.static_scene), (std::array<double, 2>{1, 2.5}));
}

TEST(ColorRange, IsEstimatedFromTheSpeed) {
  test::Still still = test::dam_break();  // 4.43 m/s = sqrt(2 g 1 m)
  EXPECT_EQ(color_range(still.scene, still.static_scene), (std::array<double, 2>{0, 5}));
  // rho0 v^2 / 2 = rho0 g H = 9,812 Pa.
  still.scene.render.color.by = Quantity::pressure;
  EXPECT_EQ(color_range(still.scene, still.static_scene), (std::array<double, 2>{0, 10000}));
  // The same pressure over n k = 7 * 1e5 Pa: 14.02 kg/m^3.
  still.scene.render.color.by = Quantity::density;
  EXPECT_EQ(color_range(still.scene, still.static_scene), (std::array<double, 2>{985, 1015}));
  // Over rho0 c0^2 = 1e3 * 20^2 * 9.81 Pa: 2.5 kg/m^3, a little more by the rounding of 4.43.
  still.scene.solver.compressibility = SoundSpeed{20 * std::sqrt(9.81)};
  EXPECT_EQ(color_range(still.scene, still.static_scene), (std::array<double, 2>{997, 1003}));
}

TEST(ColorRange, OfAFluidAtRestIsNotEmpty) {
  test::Still still = test::dam_break();
  still.static_scene.max_speed_estimate = 0;
  for (const QuantityFacts& facts : quantities) {
    if (!facts.colours()) continue;
    still.scene.render.color.by = facts.quantity;
    const std::array<double, 2> range = color_range(still.scene, still.static_scene);
    EXPECT_LT(range[0], range[1]) << facts.name;
  }
}

TEST(ColorRange, OfNumbersReachesTheLast) {
  test::Still still = test::dam_break();
  still.scene.render.color.by = Quantity::id;
  EXPECT_EQ(color_range(still.scene, still.static_scene), (std::array<double, 2>{0, 33 * 33 - 1}));
  still.scene.fluid.volumes.resize(4, still.scene.fluid.volumes.front());
  still.scene.render.color.by = Quantity::volume;
  EXPECT_EQ(color_range(still.scene, still.static_scene), (std::array<double, 2>{0, 3}));
}

}  // namespace
}  // namespace weir
