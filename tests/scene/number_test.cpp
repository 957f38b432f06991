#include "scene/number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace weir {
namespace {

TEST(Number, ReadsDecimalNumbers) {
  for (const auto& [text, value] :
       std::initializer_list<std::pair<const char*, double>>{{"0", 0},
                                                             {"5", 5},
                                                             {"+5", 5},
                                                             {"-5", -5},
                                                             {"5.", 5},
                                                             {".5", 0.5},
                                                             {"-.5e1", -5},
                                                             {"0.25", 0.25},
                                                             {"1e-3", 1e-3},
                                                             {"1.0E+03", 1000},
                                                             {"1e05", 1e5},
                                                             {"9007199254740993", 9007199254740992.0}}) {
    EXPECT_EQ(parse_number(text).value, value) << text;
  }
}

TEST(Number, RefusesEverythingElse) {
  for (const char* text : {"",     "+",     "-",    ".",    "e5",       "1e",    "1e+",    "--1", "+-1", "1 ",
                           " 1",   "1.2.3", "0x10", "0o17", "0b1",      "017",   "-00",    "1_0", "1,5", "inf",
                           ".inf", "-.Inf", "nan",  ".NaN", "infinity", "1e400", "1e-400", "1f",  "abc", "٣"}) {
    EXPECT_FALSE(parse_number(text).value) << text;
  }
}

TEST(Number, WritesWhatReadsBackToTheSameBits) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 20000; ++i) {
    double value = 0;
    const std::uint64_t bits = random();
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    const std::string text = number_text(value);
    const ParsedNumber again = parse_number(text);
    if (again.value) {
      EXPECT_EQ(*again.value, value) << text;
    } else {
      EXPECT_LT(std::abs(value), std::numeric_limits<double>::min()) << text;  // denormal numbers are refused
    }
  }
  EXPECT_EQ(number_text(1e-6), "1.0e-06");
  EXPECT_EQ(number_text(100000), "100000");
  EXPECT_EQ(number_text(0.1), "0.1");
}

}  // namespace
}  // namespace weir
