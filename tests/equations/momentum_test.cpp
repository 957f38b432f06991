#include "equations/momentum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "equations/kernels.h"

namespace weir {
namespace {

// The operator applied to u = (y^2, 0) at the origin of an infinite 2D lattice, over nu lap u = 2 nu.
template <class Viscosity>
double share_of_laplacian(double h_per_dx) {
  const double dx = 1;
  const double h = h_per_dx * dx;
  const double m = dx * dx;
  const auto kernel = kernel_at<CubicSpline, 2, double>(h, -m);
  const auto viscosity = Viscosity::template of<2>(1, h);
  double a = 0;
  for (int x = -5; x <= 5; ++x) {
    for (int y = -5; y <= 5; ++y) {
      if (x == 0 && y == 0) continue;
      const Vec<2, double> x_ij{-x * dx, -y * dx};
      const double r2 = dot(x_ij, x_ij);
      const Pair<2, double> pair{.x_ij = x_ij,
                                 .v_ij = {-(y * dx) * (y * dx), 0},
                                 .r2 = r2,
                                 .f = kernel.derivative_over_r(std::sqrt(r2)),
                                 .rho_i = 1,
                                 .rho_j = 1,
                                 .pressure_term_i = 0,
                                 .pressure_term_j = 0};
      a += acceleration(pair, viscosity.from_fluid(pair))[0];
    }
  }
  return a / 2;
}

// The published shares (erratum A1), to the digits given there.
TEST(Viscosity, PrintedFormGivesASixthOfTheLaplacian) {
  EXPECT_NEAR(share_of_laplacian<Hinsch2024Viscosity>(1), 0.16, 0.005);
  EXPECT_NEAR(share_of_laplacian<Hinsch2024Viscosity>(2), 0.24, 0.005);
}
TEST(Viscosity, MonaghanFormIsConsistentForWideKernels) {
  EXPECT_NEAR(share_of_laplacian<MonaghanViscosity>(1), 0.66, 0.005);
  EXPECT_NEAR(share_of_laplacian<MonaghanViscosity>(2), 0.96, 0.005);
}
TEST(Viscosity, MorrisFormIsConsistentAtHinschsKernelWidth) {
  EXPECT_NEAR(share_of_laplacian<MorrisViscosity>(1), 1.005, 0.0005);
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
  pair.f = 1 + u(random);
  pair.rho_i = 1 + 0.1 * u(random);
  pair.rho_j = 1 + 0.1 * u(random);
  pair.pressure_term_i = 2 + u(random);
  pair.pressure_term_j = 2 + u(random);
  return pair;
}

template <int Dim>
Pair<Dim, double> seen_from_j(const Pair<Dim, double>& pair) {
  Pair<Dim, double> other = pair;
  other.x_ij = -1.0 * pair.x_ij;
  other.v_ij = -1.0 * pair.v_ij;
  std::swap(other.pressure_term_i, other.pressure_term_j);
  std::swap(other.rho_i, other.rho_j);
  return other;
}

template <class Term>
void expect_action_is_reaction(const Term& term) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 100; ++trial) {
    const auto pair = random_pair<3>(random);
    const auto other = seen_from_j(pair);
    const auto a = acceleration(pair, term.from_fluid(pair));
    const auto b = acceleration(other, term.from_fluid(other));
    for (int d = 0; d < 3; ++d) EXPECT_EQ(a[d], -b[d]);
  }
}

// For equal masses; both signs come from the same operations, so they agree to the last bit. Not so the viscosity that
// Hinsch 2024 prints, which has rho_j alone.
TEST(Momentum, EveryConsistentTermIsAntisymmetric) {
  expect_action_is_reaction(Pressure{});
  expect_action_is_reaction(MorrisViscosity::of<3>(0.1, 1));
  expect_action_is_reaction(MonaghanViscosity::of<3>(0.1, 1));
  expect_action_is_reaction(Hinsch2024SurfaceTension::of(0.3, 0.7));
}

TEST(Momentum, PressureRepelsAndViscosityOpposesMotion) {
  Pair<2, double> pair{.x_ij = {1, 0},
                       .v_ij = {1, 0},
                       .r2 = 1,
                       .f = 1,
                       .rho_i = 1,
                       .rho_j = 1,
                       .pressure_term_i = 1,
                       .pressure_term_j = 1};
  const auto from_fluid = [&](const auto& term) { return acceleration(pair, term.from_fluid(pair))[0]; };
  const auto from_wall = [&](const auto& term) { return acceleration(pair, term.from_wall(pair))[0]; };
  EXPECT_EQ(from_fluid(Pressure{}), 2);  // F (1 + 1)
  EXPECT_EQ(from_wall(Pressure{}), 2);   // 2 F p_i / rho_i^2, whatever stands for p_j
  pair.pressure_term_j = 17;
  EXPECT_EQ(from_wall(Pressure{}), 2);
  // nu = 1 and no softening: 2 nu F / rho, and 2 (2 + 2) nu F / rho, against the motion.
  EXPECT_EQ(from_fluid(MorrisViscosity::of<2>(1, 0)), -2);
  EXPECT_EQ(from_fluid(MonaghanViscosity::of<2>(1, 0)), -8);
  EXPECT_EQ(from_fluid(ArtificialViscosity::of<2>(1, 0)), 0);  // they part
  EXPECT_EQ(from_fluid(Hinsch2024Viscosity::of<2>(1, 0)), -2);
  pair.v_ij = {-1, 0};
  EXPECT_EQ(from_fluid(ArtificialViscosity::of<2>(1, 0)), 8);  // they approach: as Monaghan's
  EXPECT_EQ(from_fluid(Hinsch2024SurfaceTension::of(3, 2)), -1.5) << "tension pulls towards neighbours: s / m F";
}

// Terms are added before they multiply a vector.
TEST(Momentum, ASumOfTermsIsTheSumOfTheirAccelerations) {
  std::mt19937 random(8);
  const MorrisViscosity morris = MorrisViscosity::of<3>(0.1, 1);
  const MonaghanViscosity monaghan = MonaghanViscosity::of<3>(0.1, 1);
  const Hinsch2024SurfaceTension tension = Hinsch2024SurfaceTension::of(0.3, 0.7);
  for (int trial = 0; trial < 100; ++trial) {
    const auto pair = random_pair<3>(random);
    const auto push = Pressure{}.from_fluid(pair);
    const auto pull = tension.from_fluid(pair);
    const auto of = [&](auto term) { return acceleration(pair, term); };
    for (int d = 0; d < 3; ++d) {
      const double dragged = of(push)[d] + of(morris.from_fluid(pair))[d];
      EXPECT_NEAR(of(push + morris.from_fluid(pair))[d], dragged, 1e-14);
      EXPECT_NEAR(of(push + morris.from_fluid(pair) + pull)[d], dragged + of(pull)[d], 1e-14);
      EXPECT_NEAR(of(push + monaghan.from_fluid(pair))[d], of(push)[d] + of(monaghan.from_fluid(pair))[d], 1e-14);
    }
  }
}

}  // namespace
}  // namespace weir
