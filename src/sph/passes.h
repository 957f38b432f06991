// What a pair loop works out: a pass names what it reads of a particle and what two particles contribute, in terms of
// equations/; the pair engine does the visiting. R is a number, or a register of them.
//
// A pass has
//   components                       how many sums it forms per particle
//   reaction                         how a pair acts on its other particle
//   state<R>(load)                   what is read of a particle beside its place: load(array) gives its value
//   fluid(i, j, x_ij, r2)            what fluid neighbour j adds to the sums of i
//   wall(i, x_ij, r2)                what a wall neighbour adds
#pragma once

#include "equations/kernels.h"
#include "equations/momentum.h"
#include "equations/pair.h"

namespace weir {

// same: j gets what i gets; opposite: its negative; own: the pass is asked again with i and j exchanged.
enum class Reaction { same, opposite, own };

// A squared distance (m^2) at which every kernel is zero, for pairs that must not count.
constexpr float beyond_support = 1e24F;

// The sum of W_ij / alpha: what is constant is multiplied once, at the end.
template <int Dim, class Kernel>
struct DensityPass {
  static constexpr int components = 1;
  static constexpr Reaction reaction = Reaction::same;
  template <class R>
  struct State {};

  Kernel kernel;

  template <class R, class Load>
  State<R> state(const Load&) const {
    return {};
  }
  template <class R>
  Vec<1, R> fluid(const State<R>&, const State<R>&, const Vec<Dim, R>&, R r2) const {
    return {kernel.shape(square_root(r2))};
  }
  template <class R>
  Vec<1, R> wall(const State<R>&, const Vec<Dim, R>&, R r2) const {
    return {kernel.shape(square_root(r2))};
  }
};

// Accelerations: the sum over neighbours of what the terms say, over the kernel's slope factor: what is constant is
// multiplied once, at the end. Fluid and walls have passes of their own, as they differ in their terms.
template <int Dim>
struct AccelerationInput {
  float rest_density;
  const float* velocity[Dim];
  const float* density;
  const float* pressure_term;  // p / rho^2
};

template <int Dim, class R>
struct AccelerationState {
  Vec<Dim, R> v;
  R rho;
  R pressure_term;
};

template <int Dim, class R, class Load>
AccelerationState<Dim, R> read_state(const AccelerationInput<Dim>& in, const Load& load) {
  AccelerationState<Dim, R> state;
  for (int d = 0; d < Dim; ++d) state.v[d] = load(in.velocity[d]);
  state.rho = load(in.density);
  state.pressure_term = load(in.pressure_term);
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
  Vec<Dim, R> from_wall(const Pair<Dim, R>& pair) const {
    return acceleration(pair, (... + static_cast<const Terms&>(*this).from_wall(pair)));
  }
};

template <int Dim, class Kernel, class... Terms>
struct FluidAcceleration {
  static constexpr int components = Dim;
  static constexpr Reaction reaction = (Terms::action_is_reaction && ...) ? Reaction::opposite : Reaction::own;
  template <class R>
  using State = AccelerationState<Dim, R>;

  Kernel kernel;
  AccelerationInput<Dim> in;
  TermSet<Terms...> terms;

  template <class R, class Load>
  State<R> state(const Load& load) const {
    return read_state<Dim, R>(in, load);
  }
  template <class R>
  Vec<Dim, R> fluid(const State<R>& i, const State<R>& j, const Vec<Dim, R>& x_ij, R r2) const {
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

// Walls are at rest, and have the rest density.
template <int Dim, class Kernel, class... Terms>
struct WallAcceleration {
  static constexpr int components = Dim;
  template <class R>
  using State = AccelerationState<Dim, R>;

  Kernel kernel;
  AccelerationInput<Dim> in;
  TermSet<Terms...> terms;

  template <class R, class Load>
  State<R> state(const Load& load) const {
    return read_state<Dim, R>(in, load);
  }
  template <class R>
  Vec<Dim, R> wall(const State<R>& i, const Vec<Dim, R>& x_ij, R r2) const {
    const Pair<Dim, R> pair{.x_ij = x_ij,
                            .v_ij = i.v,
                            .r2 = r2,
                            .f = kernel.slope(square_root(r2)),
                            .rho_i = i.rho,
                            .rho_j = R(in.rest_density),
                            .pressure_term_i = i.pressure_term,
                            .pressure_term_j = R(0)};
    return terms.from_wall(pair);
  }
};

}  // namespace weir
