// The rotation of the fluid around a particle.
//
// [Monaghan92] J. J. Monaghan, Smoothed particle hydrodynamics, Annu. Rev. Astron. Astrophys. 30 (1992) 543-574.
#pragma once

#include "core/math.h"
#include "core/types.h"

namespace weir {

// Components of a rotation: one in 2D, along z.
template <int Dim>
constexpr int rotation_components = Dim == 2 ? 1 : 3;

// v_ij x x_ij, m^2/s.
template <int Dim, class R>
Vec<rotation_components<Dim>, R> cross(const Vec<Dim, R>& v, const Vec<Dim, R>& x) {
  if constexpr (Dim == 2) {
    return {minus_product(v[0] * x[1], v[1], x[0])};
  } else {
    return {minus_product(v[1] * x[2], v[2], x[1]), minus_product(v[2] * x[0], v[0], x[2]),
            minus_product(v[0] * x[1], v[1], x[0])};
  }
}

// What j adds to curl v of i: m_j / rho_j v_ij x grad W_ij, 1/s, with F_ij = -m_j W'(r) / r. [Monaghan92, curl]
template <int Dim, class R>
Vec<rotation_components<Dim>, R> vorticity(R f, R rho_j, const Vec<Dim, R>& v_ij, const Vec<Dim, R>& x_ij) {
  return -(f / rho_j) * cross(v_ij, x_ij);
}

}  // namespace weir
