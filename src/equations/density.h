// Density by summation.
//
// [Hinsch24] J. Hinsch, A Simple 2D SPH Fluid Solver, University of Freiburg, 2024.
#pragma once

#include <cmath>

#include "core/types.h"

namespace weir {

// The mass of a particle that stands for a cell of a lattice of spacing dx, kg (per metre of depth in 2D).
// [Hinsch24 ch. 6.5, mass]
inline double lattice_mass(double rest_density, double dx, int dimension) {
  return rest_density * std::pow(dx, dimension);
}

// What a particle of mass m_j at kernel value w_ij adds to rho_i, kg/m^Dim; the particle itself and walls add too.
// [Hinsch24 eq. 4.3]
template <class R>
R density_contribution(R m_j, R w_ij) {
  return m_j * w_ij;
}

// Relative deviation from rest, 1. [Hinsch24 ch. 7, error]
template <class R>
R density_error(R rho, R rest_density) {
  return rho / rest_density - R(1);
}

}  // namespace weir
