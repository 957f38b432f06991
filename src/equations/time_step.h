// How long a time step may be, and the step itself.
//
// [Hinsch24]   J. Hinsch, A Simple 2D SPH Fluid Solver, University of Freiburg, 2024.
// [Monaghan92] J. J. Monaghan, Smoothed particle hydrodynamics, Annu. Rev. Astron. Astrophys. 30 (1992) 543-574.
// [Monaghan05] J. J. Monaghan, Smoothed particle hydrodynamics, Rep. Prog. Phys. 68 (2005) 1703-1759.
// [Morris97]   J. P. Morris, P. J. Fox, Y. Zhu, Modeling low Reynolds number incompressible flows using SPH,
//              J. Comput. Phys. 136 (1997) 214-226.
#pragma once

#include <cmath>

#include "core/types.h"

namespace weir {

// The share of its smoothing length that the fastest particle crosses in dt, 1; Hinsch's indicator is green while it is
// at most lambda. [Hinsch24 ch. 6.6.2, CFL]
inline double cfl_number(double dt, double v_max, double h) { return dt * v_max / h; }

// dt <= lambda h / v_max, s. [Hinsch24 ch. 6.6.2, dt]
inline double velocity_limit(double lambda, double h, double v_max) { return lambda * h / v_max; }

// How fast what a particle does may reach others, m/s: by its own sound and its own motion. [Monaghan92, signal]
template <class R>
R signal_speed(R c, R v) {
  return c + v;
}

// dt <= factor h / max (c + v), s: no signal may outrun the kernel. [Monaghan92, sound]
inline double acoustic_limit(double factor, double h, double max_signal_speed) { return factor * h / max_signal_speed; }

// dt <= factor sqrt(h / a_max), s. [Monaghan92, force]
inline double force_limit(double factor, double h, double a_max) { return factor * std::sqrt(h / a_max); }

// dt <= factor h^2 / nu, s. [Morris97, time step]
inline double viscous_limit(double factor, double h, double nu) { return factor * h * h / nu; }

// The nu of that limit where friction acts along the line between two particles, m^2/s: nu (lap u + 2 grad div u) in the
// limit, so that waves of compression spread with 3 nu. [Monaghan05, compression]
inline double central_diffusivity(double nu) { return 3 * nu; }

// Euler-Cromer, of one component: velocity first, m/s, then position with the new velocity.
// [Hinsch24 Alg. 3, velocity]
template <class R>
R kicked(R v, R a, R dt) {
  return multiply_add(dt, a, v);
}

// The position x, m, comes with the rounding error that it owes. [Hinsch24 Alg. 3, position]
template <class R>
void drift(R& x, R& owed, R v, R dt) {
  compensated_add(x, owed, dt * v);
}

}  // namespace weir
