// Pressure from density.
//
// [Hinsch24] J. Hinsch, A Simple 2D SPH Fluid Solver, University of Freiburg, 2024.
// [Cole48]   R. H. Cole, Underwater Explosions, Princeton, 1948: the exponent 7 of water.
#pragma once

#include <cmath>

#include "core/math.h"
#include "core/types.h"

namespace weir {

// p, Pa, at rho / rho0 = `ratio`: Tait's equation for exponent 7, the linear one for exponent 1.
// [Hinsch24 ch. 4.4, Tait]
template <class R>
R pressure_of_state(R ratio, R k, int exponent) {
  return k * (integer_power(ratio, exponent) - R(1));
}

// The same from c = rho/rho0 - 1: k ((1 + c)^n - 1) by Horner's rule for the binomial sum, which loses no digits where c is
// small. [Hinsch24 ch. 4.4, Tait of compression]
template <class R>
R pressure_of_compression(R c, R k, int exponent) {
  // (1 + c)^n - 1 = s_n with s_1 = c and s_n = s_(n-1) (1 + c) + c.
  R s = c;
  for (int n = 1; n < exponent; ++n) s = multiply_add(s, c, s + c);
  return k * s;
}

// p_i / rho_i^2, the form in which the momentum equation takes it. [Hinsch24 Alg. 1, p/rho^2]
template <class R>
R pressure_over_density_squared(R p, R rho) {
  return p / (rho * rho);
}

// The pressure that this form stands for, Pa. [Hinsch24 Alg. 1, p]
template <class R>
R pressure_of_term(R p_over_rho_squared, R rho) {
  return p_over_rho_squared * rho * rho;
}

// rho / rho0 - 1 at pressure p: exact for exponent 1, else to the square of itself over two times exponent - 1.
// [Cole48, compression]
template <class R>
R compression_of_state(R p, R k, int exponent) {
  return p / (R(exponent) * k);
}

// c0 = sqrt(dp/drho at rho0) = sqrt(exponent k / rho0), m/s. [Cole48, sound speed]
inline double sound_speed_of_state(double k, int exponent, double rest_density) {
  return std::sqrt(exponent * k / rest_density);
}

// c / c0 at this density over the rest density: c^2 = dp/drho. One for stretched fluid, whose sound is slower.
// [Cole48, compressed sound]
template <class R>
R sound_speed_ratio(R compression, int exponent) {
  return square_root(integer_power(larger(compression, R(1)), exponent - 1));
}

// The inverse: k, Pa. [Cole48, stiffness]
inline double stiffness_of_state(double c0, int exponent, double rest_density) {
  return rest_density * c0 * c0 / exponent;
}

}  // namespace weir
