// curl v of the fluid, over the kernel's slope factor. A quantity to look at: no method needs it.
#pragma once

#include "equations/kernels.h"
#include "equations/vorticity.h"
#include "sph/passes/pass.h"

namespace weir {

template <int Dim, template <int> class Kernel>
struct VorticityPass {
  static constexpr int dimension = Dim;
  static constexpr int components = rotation_components<Dim>;
  static constexpr Reaction reaction = Reaction::both;
  static constexpr bool prunes = false;

  KernelAt<Kernel<Dim>, Real> kernel;
  VectorInput<Dim> velocity;
  const float* density = nullptr;

  template <class R>
  struct State {
    Vec<Dim, R> v;
    R rho;
  };

  Real start(int) const { return 0; }
  template <class R, class Load>
  State<R> target(const Load& load) const {
    return {velocity.template read<R>(load), load(density)};
  }
  template <class R, class Load>
  State<R> source(const Load& load) const {
    return target<R>(load);
  }
  template <class R>
  Both<components, R> both(const State<R>& i, const State<R>& j, const Vec<Dim, R>& x_ij, R r2) const {
    const R f = kernel.slope(square_root(r2));
    const Vec<Dim, R> v_ij = i.v - j.v;
    return {vorticity(f, j.rho, v_ij, x_ij), vorticity(f, i.rho, v_ij, x_ij)};
  }
};

template <int Dim>
struct SummedVorticity {
  static constexpr int components = rotation_components<Dim>;
  using Result = Empty;
  template <class R>
  using Running = Empty;

  Real factor = 0;  // of the sums: -m times the kernel's slope factor
  float* vorticity[components] = {};

  template <class Slots>
  void operator()(const Slots& at, Empty&) const {
    using R = typename Slots::Number;
    for (int c = 0; c < components; ++c) at.store(at.of_particles(R(factor) * at.sum(c), R(0)), vorticity[c]);
  }
  Empty result(Empty) const { return {}; }
};

}  // namespace weir
