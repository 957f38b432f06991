#include "render/nice_numbers.h"

#include <gtest/gtest.h>

namespace weir {
namespace {

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
