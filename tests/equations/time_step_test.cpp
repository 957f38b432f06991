#include "equations/time_step.h"

#include <gtest/gtest.h>

#include <limits>

namespace weir {
namespace {

TEST(TimeStep, LimitsFollowTheirFormulas) {
  EXPECT_DOUBLE_EQ(velocity_limit(0.4, 0.01, 2), 0.002);
  EXPECT_DOUBLE_EQ(acoustic_limit(0.4, 0.01, 18, 2), 0.0002);
  EXPECT_DOUBLE_EQ(force_limit(0.25, 0.04, 4), 0.025);
  EXPECT_DOUBLE_EQ(viscous_limit(0.125, 0.02, 0.1), 0.0005);
}

TEST(TimeStep, AtRestNothingLimitsSpeedOrForce) {
  EXPECT_EQ(velocity_limit(0.4, 0.01, 0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(force_limit(0.25, 0.01, 0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(viscous_limit(0.125, 0.01, 0), std::numeric_limits<double>::infinity());
}

TEST(TimeStep, CflNumberIsOneSmoothingLengthPerStep) { EXPECT_DOUBLE_EQ(cfl_number(0.001, 10, 0.01), 1); }

TEST(EulerCromer, MovesWithTheNewVelocity) {
  Vec<2, double> x{1, 2};
  Vec<2> v{3, 4};
  euler_cromer(x, v, Vec<2>{2, -4}, 0.5F);
  EXPECT_EQ(v[0], 4);
  EXPECT_EQ(v[1], 2);
  EXPECT_EQ(x[0], 3);
  EXPECT_EQ(x[1], 3);
}

// A harmonic oscillator keeps its energy within O(dt) for ever; explicit Euler would gain a factor (1 + dt^2)^n = 2.7.
TEST(EulerCromer, KeepsTheEnergyOfAnOscillator) {
  Vec<1, double> x{1};
  Vec<1> v{0};
  const Real dt = 0.01F;
  for (int n = 0; n < 10000; ++n) euler_cromer(x, v, Vec<1>{static_cast<Real>(-x[0])}, dt);
  EXPECT_NEAR(0.5 * (x[0] * x[0] + static_cast<double>(v[0]) * v[0]), 0.5, 0.5 * dt);
}

}  // namespace
}  // namespace weir
