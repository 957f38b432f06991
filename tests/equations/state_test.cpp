#include "equations/state.h"

#include <gtest/gtest.h>

#include <cmath>

#include "equations/density.h"
#include "equations/energy.h"

namespace weir {
namespace {

TEST(State, PressureIsZeroAtRestAndSignedAroundIt) {
  for (const int exponent : {1, 7}) {
    EXPECT_EQ(pressure_of_state(1.0, 1e5, exponent), 0);
    EXPECT_GT(pressure_of_state(1.01, 1e5, exponent), 0);
    EXPECT_LT(pressure_of_state(0.99, 1e5, exponent), 0);
  }
}

TEST(State, FollowsTaitAndTheLinearLaw) {
  EXPECT_DOUBLE_EQ(pressure_of_state(1.5, 2.0, 7), 2.0 * (17.0859375 - 1));  // 1.5^7 = 2187/128
  EXPECT_DOUBLE_EQ(pressure_of_state(1.5, 2.0, 1), 1.0);
}

TEST(State, SoundSpeedIsTheSlopeOfPressureOverDensity) {
  const double k = 3e4, rho0 = 900, step = 1e-6;
  for (const int exponent : {1, 7}) {
    const double slope =
        (pressure_of_state(1 + step, k, exponent) - pressure_of_state(1 - step, k, exponent)) / (2 * step * rho0);
    const double c0 = sound_speed_of_state(k, exponent, rho0);
    EXPECT_NEAR(c0 * c0, slope, 1e-8 * slope);
    EXPECT_DOUBLE_EQ(stiffness_of_state(c0, exponent, rho0), k);
  }
}

TEST(Energy, OfAFallingParticleIsConserved) {
  const Vec<2, double> g{0, -9.81};
  const double t = 0.3;
  const Vec<2, double> x{0, 2 - 0.5 * 9.81 * t * t};
  const Vec<2, double> v{0, -9.81 * t};
  EXPECT_NEAR(kinetic_energy(2.5, v) + potential_energy(2.5, g, x), 2.5 * 9.81 * 2, 1e-12);
}

TEST(Energy, OfAFallBecomesSpeedAndThatStagnationPressure) {
  // A column of height H = 0.5 m: v = sqrt(2 g H) and rho g H, [Torricelli] and [Bernoulli].
  const double v2 = speed_squared_of_fall(9.81, 0.5);
  EXPECT_DOUBLE_EQ(std::sqrt(v2), 3.132091952673165);
  EXPECT_DOUBLE_EQ(dynamic_pressure(1000, std::sqrt(v2)), 4905);
}

TEST(Density, OfALatticeIsItsMassOverItsVolume) {
  EXPECT_DOUBLE_EQ(lattice_mass(1000, 0.1, 2), 10);
  EXPECT_DOUBLE_EQ(lattice_mass(1000, 0.1, 3), 1);
}

}  // namespace
}  // namespace weir
