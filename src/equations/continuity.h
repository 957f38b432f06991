// The rate of change of a particle's density: the continuity equation, and a diffusion that damps its noise. Terms between
// two particles, linear in F_ij = -m_j W'(r) / r as the terms of the momentum equation are (pair.h).
//
// [Monaghan92]  J. J. Monaghan, Smoothed particle hydrodynamics, Annu. Rev. Astron. Astrophys. 30 (1992) 543-574.
// [Molteni09]   D. Molteni, A. Colagrossi, A simple procedure to improve the pressure evaluation in hydrodynamic context
//               using the SPH, Comput. Phys. Commun. 180 (2009) 861-872.
// [Fourtakas19] G. Fourtakas, J. M. Dominguez, R. Vacondio, B. D. Rogers, Local uniform stencil (LUST) boundary condition
//               for arbitrary 3-D boundaries in parallel smoothed particle hydrodynamics (SPH) models, Comput. Fluids 190
//               (2019) 346-361.
#pragma once

#include "core/math.h"
#include "core/types.h"

namespace weir {

// What j adds to d rho_i / dt: m_j v_ij . grad W_ij, kg/(m^Dim s). j gets the same from i. [Monaghan92, continuity]
template <int Dim, class R>
R compression_rate(R f, const Vec<Dim, R>& v_ij, const Vec<Dim, R>& x_ij) {
  return -(f * dot(v_ij, x_ij));
}

// The factor of the diffusion of density differences, 2 delta h c0, m^2/s. [Molteni09, coefficient]
inline double density_diffusivity(double delta, double h, double c0) { return 2 * delta * h * c0; }

// How far the density of j at rest differs from that of i, over the rest density: rho^H_ji / rho0 = g . x_ji / c0^2, linear
// in the depth. [Fourtakas19, hydrostatic]
template <int Dim, class R>
R hydrostatic_compression_difference(const Vec<Dim, R>& g_per_c0_squared, const Vec<Dim, R>& x_ij) {
  return -dot(g_per_c0_squared, x_ij);
}

// What j adds to d rho_i / dt by diffusion, over what c_j - c_i is to rho: 2 delta h c0 (c_ji - c^H_ji) F_ij / rho0 with
// c = rho / rho0 - 1 and the neighbour's volume m_j / rho0; j gets the opposite. [Fourtakas19, diffusion]
template <class R>
R density_diffusion(R f, R diffusivity, R c_ji, R hydrostatic_c_ji) {
  return diffusivity * (c_ji - hydrostatic_c_ji) * f;
}

}  // namespace weir
