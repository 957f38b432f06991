#include "equations/kernels.h"

#include <gtest/gtest.h>

#include <cmath>

namespace weir {
namespace {

template <template <int> class Family, int D>
struct Case {
  static constexpr int dim = D;
  static auto at(double h) { return kernel_at<Family, D, double>(h); }
};

template <class C>
class Kernel : public testing::Test {};
using Cases = testing::Types<Case<CubicSpline, 1>, Case<CubicSpline, 2>, Case<CubicSpline, 3>, Case<WendlandC2, 1>,
                             Case<WendlandC2, 2>, Case<WendlandC2, 3>, Case<WendlandC4, 1>, Case<WendlandC4, 2>,
                             Case<WendlandC4, 3>>;
TYPED_TEST_SUITE(Kernel, Cases);

// Surface of the unit sphere in `dim` dimensions.
double sphere(int dim) { return dim == 1 ? 2 : dim == 2 ? 2 * pi : 4 * pi; }

// Exact for polynomials of degree at most 11, as w(r) r^(dim-1) is on each of [0, h] and [h, 2h].
double gauss_integral(double from, double to, const auto& f) {
  constexpr double node[3] = {0.9324695142031521, 0.6612093864662645, 0.2386191860831969};
  constexpr double weight[3] = {0.1713244923791704, 0.3607615730481386, 0.4679139345726910};
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    for (const double sign : {-1.0, 1.0}) {
      sum += weight[k] * f(0.5 * (from + to) + sign * 0.5 * (to - from) * node[k]);
    }
  }
  return 0.5 * (to - from) * sum;
}

TYPED_TEST(Kernel, IntegratesToOne) {
  for (const double h : {0.01, 1.0, 30.0}) {
    const auto kernel = TypeParam::at(h);
    const auto shell = [&](double r) {
      return sphere(TypeParam::dim) * std::pow(r, TypeParam::dim - 1) * kernel.value(r);
    };
    // Rounding of a few dozen operations.
    EXPECT_NEAR(gauss_integral(0, h, shell) + gauss_integral(h, 2 * h, shell), 1, 2e-14);
  }
}

TYPED_TEST(Kernel, DerivativeIsTheSlopeOfTheValue) {
  const double h = 0.7;
  const auto kernel = TypeParam::at(h);
  const double step = 1e-5 * h;
  const double scale = kernel.value(0.0) / h;
  for (int k = 1; k < 250; ++k) {
    const double r = 0.0083 * h * k;
    const double slope = (kernel.value(r + step) - kernel.value(r - step)) / (2 * step);
    // A central difference errs by step^2 / 6 times the third derivative, which jumps at the knots.
    EXPECT_NEAR(kernel.derivative_over_r(r) * r, slope, 1e-8 * scale) << "r/h = " << r / h;
  }
}

TYPED_TEST(Kernel, FallsFromTheCentreToExactlyZeroAtTheSupport) {
  const auto kernel = TypeParam::at(1.0);
  for (int k = 1; k <= 200; ++k) EXPECT_LE(kernel.value(0.01 * k), kernel.value(0.01 * (k - 1)));
  for (const double r : {2.0, 2.0001, 3.0, 1e6}) {
    EXPECT_EQ(kernel.value(r), 0);
    EXPECT_EQ(kernel.derivative_over_r(r), 0);
  }
}

TYPED_TEST(Kernel, GradientVanishesWhereParticlesMeet) {
  const auto kernel = TypeParam::at(1.0);
  EXPECT_TRUE(std::isfinite(kernel.derivative_over_r(0.0)));
  EXPECT_EQ(kernel.derivative_over_r(0.0) * 0.0, 0);
}

}  // namespace
}  // namespace weir
