// Velocity fields that a run can start from. State must not depend on the math library, so sine is a polynomial here.
//
// [TaylorGreen37] G. I. Taylor, A. E. Green, Mechanism of the production of small eddies from large ones, Proceedings of
//                 the Royal Society A 158 (1937) 499-521.
#pragma once

#include <cmath>
#include <numbers>

#include "core/types.h"

namespace weir {

// sin(2 pi t); the absolute error is below 1e-15. Whole turns are taken off t exactly.
inline double sine_of_turns(double t) {
  t -= std::round(t);
  if (t > 0.25) t = 0.5 - t;
  if (t < -0.25) t = -0.5 - t;
  const double y = 2 * std::numbers::pi * t;  // at most pi / 2, where the next term of the series is 3e-18
  const double square = y * y;
  double sum = 1;
  for (int n = 20; n >= 2; n -= 2) sum = 1 - square / (n * (n + 1)) * sum;
  return y * sum;
}

inline double cosine_of_turns(double t) { return sine_of_turns(t - std::round(t) + 0.25); }

// u = -U cos(2 pi x / L) sin(2 pi y / L), v = U sin(2 pi x / L) cos(2 pi y / L), w = 0, m/s. [TaylorGreen37 eq. 1]
inline Vec3 taylor_green_velocity(double speed, double wave_length, const Vec3& x) {
  const Vec3 t = x / wave_length;
  return {-speed * cosine_of_turns(t.x) * sine_of_turns(t.y), speed * sine_of_turns(t.x) * cosine_of_turns(t.y), 0};
}

}  // namespace weir
