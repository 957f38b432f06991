// Exact solutions of flows.
//
// [Morris97]      J. P. Morris, P. J. Fox, Y. Zhu, Modeling low Reynolds number incompressible flows using SPH, J. Comput.
//                 Phys. 136 (1997) 214-226.
// [TaylorGreen37] G. I. Taylor, A. E. Green, Mechanism of the production of small eddies from large ones, Proc. R. Soc. A
//                 158 (1937) 499-521.
#pragma once

#include <cmath>

#include "core/math.h"
#include "core/types.h"

namespace weir {

// Plates at y = 0 and y = d; fluid at rest starts to move at t = 0.
struct Channel {
  double d = 0;        // m
  double nu = 0;       // m^2/s
  double force = 0;    // F along the plates, m/s^2
  double v_upper = 0;  // of the upper plate, V0, m/s

  // [Morris97 eq. 20, 22]: F / (2 nu) y (d - y) + V0 y / d and the series that decays from it. Modes beyond the 200th are
  // below 1e-9 of the largest speed from nu t / d^2 = 1e-4 on.
  double velocity(double y, double t) const {
    double u = force / (2 * nu) * y * (d - y) + v_upper * y / d;
    for (int n = 1; n <= 200; ++n) {
      const double decay = std::sin(n * pi * y / d) * std::exp(-n * n * pi * pi * nu * t / (d * d));
      if (n % 2 == 1) u -= 4 * force * d * d / (nu * std::pow(n * pi, 3)) * decay;
      u += 2 * v_upper / (n * pi) * (n % 2 == 1 ? -1 : 1) * decay;
    }
    return u;
  }
  double top_speed() const { return force * d * d / (8 * nu) + std::abs(v_upper); }
};

// Vortices of speed U and wave length L. [TaylorGreen37]
struct DecayingVortices {
  double speed = 0;        // U, m/s
  double wave_length = 0;  // L, m
  double nu = 0;           // m^2/s

  double rate() const { return 8 * pi * pi * nu / (wave_length * wave_length); }  // 1/s
  Vec3 velocity(const Vec3& x, double t) const {
    const double a = 2 * pi * x.x / wave_length;
    const double b = 2 * pi * x.y / wave_length;
    const double u = speed * std::exp(-rate() * t);
    return {-u * std::cos(a) * std::sin(b), u * std::sin(a) * std::cos(b), 0};
  }
};

}  // namespace weir
