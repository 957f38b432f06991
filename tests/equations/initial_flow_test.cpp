#include "equations/initial_flow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace weir {
namespace {

TEST(InitialFlow, SineOfTurnsAgreesWithTheLibrary) {
  for (int i = -4000; i <= 4000; ++i) {
    const double t = i / 1000.0;
    EXPECT_NEAR(sine_of_turns(t), std::sin(2 * std::numbers::pi * t), 1e-14) << t;  // the library's argument is rounded
    EXPECT_NEAR(cosine_of_turns(t), std::cos(2 * std::numbers::pi * t), 1e-14) << t;
  }
  EXPECT_EQ(sine_of_turns(1e15), 0);
  EXPECT_NEAR(sine_of_turns(0.25), 1, 1e-15);
}

TEST(InitialFlow, TaylorGreenVorticesHaveNoDivergenceAndTheGivenSpeed) {
  const double U = 3;
  const double L = 2;
  const double d = 1e-5;
  double fastest = 0;
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) {
      const Vec3 x(i * L / 40, j * L / 40, 0.3);
      const auto slope = [&](int axis) {
        Vec3 step(0);
        step[axis] = d;
        return (taylor_green_velocity(U, L, x + step)[axis] - taylor_green_velocity(U, L, x - step)[axis]) / (2 * d);
      };
      EXPECT_NEAR(slope(0) + slope(1), 0, 1e-8);
      fastest = std::max(fastest, glm::length(taylor_green_velocity(U, L, x)));
    }
  }
  EXPECT_NEAR(fastest, U, 1e-12);
  // Counterclockwise about (0, 0): upwards right of it.
  EXPECT_GT(taylor_green_velocity(U, L, {0.1, 0, 0}).y, 0);
  EXPECT_LT(taylor_green_velocity(U, L, {0, 0.1, 0}).x, 0);
}

}  // namespace
}  // namespace weir
