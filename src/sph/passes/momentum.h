// Accelerations: the sum over neighbours of what the terms of the momentum equation say, over the kernel's slope factor:
// what is constant is multiplied once, at the end.
#pragma once

#include "equations/kernels.h"
#include "equations/momentum.h"
#include "equations/pair.h"
#include "equations/state.h"
#include "equations/time_step.h"
#include "sph/passes/pass.h"

namespace weir {

// Of one set. Velocities may be null where no term reads them.
template <int Dim>
struct MomentumInput {
  VectorInput<Dim> velocity;
  const float* density = nullptr;
  const float* pressure_term = nullptr;  // p / rho^2
};

template <int Dim, class R>
struct MomentumState {
  Vec<Dim, R> v{};
  R rho;
  R pressure_term;
};

template <bool reads_velocity, int Dim, class R, class Load>
MomentumState<Dim, R> read_state(const MomentumInput<Dim>& in, const Load& load) {
  MomentumState<Dim, R> state{.rho = load(in.density), .pressure_term = load(in.pressure_term)};
  if constexpr (reads_velocity) state.v = in.velocity.template read<R>(load);
  return state;
}

// Several terms as one; no std::tuple, whose functions every instruction set would share.
template <class... Terms>
struct TermSet : Terms... {
  template <int Dim, class R>
  Vec<Dim, R> from_fluid(const Pair<Dim, R>& pair) const {
    return acceleration(pair, (... + static_cast<const Terms&>(*this).from_fluid(pair)));
  }
  template <int Dim, class R>
  Vec<Dim, R> from_mirror(const Pair<Dim, R>& pair) const {
    return acceleration(pair, (... + static_cast<const Terms&>(*this).from_wall(pair)));
  }
};

// From a set that has a density, a pressure and a velocity of its own: fluid, or walls that are extrapolated from it.
template <int Dim, template <int> class Kernel, class... Terms>
struct MomentumPass {
  static constexpr int dimension = Dim;
  static constexpr int components = Dim;
  static constexpr Reaction reaction = (Terms::action_is_reaction && ...) ? Reaction::opposite : Reaction::exchanged;
  static constexpr bool prunes = false;

  KernelAt<Kernel<Dim>, Real> kernel;
  MomentumInput<Dim> of_target;
  MomentumInput<Dim> of_source;
  TermSet<Terms...> terms;

  Real start(int) const { return 0; }
  template <class R, class Load>
  MomentumState<Dim, R> target(const Load& load) const {
    return read_state<(Terms::reads_velocity || ...), Dim, R>(of_target, load);
  }
  template <class R, class Load>
  MomentumState<Dim, R> source(const Load& load) const {
    return read_state<(Terms::reads_velocity || ...), Dim, R>(of_source, load);
  }
  template <class R>
  Vec<Dim, R> pair(const MomentumState<Dim, R>& i, const MomentumState<Dim, R>& j, const Vec<Dim, R>& x_ij,
                   R r2) const {
    const Pair<Dim, R> pair{.x_ij = x_ij,
                            .v_ij = i.v - j.v,
                            .r2 = r2,
                            .f = kernel.slope(square_root(r2)),
                            .rho_i = i.rho,
                            .rho_j = j.rho,
                            .pressure_term_i = i.pressure_term,
                            .pressure_term_j = j.pressure_term};
    return terms.from_fluid(pair);
  }
};

// From walls that mirror the particle's own pressure, are at rest, and have the rest density: nothing is read of them.
template <int Dim, template <int> class Kernel, class... Terms>
struct MirroredMomentumPass {
  static constexpr int dimension = Dim;
  static constexpr int components = Dim;
  static constexpr bool prunes = false;

  KernelAt<Kernel<Dim>, Real> kernel;
  MomentumInput<Dim> of_target;
  Real rest_density;
  TermSet<Terms...> terms;

  Real start(int) const { return 0; }
  template <class R, class Load>
  MomentumState<Dim, R> target(const Load& load) const {
    return read_state<(Terms::reads_velocity || ...), Dim, R>(of_target, load);
  }
  template <class R, class Load>
  Empty source(const Load&) const {
    return {};
  }
  template <class R>
  Vec<Dim, R> pair(const MomentumState<Dim, R>& i, Empty, const Vec<Dim, R>& x_ij, R r2) const {
    const Pair<Dim, R> pair{.x_ij = x_ij,
                            .v_ij = i.v,
                            .r2 = r2,
                            .f = kernel.slope(square_root(r2)),
                            .rho_i = i.rho,
                            .rho_j = R(rest_density),
                            .pressure_term_i = i.pressure_term,
                            .pressure_term_j = R(0)};
    return terms.from_mirror(pair);
  }
};

// The cohesion between fluid particles: a pass of its own, as few scenes have it.
template <int Dim, template <int> class Kernel>
struct CohesionPass {
  static constexpr int dimension = Dim;
  static constexpr int components = Dim;
  static constexpr Reaction reaction = Reaction::opposite;
  static constexpr bool prunes = false;

  KernelAt<Kernel<Dim>, Real> kernel;
  Hinsch2024SurfaceTension term;

  Real start(int) const { return 0; }
  template <class R, class Load>
  Empty target(const Load&) const {
    return {};
  }
  template <class R, class Load>
  Empty source(const Load&) const {
    return {};
  }
  template <class R>
  Vec<Dim, R> pair(Empty, Empty, const Vec<Dim, R>& x_ij, R r2) const {
    Pair<Dim, R> pair{};
    pair.x_ij = x_ij;
    pair.f = kernel.slope(square_root(r2));
    return acceleration(pair, term.from_fluid(pair));
  }
};

// What bounds the time step, the largest of all particles.
struct ForceExtremes {
  float acceleration_squared = 0;  // m^2/s^4
  float signal_speed = 0;          // m/s

  void combine(const ForceExtremes& other) {
    acceleration_squared = larger(acceleration_squared, other.acceleration_squared);
    signal_speed = larger(signal_speed, other.signal_speed);
  }
};

// a = sum + g, from the sums of the passes above.
template <int Dim>
struct SummedForce {
  static constexpr int components = Dim;
  using Result = ForceExtremes;
  template <class R>
  struct Running {
    R acceleration_squared{};
    R signal_speed{};
  };

  Real factor = 0;  // of the sums: -m times the kernel's slope factor
  Vec<Dim, Real> gravity{};
  Real per_rest_density = 0;  // 1 / rho0
  Real sound_speed = 0;       // at rest density, m/s
  int exponent = 0;
  VectorInput<Dim> velocity;
  const float* density = nullptr;
  float* acceleration[Dim] = {};

  template <class Slots>
  void operator()(const Slots& at, Running<typename Slots::Number>& running) const {
    using R = typename Slots::Number;
    R square{};
    R speed_squared{};
    for (int d = 0; d < Dim; ++d) {
      const R a = at.of_particles(multiply_add(R(factor), at.sum(d), R(gravity[d])), R{});
      at.store(a, acceleration[d]);
      square = multiply_add(a, a, square);
      const R v = at.load(velocity.component[d]);
      speed_squared = multiply_add(v, v, speed_squared);
    }
    running.acceleration_squared = larger(running.acceleration_squared, square);
    const R ratio = sound_speed_ratio(at.load(density) * R(per_rest_density), exponent);
    running.signal_speed =
        larger(running.signal_speed, signal_speed(R(sound_speed) * ratio, square_root(speed_squared)));
  }
  template <class R>
  Result result(const Running<R>& running) const {
    return {greatest(running.acceleration_squared), greatest(running.signal_speed)};
  }
};

}  // namespace weir
