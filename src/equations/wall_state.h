// The state of a wall particle, extrapolated from the fluid around it.
//
// [Adami12] S. Adami, X. Y. Hu, N. A. Adams, A generalized wall boundary condition for smoothed particle hydrodynamics,
//           J. Comput. Phys. 231 (2012) 7057-7075.
#pragma once

#include "core/math.h"
#include "core/types.h"

namespace weir {

// The pressure of fluid particle j seen at wall particle w, Pa: p_j + rho_j (g - a_w) . x_wj, so that the gradient between
// them balances the body force and the wall's acceleration. [Adami12 eq. 27, pressure]
template <int Dim, class R>
R pressure_seen_at_wall(R p_j, R rho_j, const Vec<Dim, R>& g_minus_a_w, const Vec<Dim, R>& x_wj) {
  return multiply_add(rho_j, dot(g_minus_a_w, x_wj), p_j);
}

// The mean of what neighbours contributed, weighted by W; zero where there are none. [Adami12 eq. 22]
template <class R>
R shepard_mean(R sum, R sum_of_weights) {
  // Below this share of W(0) the mean is of a particle at the edge of the support, of no effect and hard to divide.
  constexpr float least = 1e-6F;
  return sum / larger(sum_of_weights, R(least));
}

// The velocity of a wall particle that holds the fluid, m/s: on the line through that of the wall at its face and the mean
// of the fluid before it. The paper takes both to be as far from the face, 2 v_wall - v_fluid, which is first order; here
// `ratio` is the distance of the wall particle over that of the fluid, so that a straight profile stays straight.
// [Adami12 eq. 23]
template <class R>
R no_slip_velocity(R v_wall, R mean_v_fluid, R ratio) {
  return multiply_add(ratio, v_wall - mean_v_fluid, v_wall);
}

// That ratio, from the wall particle's distance behind the face and the mean displacement from it to the fluid, m. Before a
// flat face the displacement is across it. [Adami12 eq. 23, distances]
template <int Dim, class R>
R distance_ratio(R depth, const Vec<Dim, R>& mean_displacement, R least_distance) {
  const R distance = square_root(dot(mean_displacement, mean_displacement)) - depth;
  return depth / larger(distance, least_distance);
}

}  // namespace weir
