// Density by summation, and pressure from it.
#pragma once

#include "equations/density.h"
#include "equations/kernels.h"
#include "equations/state.h"
#include "sph/passes/pass.h"

namespace weir {

// The sum of W_ij / alpha, over neighbours and the particle itself: what is constant is multiplied once, at the end.
template <int Dim, template <int> class Kernel>
struct DensityPass {
  static constexpr int dimension = Dim;
  static constexpr int components = 1;
  static constexpr Reaction reaction = Reaction::same;
  static constexpr bool prunes = true;  // the first loop over pairs of a step

  KernelAt<Kernel<Dim>, Real> kernel;
  Real own = kernel.shape(Real(0));

  Real start(int) const { return own; }
  template <class R, class Load>
  Empty target(const Load&) const {
    return {};
  }
  template <class R, class Load>
  Empty source(const Load&) const {
    return {};
  }
  template <class R>
  Vec<1, R> pair(Empty, Empty, const Vec<Dim, R>&, R r2) const {
    return {kernel.shape(square_root(r2))};
  }
};

// What the equation of state needs beside the density.
struct StateEquation {
  Real rest_density = 0;
  Real stiffness = 0;  // k, Pa
  int exponent = 0;
  bool clamp = false;  // p < 0 becomes 0

  // p / rho^2 at this density.
  template <class R>
  R pressure_term(R rho) const {
    const R p = pressure_of_state(rho / R(rest_density), R(stiffness), exponent);
    return pressure_over_density_squared(clamp ? positive_part(p) : p, rho);
  }
  // The same from c = rho / rho0 - 1, which has the digits that rho lacks.
  template <class R>
  R pressure_term_of_compression(R c, R rho) const {
    const R p = pressure_of_compression(c, R(stiffness), exponent);
    return pressure_over_density_squared(clamp ? positive_part(p) : p, rho);
  }
};

// rho = m sum W, p = p(rho), from the sums of a DensityPass.
struct SummedDensity {
  static constexpr int components = 1;
  using Result = Empty;
  template <class R>
  using Running = Empty;

  Real mass = 0;   // kg
  Real alpha = 0;  // of the kernel, m^-Dim
  StateEquation state;
  float* density = nullptr;
  float* pressure_term = nullptr;  // p / rho^2

  template <class Slots>
  void operator()(const Slots& at, Empty&) const {
    using R = typename Slots::Number;
    const R rho = at.of_particles(density_contribution(R(mass), R(alpha) * at.sum(0)), R(state.rest_density));
    at.store(rho, density);
    at.store(at.of_particles(state.pressure_term(rho), R(0)), pressure_term);
  }
  Empty result(Empty) const { return {}; }
};

}  // namespace weir
