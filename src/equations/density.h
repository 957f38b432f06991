// Density by summation.
//
// [Hinsch24] J. Hinsch, A Simple 2D SPH Fluid Solver, University of Freiburg, 2024.
#pragma once

#include "core/types.h"

namespace weir {

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
