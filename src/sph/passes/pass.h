// A pass: what a loop over pairs sums, in terms of equations/; the pair engine does the visiting. R is a number, or a
// register of them.
//
// A pass is plain data, copied into the loop, and has
//   dimension
//   components                how many sums it forms per particle, up to nine
//   reaction                  how a pair of one set acts on its other particle
//   prunes                    whether the loop leaves pruned lists behind
//   start(component)          what a sum begins with: what a particle adds to its own
//   target<R>(load), source<R>(load)   what is read of each of the two beside the position: load(array) gives its value
//   pair(i, j, x_ij, r2)      what j adds to the sums of i
//   both(i, j, x_ij, r2)      with Reaction::both, in place of pair(): what each adds to the other's
#pragma once

#include "core/types.h"

namespace weir {

// same: j gets what i gets; opposite: its negative; exchanged: the pass is asked again with i and j exchanged; both: the
// pass says both at once.
enum class Reaction { same, opposite, exchanged, both };

// What is read where nothing is; what a loop finds that finds nothing.
struct Empty {};

template <int components, class R>
struct Both {
  Vec<components, R> to_i;
  Vec<components, R> to_j;
};

// A squared distance (m^2) at which every kernel is zero, for pairs that must not count.
constexpr float beyond_support = 1e24F;

// The same pass, leaving pruned lists behind: for the first loop over pairs of a step.
template <class Pass>
struct Pruning : Pass {
  static constexpr bool prunes = true;
};

// Components of a vector quantity, as a pass reads them.
template <int Dim>
struct VectorInput {
  const float* component[Dim] = {};

  template <class R, class Load>
  Vec<Dim, R> read(const Load& load) const {
    Vec<Dim, R> value;
    for (int d = 0; d < Dim; ++d) value[d] = load(component[d]);
    return value;
  }
};

}  // namespace weir
