// Walls with a pressure of their own: sums from the fluid to wall particles, and the wall's state from them.
#pragma once

#include "equations/kernels.h"
#include "equations/state.h"
#include "equations/wall_state.h"
#include "sph/passes/density.h"
#include "sph/passes/momentum.h"
#include "sph/passes/pass.h"

namespace weir {

// Sums of W, of the pressure that the fluid has there times W, and, where walls hold the fluid, of its velocity and of the
// displacement from it times W; W over the kernel's alpha.
template <int Dim, template <int> class Kernel, bool no_slip>
struct WallStatePass {
  static constexpr int dimension = Dim;
  static constexpr int components = no_slip ? 2 + 2 * Dim : 2;
  static constexpr bool prunes = true;  // the only loop over these lists

  KernelAt<Kernel<Dim>, Real> kernel;
  MomentumInput<Dim> of_fluid;
  Vec<Dim, Real> g_minus_a_w{};  // m/s^2

  template <class R>
  struct Seen {
    Vec<Dim, R> v;
    R rho;
    R p;
  };

  Real start(int) const { return 0; }
  template <class R, class Load>
  Empty target(const Load&) const {
    return {};
  }
  template <class R, class Load>
  Seen<R> source(const Load& load) const {
    const R rho = load(of_fluid.density);
    Seen<R> seen;
    seen.rho = rho;
    seen.p = pressure_of_term(load(of_fluid.pressure_term), rho);
    if constexpr (no_slip) seen.v = of_fluid.velocity.template read<R>(load);
    return seen;
  }
  template <class R>
  Vec<components, R> pair(Empty, const Seen<R>& j, const Vec<Dim, R>& x_wj, R r2) const {
    const R w = kernel.shape(square_root(r2));
    Vec<Dim, R> g;
    for (int d = 0; d < Dim; ++d) g[d] = R(g_minus_a_w[d]);
    Vec<components, R> sums;
    sums[0] = w;
    sums[1] = w * pressure_seen_at_wall(j.p, j.rho, g, x_wj);
    if constexpr (no_slip) {
      for (int d = 0; d < Dim; ++d) {
        sums[2 + d] = w * j.v[d];
        sums[2 + Dim + d] = w * x_wj[d];
      }
    }
    return sums;
  }
};

// Pressure, density and the velocity that the fluid's viscosity meets, of wall particles. What no fluid is near keeps the
// rest density and the wall's velocity, and is read by nothing.
template <int Dim, bool no_slip>
struct WallState {
  static constexpr int components = no_slip ? 2 + 2 * Dim : 2;
  using Result = Empty;
  template <class R>
  using Running = Empty;

  StateEquation state;
  VectorInput<Dim> wall_velocity;
  const float* depth = nullptr;  // behind the face, m
  Real least_distance = 0;       // of the fluid from the face, m
  float* density = nullptr;
  float* pressure_term = nullptr;  // p / rho^2
  float* velocity[Dim] = {};

  template <class Slots>
  void operator()(const Slots& at, Empty&) const {
    using R = typename Slots::Number;
    const R weights = at.sum(0);
    const R mean = shepard_mean(at.sum(1), weights);
    const R p = state.clamp ? positive_part(mean) : mean;
    const R c = compression_of_state(p, R(state.stiffness), state.exponent);
    const R rho = multiply_add(R(state.rest_density), c, R(state.rest_density));
    at.store(rho, density);
    at.store(at.of_particles(pressure_over_density_squared(p, rho), R(0)), pressure_term);
    if constexpr (no_slip) {
      Vec<Dim, R> displacement;
      for (int d = 0; d < Dim; ++d) displacement[d] = shepard_mean(at.sum(2 + Dim + d), weights);
      const R ratio = distance_ratio(at.load(depth), displacement, R(least_distance));
      for (int d = 0; d < Dim; ++d) {
        const R v_wall = at.load(wall_velocity.component[d]);
        const R v = no_slip_velocity(v_wall, shepard_mean(at.sum(2 + d), weights), ratio);
        at.store(at.of_particles(v, R(0)), velocity[d]);
      }
    }
  }
  Empty result(Empty) const { return {}; }
};

}  // namespace weir
