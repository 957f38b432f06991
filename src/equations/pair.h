// What a formula between two particles may use. The pair engine fills it; loads that no formula needs are dropped by
// the compiler.
#pragma once

#include "core/types.h"

namespace weir {

// i is the particle, j its neighbour, ij is i minus j. R is a number, or a register of them: one i, several j.
template <int Dim, class R = Real>
struct Pair {
  Vec<Dim, R> x_ij;  // m
  Vec<Dim, R> v_ij;  // m/s
  R r2;              // |x_ij|^2, m^2
  R dw_over_r;       // W'(r) / r: grad W_ij = dw_over_r x_ij, m^-(Dim + 2)
  R m_j;             // kg
  R rho_i;           // kg/m^Dim
  R rho_j;           // the rest density for a wall
  R pressure_i;      // p_i / rho_i^2, m^5/(kg s^2) in 3D
  R pressure_j;      // p_j / rho_j^2; unused with a mirroring wall
};

}  // namespace weir
