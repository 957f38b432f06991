// Hinsch's own tests, [Hinsch24 ch. 6.1], on its 11 x 11 lattice: all particles a distance h apart. Where the text
// errs, the right value stands here with the reason (physics.md calls these A1 to A7).
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "equations/density.h"
#include "equations/kernels.h"
#include "equations/state.h"

namespace weir {
namespace {

using V = Vec<2, double>;

constexpr double h = 0.25;
constexpr double alpha = 5 / (14 * pi * h * h);
const auto kernel = kernel_at<CubicSpline, 2, double>(h);

V gradient(const V& x_ij) { return kernel.derivative_over_r(std::sqrt(dot(x_ij, x_ij))) * x_ij; }

std::vector<V> lattice() {
  std::vector<V> points;
  for (int y = 0; y < 11; ++y) {
    for (int x = 0; x < 11; ++x) points.push_back({x * h, y * h});
  }
  return points;
}

bool interior(const V& x) { return x[0] > 1.5 * h && x[0] < 8.5 * h && x[1] > 1.5 * h && x[1] < 8.5 * h; }

constexpr double rounding = 1e-13;  // relative, of double arithmetic over some ten operations

TEST(Hinsch2024, KernelHasThePrintedValues) {
  EXPECT_EQ(kernel.value(3 * h), 0);
  EXPECT_NEAR(kernel.value(0.0), 20 / (14 * pi * h * h), rounding / (h * h));
  EXPECT_NEAR(kernel.value(h), 5 / (14 * pi * h * h), rounding / (h * h));
  // Printed to four digits.
  EXPECT_NEAR(kernel.value(std::sqrt(2.0) * h) * 14 * pi * h * h, 1.005, 0.0005);
}

TEST(Hinsch2024, KernelSumsToTheNumberDensity) {
  // The text says 1/h^2; on the lattice at h = dx the sum is (20 + 4 * 5 + 4 * 1.00505) / (14 pi h^2) = 1.00086 / h^2.
  const double exact = (40 + 20 * std::pow(2 - std::sqrt(2.0), 3)) / (14 * pi * h * h);
  EXPECT_NEAR(exact * h * h, 1.00086, 5e-6);
  for (const V& x_i : lattice()) {
    if (!interior(x_i)) continue;
    double sum = 0;
    for (const V& x_j : lattice()) sum += kernel.value(std::sqrt(dot(x_i - x_j, x_i - x_j)));
    EXPECT_NEAR(sum, exact, 1e-12 * exact);
  }
}

TEST(Hinsch2024, GradientHasThePrintedValues) {
  const double beta = -3 * (2 - std::sqrt(2.0)) * (2 - std::sqrt(2.0));
  EXPECT_EQ(gradient({0, 0})[0], 0);
  EXPECT_EQ(gradient({0, 0})[1], 0);
  // The argument is x_i - x_j, (0, 0) - (h, 0) = (-h, 0): as the tests of the text take it (A7).
  EXPECT_NEAR(gradient({-h, 0})[0], 3 * alpha / h, rounding * alpha / h);
  EXPECT_NEAR(gradient({h, 0})[0], -3 * alpha / h, rounding * alpha / h);
  EXPECT_NEAR(gradient({0, -h})[1], 3 * alpha / h, rounding * alpha / h);
  EXPECT_NEAR(gradient({0, h})[1], -3 * alpha / h, rounding * alpha / h);
  const double diagonal = -alpha * beta / (h * std::sqrt(2.0));
  for (const double sx : {-1.0, 1.0}) {
    for (const double sy : {-1.0, 1.0}) {
      const V g = gradient({-sx * h, -sy * h});
      EXPECT_NEAR(g[0], sx * diagonal, rounding * alpha / h);
      EXPECT_NEAR(g[1], sy * diagonal, rounding * alpha / h);
    }
  }
}

TEST(Hinsch2024, GradientsCancelInsideTheLattice) {
  for (const V& x_i : lattice()) {
    if (!interior(x_i)) continue;
    V sum{};
    for (const V& x_j : lattice()) sum += gradient(x_i - x_j);
    EXPECT_NEAR(sum[0], 0, 1e-12 * alpha / h);
    EXPECT_NEAR(sum[1], 0, 1e-12 * alpha / h);
  }
}

TEST(Hinsch2024, DensityIsAtRestAndPressureZeroWithinTheLatticeError) {
  const double rho0 = 1000;
  const double m = rho0 * h * h;
  const double lattice_error = (40 + 20 * std::pow(2 - std::sqrt(2.0), 3)) / (14 * pi) - 1;  // of the kernel sum above
  const V center{5 * h, 5 * h};
  double rho = 0;
  for (const V& x_j : lattice()) {
    rho += density_contribution(m, kernel.value(std::sqrt(dot(center - x_j, center - x_j))));
  }
  EXPECT_NEAR(density_error(rho, rho0), lattice_error, rounding);
  const double k = 1e5;
  EXPECT_NEAR(pressure_of_state(rho / rho0, k, 7) / k, std::pow(1 + lattice_error, 7) - 1, 10 * rounding);
}

}  // namespace
}  // namespace weir
