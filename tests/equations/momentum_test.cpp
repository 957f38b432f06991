#include "equations/momentum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "equations/kernels.h"

namespace weir {
namespace {

// The operator applied to u = (y^2, 0) at the origin of an infinite 2D lattice, over nu lap u = 2 nu.
template <class Viscosity>
double share_of_laplacian(double h_per_dx, double factor) {
  const double dx = 1;
  const double h = h_per_dx * dx;
  const auto kernel = kernel_at<CubicSpline, 2, double>(h);
  const Viscosity viscosity{static_cast<Real>(factor), static_cast<Real>(viscosity_softening * h * h)};
  double a = 0;
  for (int x = -5; x <= 5; ++x) {
    for (int y = -5; y <= 5; ++y) {
      if (x == 0 && y == 0) continue;
      const Vec<2, double> x_ij{-x * dx, -y * dx};
      const double r2 = dot(x_ij, x_ij);
      const Pair<2, double> pair{.x_ij = x_ij,
                                 .v_ij = {-(y * dx) * (y * dx), 0},
                                 .r2 = r2,
                                 .dw_over_r = kernel.derivative_over_r(std::sqrt(r2)),
                                 .m_j = dx * dx,
                                 .rho_i = 1,
                                 .rho_j = 1,
                                 .pressure_i = 0,
                                 .pressure_j = 0};
      a += viscosity.from_fluid(pair)[0];
    }
  }
  return a / 2;
}

// The published shares (erratum A1), to the digits given there.
TEST(Viscosity, PrintedFormGivesASixthOfTheLaplacian) {
  EXPECT_NEAR(share_of_laplacian<SeedAViscosity>(1, 2), 0.16, 0.005);
  EXPECT_NEAR(share_of_laplacian<SeedAViscosity>(2, 2), 0.24, 0.005);
}
TEST(Viscosity, MonaghanFormIsConsistentForWideKernels) {
  EXPECT_NEAR(share_of_laplacian<MonaghanViscosity>(1, 8), 0.66, 0.005);
  EXPECT_NEAR(share_of_laplacian<MonaghanViscosity>(2, 8), 0.96, 0.005);
}
TEST(Viscosity, MorrisFormIsConsistentAtTheSeedsKernelWidth) {
  EXPECT_NEAR(share_of_laplacian<MorrisViscosity>(1, 2), 1.005, 0.0005);
}

template <int Dim>
Pair<Dim, double> random_pair(std::mt19937& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  Pair<Dim, double> pair{};
  for (int d = 0; d < Dim; ++d) {
    pair.x_ij[d] = u(random);
    pair.v_ij[d] = u(random);
  }
  pair.r2 = dot(pair.x_ij, pair.x_ij);
  pair.dw_over_r = -1 - u(random);
  pair.m_j = 0.3;
  pair.rho_i = 1 + 0.1 * u(random);
  pair.rho_j = 1 + 0.1 * u(random);
  pair.pressure_i = 2 + u(random);
  pair.pressure_j = 2 + u(random);
  return pair;
}

template <int Dim>
Pair<Dim, double> seen_from_j(const Pair<Dim, double>& pair) {
  Pair<Dim, double> other = pair;
  other.x_ij = -1.0 * pair.x_ij;
  other.v_ij = -1.0 * pair.v_ij;
  std::swap(other.pressure_i, other.pressure_j);
  std::swap(other.rho_i, other.rho_j);
  return other;
}

template <class Term>
void expect_action_is_reaction(const Term& term) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 100; ++trial) {
    const auto pair = random_pair<3>(random);
    const auto a = term.from_fluid(pair);
    const auto b = term.from_fluid(seen_from_j(pair));
    for (int d = 0; d < 3; ++d) EXPECT_EQ(a[d], -b[d]);
  }
}

// For equal masses; both signs come from the same operations, so they agree to the last bit. Not so the viscosity that
// seed A prints, which has rho_j alone.
TEST(Momentum, EveryConsistentTermIsAntisymmetric) {
  expect_action_is_reaction(Pressure{1.5F});
  expect_action_is_reaction(MorrisViscosity{0.2F, 0.01F});
  expect_action_is_reaction(MonaghanViscosity{0.2F, 0.01F});
  expect_action_is_reaction(SeedASurfaceTension{0.3F});
}

TEST(Momentum, PressureRepelsAndViscosityOpposesMotion) {
  Pair<2, double> pair{.x_ij = {1, 0},
                       .v_ij = {1, 0},
                       .r2 = 1,
                       .dw_over_r = -1,
                       .m_j = 1,
                       .rho_i = 1,
                       .rho_j = 1,
                       .pressure_i = 1,
                       .pressure_j = 1};
  EXPECT_GT(Pressure{1}.from_fluid(pair)[0], 0);
  EXPECT_EQ(Pressure{1}.from_fluid(pair)[0], 2);  // m (1 + 1)
  EXPECT_EQ(Pressure{1}.from_wall(pair)[0], 2);   // 2 m p_i / rho_i^2, whatever stands for p_j
  pair.pressure_j = 17;
  EXPECT_EQ(Pressure{1}.from_wall(pair)[0], 2);
  EXPECT_LT((MorrisViscosity{1, 0}.from_fluid(pair)[0]), 0);
  EXPECT_LT((MonaghanViscosity{1, 0}.from_fluid(pair)[0]), 0);
  EXPECT_LT((SeedASurfaceTension{1}.from_fluid(pair)[0]), 0) << "tension pulls towards neighbours";
}

}  // namespace
}  // namespace weir
