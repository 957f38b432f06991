// Energies of one particle, for the log, and the speeds that energies can turn into.
//
// [mechanics] L. D. Landau, E. M. Lifshitz, Mechanics, 3rd ed., Butterworth-Heinemann, 1976, sec. 4 to 6.
// [Hinsch24]  J. Hinsch, A Simple 2D SPH Fluid Solver, University of Freiburg, 2024.
#pragma once

#include <cmath>

#include "core/types.h"

namespace weir {

// J (per metre of depth in 2D). [mechanics, kinetic energy]
template <int Dim>
double kinetic_energy(double m, const Vec<Dim, double>& v) {
  return 0.5 * m * dot(v, v);
}

// J, zero at the origin. [mechanics, potential energy]
template <int Dim>
double potential_energy(double m, const Vec<Dim, double>& g, const Vec<Dim, double>& x) {
  return -m * dot(g, x);
}

// v^2 gained by falling through `height`, m^2/s^2. [mechanics, fall]
inline double speed_squared_of_fall(double g, double height) { return 2 * g * height; }

// The pressure that brings fluid at rest to speed v, or stops it, Pa. [mechanics, dynamic pressure]
inline double dynamic_pressure(double rho, double v) { return 0.5 * rho * v * v; }

// v^2 that the cohesion of strength s can give a particle, up to a factor near one, m^2/s^2: s W is its energy per mass,
// and W is about dx^-dimension. [Hinsch24 Alg. 2, energy]
inline double speed_squared_of_cohesion(double s, double dx, int dimension) { return s / std::pow(dx, dimension); }

}  // namespace weir
