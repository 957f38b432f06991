#include "render/nice_numbers.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace weir {
namespace {

std::vector<std::string> labels(double low, double high, int most) {
  std::vector<std::string> all;
  for (const Tick& tick : nice_ticks(low, high, most)) all.push_back(tick.label);
  return all;
}

TEST(NiceNumbers, RoundUpToFewDigits) {
  EXPECT_DOUBLE_EQ(round_up_nicely(4.43), 5);
  EXPECT_DOUBLE_EQ(round_up_nicely(5), 5);
  EXPECT_DOUBLE_EQ(round_up_nicely(0.0141), 0.015);
  EXPECT_DOUBLE_EQ(round_up_nicely(8.1), 10);
  EXPECT_DOUBLE_EQ(round_up_nicely(0), 1);
}

TEST(NiceNumbers, RoundDownToOneTwoFive) {
  EXPECT_DOUBLE_EQ(round_down_125(0.99), 0.5);
  EXPECT_DOUBLE_EQ(round_down_125(1), 1);
  EXPECT_DOUBLE_EQ(round_down_125(4.9), 2);
  EXPECT_DOUBLE_EQ(round_down_125(0.3), 0.2);
  EXPECT_DOUBLE_EQ(round_down_125(1e-3), 1e-3);
  EXPECT_DOUBLE_EQ(round_down_125(7e4), 5e4);
}

TEST(NiceNumbers, TicksAreRoundAndFew) {
  EXPECT_THAT(labels(0, 5, 7), testing::ElementsAre("0", "1", "2", "3", "4", "5"));
  EXPECT_THAT(labels(0, 5, 4), testing::ElementsAre("0", "2", "4"));
  EXPECT_THAT(labels(0, 1, 6), testing::ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(labels(985, 1015, 4), testing::ElementsAre("990", "1000", "1010"));
  EXPECT_THAT(labels(-0.02, 0.02, 5), testing::ElementsAre("-0.02", "-0.01", "0.00", "0.01", "0.02"));
}

TEST(NiceNumbers, TicksNeverPassTheirNumberOrTheRange) {
  for (const double high : {0.013, 0.7, 1.0, 3.0, 4.43, 99.0, 12345.0})
    for (int most = 2; most < 9; ++most) {
      const std::vector<Tick> ticks = nice_ticks(0, high, most);
      EXPECT_LE(static_cast<int>(ticks.size()), most) << high;
      EXPECT_GE(ticks.size(), 1U) << high;
      for (const Tick& tick : ticks) EXPECT_LE(tick.value, high * (1 + 1e-9));
    }
}

TEST(NiceNumbers, LengthsTakeTheUnitThatKeepsThemShort) {
  EXPECT_EQ(length_text(0.5), "50 cm");
  EXPECT_EQ(length_text(0.002), "2 mm");
  EXPECT_EQ(length_text(0.01), "1 cm");
  EXPECT_EQ(length_text(10), "10 m");
  EXPECT_EQ(length_text(2000), "2 km");
  EXPECT_EQ(length_text(5e-5), "50 µm");
}

TEST(NiceNumbers, UnitsKeepNumbersShort) {
  EXPECT_EQ(display_unit("Pa", 9812).name, "kPa");
  EXPECT_EQ(display_unit("Pa", 500).name, "Pa");
  EXPECT_EQ(display_unit("Pa", 2e6).name, "MPa");
  EXPECT_EQ(display_unit("m/s", 5).name, "m/s");
  EXPECT_EQ(display_unit("m/s", 0.02).name, "mm/s");
  EXPECT_DOUBLE_EQ(display_unit("m/s", 0.02).factor, 1000);
  EXPECT_EQ(display_unit("kg/m³", 1015).name, "kg/m³");
}

}  // namespace
}  // namespace weir
