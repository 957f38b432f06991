#include "core/ticks.h"

#include <gmock/gmock.h>

#include <cmath>

namespace weir {
namespace {

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
  std::vector<std::string> texts;
  texts.reserve(ticks.size());
  for (const Tick& tick : ticks) texts.push_back(tick.label);
  return texts;
}

TEST(Ticks, AreMultiplesOfOneTwoOrFiveTimesAPowerOfTen) {
  for (const double low : {-3.7, -1e-7, 0.0, 0.013, 41.0, 9.9e6})
    for (const double span : {3e-9, 1e-3, 0.07, 1.0, 1.9, 6.0, 1e3, 4.4e8})
      for (const int most : {3, 5, 9}) {
        if (span < 1e-8 * std::abs(low)) continue;  // finer than the values themselves
        const auto ticks = linear_ticks(low, low + span, most);
        ASSERT_LE(ticks.size(), static_cast<std::size_t>(most)) << low << " + " << span;
        if (ticks.size() < 2) continue;
        const double step = ticks[1].value - ticks[0].value;
        const double digit = step / std::pow(10, std::floor(std::log10(step * (1 + 1e-6))));
        // The difference of two values near `low` is exact only to their rounding.
        const double rounding = 4e-16 * std::max(std::abs(low), span) / step * digit + 1e-9;
        EXPECT_TRUE(std::abs(digit - 1) < rounding || std::abs(digit - 2) < rounding || std::abs(digit - 5) < rounding)
            << step;
        for (const Tick& tick : ticks) {
          EXPECT_GE(tick.value, low - 1e-6 * span);
          EXPECT_LE(tick.value, low + span + 1e-6 * span);
        }
      }
}

TEST(Ticks, AreLabelledWithTheSameDecimals) {
  EXPECT_THAT(labels(linear_ticks(0, 1, 6)), testing::ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(labels(linear_ticks(-0.05, 0.06, 4)), testing::ElementsAre("−0.05", "0.00", "0.05"));
  EXPECT_THAT(labels(linear_ticks(0, 1000, 3)), testing::ElementsAre("0", "500", "1000"));
  EXPECT_THAT(labels(linear_ticks(0, 5, 7)), testing::ElementsAre("0", "1", "2", "3", "4", "5"));
  EXPECT_THAT(labels(linear_ticks(0, 5, 4)), testing::ElementsAre("0", "2", "4"));
  EXPECT_THAT(labels(linear_ticks(985, 1015, 4)), testing::ElementsAre("990", "1000", "1010"));
}

TEST(Ticks, OfVerySmallAndVeryLargeNumbersArePowersOfTen) {
  EXPECT_THAT(labels(linear_ticks(0, 2e-5, 3)), testing::ElementsAre("0", "10⁻⁵", "2·10⁻⁵"));
  EXPECT_THAT(labels(linear_ticks(-1e6, 1e6, 3)), testing::ElementsAre("−10⁶", "0", "10⁶"));
}

TEST(Ticks, OfALogarithmicAxisAreItsDecades) {
  std::vector<std::string> decades;
  std::size_t minor = 0;
  for (const Tick& tick : logarithmic_ticks(1e-3, 1)) {
    if (tick.label.empty())
      ++minor;
    else
      decades.push_back(tick.label);
  }
  EXPECT_THAT(decades, testing::ElementsAre("10⁻³", "10⁻²", "10⁻¹", "10⁰"));
  EXPECT_EQ(minor, 3u * 8u);
}

TEST(Ticks, OfLessThanADecadeAreStillLabelled) {
  std::vector<std::string> texts;
  for (const Tick& tick : logarithmic_ticks(1.5e3, 6e3))
    if (!tick.label.empty()) texts.push_back(tick.label);
  EXPECT_THAT(texts, testing::ElementsAre("2·10³", "5·10³"));
}

}  // namespace
}  // namespace weir
