#include "equations/time_step.h"

#include <gtest/gtest.h>

#include <limits>

namespace weir {
namespace {

TEST(TimeStep, LimitsFollowTheirFormulas) {
  EXPECT_DOUBLE_EQ(velocity_limit(0.4, 0.01, 2), 0.002);
  EXPECT_DOUBLE_EQ(acoustic_limit(0.4, 0.01, signal_speed(18.0, 2.0)), 0.0002);
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
  float x = 1;
  float rest = 0;
  float v = 3;
  v = kicked(v, 2.0F, 0.5F);
  drift(x, rest, v, 0.5F);
  EXPECT_EQ(v, 4);
  EXPECT_EQ(x, 3);
  EXPECT_EQ(rest, 0);
}

// A harmonic oscillator keeps its energy within O(dt) for ever; explicit Euler would gain a factor (1 + dt^2)^n = 2.7.
TEST(EulerCromer, KeepsTheEnergyOfAnOscillator) {
  float x = 1;
  float rest = 0;
  float v = 0;
  const Real dt = 0.01F;
  for (int n = 0; n < 10000; ++n) {
    v = kicked(v, -x, dt);
    drift(x, rest, v, dt);
  }
  EXPECT_NEAR(0.5 * (x * x + v * v), 0.5, 0.5 * dt);
}

// A million steps of a ten-millionth of the place: a float alone would stand still, as each is below half its last digit.
TEST(EulerCromer, SmallStepsAreNotLost) {
  float x = 1;
  float rest = 0;
  float v = 1;
  const float dt = 2e-8F;
  ASSERT_EQ(x + dt * v, x);
  for (int n = 0; n < 1000000; ++n) drift(x, rest, v, dt);
  // 10^6 steps of the float nearest to 2e-8; the pair of floats has 2^-48 per step.
  EXPECT_NEAR(static_cast<double>(x) + rest, 1 + 1e6 * static_cast<double>(dt), 1e6 * 0x1p-48);
}

}  // namespace
}  // namespace weir
