// The terms of the momentum equation between two particles: each a struct with its parameters and one pure function,
// summed by the pair engine; a term that a scene lacks is not in the sum. Constants are multiplied before the loop.
//
// [Hinsch24]   J. Hinsch, A Simple 2D SPH Fluid Solver, University of Freiburg, 2024.
// [Morris97]   J. P. Morris, P. J. Fox, Y. Zhu, Modeling low Reynolds number incompressible flows using SPH,
//              J. Comput. Phys. 136 (1997) 214-226; in the form of [Ihmsen14].
// [Monaghan92] J. J. Monaghan, Smoothed particle hydrodynamics, Annu. Rev. Astron. Astrophys. 30 (1992) 543-574.
// [Monaghan05] J. J. Monaghan, Smoothed particle hydrodynamics, Rep. Prog. Phys. 68 (2005) 1703-1759.
// [Ihmsen14]   M. Ihmsen, J. Orthmann, B. Solenthaler, A. Kolb, M. Teschner, SPH fluids in computer graphics,
//              Eurographics 2014 state of the art reports.
#pragma once

#include "equations/pair.h"

namespace weir {

// 0.01 h^2 keeps the quotients of the viscosities finite when two particles meet. [Morris97, softening]
constexpr double viscosity_softening = 0.01;

// The consistent viscosities take the neighbour's volume with the pair's mean density instead of rho_j alone,
// V_ij = m_j / rho_ij: the forces of a pair are then opposite, and momentum is conserved to round-off; the difference is
// of second order.
// 2 rho_ij = rho_i + rho_j, kg/m^Dim. [Monaghan05, mean density]
template <int Dim, class R>
R twice_mean_density(const Pair<Dim, R>& pair) {
  return pair.rho_i + pair.rho_j;
}

struct Pressure {
  static constexpr bool action_is_reaction = true;
  static constexpr bool reads_velocity = false;

  // -m_j (p_i/rho_i^2 + p_j/rho_j^2) grad W_ij, m/s^2. [Hinsch24 Alg. 1, fluid]
  template <int Dim, class R>
  Central<R> from_fluid(const Pair<Dim, R>& pair) const {
    return {(pair.pressure_term_i + pair.pressure_term_j) * pair.f};
  }
  // The wall mirrors the particle's own pressure: -2 m_j p_i/rho_i^2 grad W_ij, m/s^2. [Hinsch24 Alg. 1, wall]
  template <int Dim, class R>
  Central<R> from_wall(const Pair<Dim, R>& pair) const {
    return {R(2) * pair.pressure_term_i * pair.f};
  }
};

// Viscosities act from fluid and, where walls hold the fluid (no slip), from walls: a wall particle then acts as fluid
// that has the wall's velocity. Quotients are formed once per pair, as division is slow.

// Consistent at any h/dx, 100.5 % of nu lap u on the lattice at h = dx; conserves linear momentum.
struct MorrisViscosity {
  static constexpr bool action_is_reaction = true;
  static constexpr bool reads_velocity = true;
  Real factor;     // -4 nu, m^2/s: the 2 of 2 nu, and that of twice the mean density
  Real softening;  // viscosity_softening h^2, m^2

  template <int Dim>
  static MorrisViscosity of(double nu, double h) {
    return {static_cast<Real>(-4 * nu), static_cast<Real>(viscosity_softening * h * h)};
  }

  // 2 nu V_ij u_ij (x_ij . grad W_ij) / (r^2 + 0.01 h^2), m/s^2. [Morris97, viscosity]
  template <int Dim, class R>
  Drag<R> from_fluid(const Pair<Dim, R>& pair) const {
    return {quotient(R(factor) * (pair.r2 * pair.f), twice_mean_density(pair) * (pair.r2 + R(softening)))};
  }
  template <int Dim, class R>
  Drag<R> from_wall(const Pair<Dim, R>& pair) const {
    return from_fluid(pair);
  }
};

// What Monaghan's form and Hinsch's share: factor m_j / rho (u_ij . x_ij) / (r^2 + softening) grad W_ij, m/s^2, whose
// factor has the minus of F_ij. [Monaghan05, central friction]
template <int Dim, class R>
Central<R> central_friction(const Pair<Dim, R>& pair, R factor, R rho, R softening) {
  return {quotient(factor * (dot(pair.v_ij, pair.x_ij) * pair.f), rho * (pair.r2 + softening))};
}

// Consistent from h = 2 dx on (96 % there, 66 % at h = dx); conserves linear and angular momentum.
struct MonaghanViscosity {
  static constexpr bool action_is_reaction = true;
  static constexpr bool reads_velocity = true;
  Real factor;     // -4 (Dim + 2) nu, m^2/s: the 2, and that of twice the mean density
  Real softening;  // viscosity_softening h^2, m^2

