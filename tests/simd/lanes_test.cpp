#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "core/math.h"
#include "simd/instruction_set.h"
#include "simd/lanes_functions.h"

namespace weir {
namespace {

using Numbers = std::array<float, widest_register>;

LaneFunctions functions_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::baseline:
      return baseline::lane_functions();
#if defined(__x86_64__)
    case InstructionSet::avx2:
      return avx2::lane_functions();
    case InstructionSet::avx512:
      return avx512::lane_functions();
#endif
    default:
      throw std::logic_error("instruction set that this program was not built with");
  }
}

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

// Every pair of these is tested, in every lane.
constexpr std::array<float, 9> special = {nan, -infinity, -2, -1e-30F, 0, 1e-30F, 1, 3, infinity};

template <class Visit>
void for_each_pair(const Visit& visit) {
  for (std::size_t shift = 0; shift < special.size(); ++shift) {
    for (std::size_t start = 0; start < special.size(); ++start) {
      Numbers a;
      Numbers b;
      for (std::size_t k = 0; k < a.size(); ++k) {
        a[k] = special[(start + k) % special.size()];
        b[k] = special[(start + k + shift) % special.size()];
      }
      visit(a, b);
    }
  }
}

// The same bits, or NaN in both: NaN has many representations.
testing::AssertionResult same(float a, float b) {
  if ((a != a && b != b) || std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b)) {
    return testing::AssertionSuccess();
  }
  return testing::AssertionFailure() << a << " and " << b;
}

TEST(Nan, PropagatesThroughThePositivePart) {
  EXPECT_NE(positive_part(nan), positive_part(nan)) << "NaN alone differs from itself";
  const double no_double = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(positive_part(no_double), positive_part(no_double));
}

// Comparisons with NaN are false, which selects the second argument.
TEST(Nan, IsTheLargerArgumentIfItIsTheSecond) {
  EXPECT_NE(larger(1.0F, nan), larger(1.0F, nan));
  EXPECT_EQ(larger(nan, 1.0F), 1);
}

TEST(Lanes, CompareAsScalarsDo) {
  for (const InstructionSet set : usable_instruction_sets()) {
    const LaneFunctions lanes = functions_of(set);
    for_each_pair([&](const Numbers& a, const Numbers& b) {
      Numbers result;
      lanes.larger(a.data(), b.data(), result.data());
      for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_TRUE(same(result[k], larger(a[k], b[k]))) << name_of(set) << ": larger of " << a[k] << ", " << b[k];
      }
      lanes.smaller(a.data(), b.data(), result.data());
      for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_TRUE(same(result[k], a[k] < b[k] ? a[k] : b[k]))
            << name_of(set) << ": smaller of " << a[k] << ", " << b[k];
      }
      lanes.positive_part(a.data(), result.data());
      for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_TRUE(same(result[k], positive_part(a[k]))) << name_of(set) << ": positive part of " << a[k];
      }
    });
  }
}

TEST(Lanes, GiveNanAsTheRootOfNanAndOfNegativeNumbers) {
  for (const InstructionSet set : usable_instruction_sets()) {
    for (const float none : {nan, -1.0F}) {
      for (std::size_t at = 0; at < widest_register; ++at) {
        Numbers a;
        a.fill(4);
        a[at] = none;
        Numbers result;
        functions_of(set).square_root(a.data(), result.data());
        for (std::size_t k = 0; k < a.size(); ++k) EXPECT_TRUE(same(result[k], k == at ? nan : 2)) << name_of(set);
      }
    }
  }
}

// The solver detects diverged particles by this comparison.
TEST(Lanes, ASingleNanIsNotAtMostAnything) {
  for (const InstructionSet set : usable_instruction_sets()) {
    const LaneFunctions lanes = functions_of(set);
    Numbers limit;
    limit.fill(infinity);
    for (std::size_t at = 0; at < widest_register; ++at) {
      Numbers a;
      a.fill(1);
      EXPECT_TRUE(lanes.all_at_most(a.data(), limit.data())) << name_of(set);
      a[at] = nan;
      EXPECT_FALSE(lanes.all_at_most(a.data(), limit.data())) << name_of(set) << ", lane " << at;
    }
  }
}

}  // namespace
}  // namespace weir
