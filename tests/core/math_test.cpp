#include "core/math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace weir {
namespace {

// A float whose multiply_add rounds once, as in registers that compute quotients by products.
struct Fused {
  float v;
  explicit Fused(int s) : v(static_cast<float>(s)) {}
  explicit(false) Fused(float s) : v(s) {}
  friend Fused multiply_add(Fused a, Fused b, Fused c) { return std::fma(a.v, b.v, c.v); }
  friend Fused minus_product(Fused c, Fused a, Fused b) { return std::fma(-a.v, b.v, c.v); }
  friend Fused reciprocal_guess(Fused a) { return weir::reciprocal_guess(a.v); }
};

// Every mantissa: the error does not depend on the exponent, as long as nothing underflows.
TEST(Reciprocal, ByProductsIsAccurateToTheLastBit) {
  double worst_guess = 0;
  double worst = 0;
  for (std::int32_t mantissa = 0; mantissa < 1 << 23; ++mantissa) {
    const float x = std::bit_cast<float>(0x3F800000 + mantissa);
    worst_guess = std::max(worst_guess, std::abs(1 - double{x} * reciprocal_guess(x)));
    worst = std::max(worst, std::abs(1 - double{x} * reciprocal_by_products(Fused(x)).v));
  }
  EXPECT_LE(worst_guess, 0.051);
  EXPECT_LE(worst, std::ldexp(1, -23));
}

TEST(Reciprocal, ByProductsHoldsForEveryExponentButTheLast) {
  for (int exponent = -125; exponent < 125; ++exponent) {
    const float x = std::ldexp(1.37F, exponent);
    EXPECT_NEAR(double{x} * reciprocal_by_products(Fused(x)).v, 1, std::ldexp(1, -23)) << exponent;
  }
}

}  // namespace
}  // namespace weir