  template <int Dim>
  static MonaghanViscosity of(double nu, double h) {
    return {static_cast<Real>(-4 * (Dim + 2) * nu), static_cast<Real>(viscosity_softening * h * h)};
  }

  // 2 (Dim + 2) nu V_ij (u_ij . x_ij) / (r^2 + 0.01 h^2) grad W_ij, m/s^2. [Monaghan05, viscosity]
  template <int Dim, class R>
  Central<R> from_fluid(const Pair<Dim, R>& pair) const {
    return central_friction(pair, R(factor), twice_mean_density(pair), R(softening));
  }
  template <int Dim, class R>
  Central<R> from_wall(const Pair<Dim, R>& pair) const {
    return from_fluid(pair);
  }
};

// What damps shocks alone: the friction of MonaghanViscosity between particles that approach each other. Its alpha is
// 2 (Dim + 2) nu / (h c0).
struct ArtificialViscosity {
  static constexpr bool action_is_reaction = true;
  static constexpr bool reads_velocity = true;
  Real factor;     // -4 (Dim + 2) nu, m^2/s
  Real softening;  // viscosity_softening h^2, m^2

  template <int Dim>
  static ArtificialViscosity of(double nu, double h) {
    const MonaghanViscosity both = MonaghanViscosity::of<Dim>(nu, h);
    return {both.factor, both.softening};
  }

  // alpha h c0 min(u_ij . x_ij, 0) / (rho_ij (r^2 + 0.01 h^2)) grad W_ij, m/s^2. [Monaghan92 eq. 4.2]
  template <int Dim, class R>
  Central<R> from_fluid(const Pair<Dim, R>& pair) const {
    const R approach = -positive_part(-dot(pair.v_ij, pair.x_ij));
    return {quotient(R(factor) * (approach * pair.f), twice_mean_density(pair) * (pair.r2 + R(softening)))};
  }
  template <int Dim, class R>
  Central<R> from_wall(const Pair<Dim, R>& pair) const {
    return from_fluid(pair);
  }
};

// As printed, with factor 2 where 2 (Dim + 2) is consistent: only 16 % of nu lap u at h = dx in 2D. For the paper's
// pictures, not for accuracy.
struct Hinsch2024Viscosity {
  static constexpr bool reads_velocity = true;
  static constexpr bool action_is_reaction = false;  // rho_j alone
  Real factor;                                       // -2 nu, m^2/s
  Real softening;                                    // viscosity_softening h^2, m^2

  template <int Dim>
  static Hinsch2024Viscosity of(double nu, double h) {
    return {static_cast<Real>(-2 * nu), static_cast<Real>(viscosity_softening * h * h)};
  }

  // 2 nu m_j / rho_j (u_ij . x_ij) / (r^2 + 0.01 h^2) grad W_ij, m/s^2. [Hinsch24 eq. 4.5]
  template <int Dim, class R>
  Central<R> from_fluid(const Pair<Dim, R>& pair) const {
    return central_friction(pair, R(factor), pair.rho_j, R(softening));
  }
  template <int Dim, class R>
  Central<R> from_wall(const Pair<Dim, R>& pair) const {
    return from_fluid(pair);
  }
};

struct Hinsch2024SurfaceTension {
  static constexpr bool action_is_reaction = true;
  Real factor;  // -s / m, m^(Dim + 2)/(kg s^2): strength, over the mass that F_ij holds

  static Hinsch2024SurfaceTension of(double s, double m) { return {static_cast<Real>(-s / m)}; }

  // s grad W_ij, fluid neighbours only: points into the fluid where neighbours lack on one side. [Hinsch24 Alg. 2]
  template <int Dim, class R>
  Central<R> from_fluid(const Pair<Dim, R>& pair) const {
    return {R(factor) * pair.f};
  }
};

}  // namespace weir
