// The pair engine: the only code that visits neighbours. It owns loops, threads and memory access; what happens between
// two particles comes from equations/, through a pass.
//
// A pass is a struct with
//   Sum        begin(i)                  what particle i starts from,
//   void       fluid(sum, i, j, x_ij, r2)  one fluid neighbour,
//   void       wall(sum, i, j, x_ij, r2)   one wall neighbour; left out when walls do not matter to it,
//   void       end(i, sum)               stores the result.
// Each particle sums over its own neighbours, in the order of its list, and writes only itself: the result is the same
// for any number of threads, and nothing is locked.
#pragma once

#include "core/parallel.h"
#include "equations/pair.h"
#include "sph/neighbours.h"

namespace weir {

template <int Dim, class Pass>
void visit_pairs(const FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls, const Neighbours<Dim>& neighbours,
                 Team& team, const Pass& pass) {
  parallel_blocks(fluid.size(), team, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec<Dim, double> x_i = fluid.position[i];
      auto sum = pass.begin(i);
      for (const std::int32_t j : neighbours.fluid().of(i)) {
        const Vec<Dim> x_ij = convert<Real>(x_i - fluid.position[j]);
        pass.fluid(sum, i, j, x_ij, dot(x_ij, x_ij));
      }
      if constexpr (requires { pass.wall(sum, i, 0, Vec<Dim>{}, Real{}); }) {
        for (const std::int32_t j : neighbours.walls().of(i)) {
          const Vec<Dim> x_ij = convert<Real>(x_i - walls.position[j]);
          pass.wall(sum, i, j, x_ij, dot(x_ij, x_ij));
        }
      }
      pass.end(i, sum);
    }
  });
}

// The sum of what each term says about a pair; a term without a rule for it adds nothing, and is not there after
// compiling.
template <int Dim, class R, class... Terms>
Vec<Dim, R> fluid_acceleration(const Pair<Dim, R>& pair, const Terms&... terms) {
  Vec<Dim, R> a{};
  const auto add = [&](const auto& term) {
    if constexpr (requires { term.from_fluid(pair); }) a += term.from_fluid(pair);
  };
  (add(terms), ...);
  return a;
}

template <int Dim, class R, class... Terms>
Vec<Dim, R> wall_acceleration(const Pair<Dim, R>& pair, const Terms&... terms) {
  Vec<Dim, R> a{};
  const auto add = [&](const auto& term) {
    if constexpr (requires { term.from_wall(pair); }) a += term.from_wall(pair);
  };
  (add(terms), ...);
  return a;
}

}  // namespace weir
