// The rate of change of the density, over the rest density and the kernel's slope factor.
#pragma once

#include "equations/continuity.h"
#include "equations/kernels.h"
#include "sph/passes/density.h"
#include "sph/passes/pass.h"

namespace weir {

template <int Dim, class R>
struct ContinuityState {
  Vec<Dim, R> v;
  R compression;
};

// Between particles of the fluid: continuity, and diffusion of what differs from the density at rest.
template <int Dim, template <int> class Kernel>
struct ContinuityPass {
  static constexpr int dimension = Dim;
  static constexpr int components = 1;
  static constexpr Reaction reaction = Reaction::both;
  static constexpr bool prunes = false;

  KernelAt<Kernel<Dim>, Real> kernel;
  VectorInput<Dim> velocity;
  const float* compression = nullptr;  // rho / rho0 - 1
  Real diffusivity = 0;                // m^2/s
  Vec<Dim, Real> g_per_c0_squared{};   // 1/m

  Real start(int) const { return 0; }
  template <class R, class Load>
  ContinuityState<Dim, R> target(const Load& load) const {
    return {velocity.template read<R>(load), load(compression)};
  }
  template <class R, class Load>
  ContinuityState<Dim, R> source(const Load& load) const {
    return target<R>(load);
  }
  template <class R>
  Both<1, R> both(const ContinuityState<Dim, R>& i, const ContinuityState<Dim, R>& j, const Vec<Dim, R>& x_ij,
                  R r2) const {
    const R f = kernel.slope(square_root(r2));
    const R rate = compression_rate(f, i.v - j.v, x_ij);
    Vec<Dim, R> g;
    for (int d = 0; d < Dim; ++d) g[d] = R(g_per_c0_squared[d]);
    const R diffusion = density_diffusion(f, R(diffusivity), j.compression - i.compression,
                                          hydrostatic_compression_difference(g, x_ij));
    return {{rate + diffusion}, {rate - diffusion}};
  }
};

// From walls that move with `velocity`, or are at rest where it is null: continuity alone.
template <int Dim, template <int> class Kernel>
struct WallContinuityPass {
  static constexpr int dimension = Dim;
  static constexpr int components = 1;
  static constexpr bool prunes = false;

  KernelAt<Kernel<Dim>, Real> kernel;
  VectorInput<Dim> velocity;

  Real start(int) const { return 0; }
  template <class R, class Load>
  Vec<Dim, R> target(const Load& load) const {
    return velocity.template read<R>(load);
  }
  template <class R, class Load>
  Empty source(const Load&) const {
    return {};
  }
  template <class R>
  Vec<1, R> pair(const Vec<Dim, R>& v_i, Empty, const Vec<Dim, R>& x_ij, R r2) const {
    return {compression_rate(kernel.slope(square_root(r2)), v_i, x_ij)};
  }
};

// d c / dt of c = rho / rho0 - 1, from the sums of the passes above. Kept apart, for other tiles still read c.
struct SummedCompressionRate {
  static constexpr int components = 1;
  using Result = Empty;
  template <class R>
  using Running = Empty;

  Real factor = 0;        // of the sums: -m times the kernel's slope factor over rho0
  float* rate = nullptr;  // 1/s

  template <class Slots>
  void operator()(const Slots& at, Empty&) const {
    using R = typename Slots::Number;
    at.store(at.of_particles(R(factor) * at.sum(0), R(0)), rate);
  }
  Empty result(Empty) const { return {}; }
};

// Density and pressure from the carried compression c, after it has been advanced by dt times its rate, or as it is.
template <bool advances>
struct CarriedDensity {
  static constexpr int components = 0;
  using Result = Empty;
  template <class R>
  using Running = Empty;

  Real dt = 0;                  // s
  const float* rate = nullptr;  // 1/s
  StateEquation state;
  float* compression = nullptr;
  float* density = nullptr;
  float* pressure_term = nullptr;  // p / rho^2

  template <class Slots>
  void operator()(const Slots& at, Empty&) const {
    using R = typename Slots::Number;
    R c = at.load(compression);
    if constexpr (advances) {
      c = multiply_add(R(dt), at.load(rate), c);
      at.store(c, compression);
    }
    const R rho = multiply_add(R(state.rest_density), c, R(state.rest_density));
    at.store(rho, density);
    at.store(at.of_particles(state.pressure_term_of_compression(c, rho), R(0)), pressure_term);
  }
  Empty result(Empty) const { return {}; }
};

}  // namespace weir
