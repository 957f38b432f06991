// Updates that move particles.
#pragma once

#include "core/types.h"
#include "equations/time_step.h"
#include "sph/pair_lists.h"
#include "sph/passes/pass.h"

namespace weir {

// What moving particles by one step found.
template <int Dim>
struct MotionExtremes {
  float speed_squared = 0;       // largest, m^2/s^2
  bool runaway = false;          // a particle moved farther than `reach`, or is not finite
  DisplacementBox<Dim> moved{};  // of one tile

  void combine(const MotionExtremes& other) {
    speed_squared = larger(speed_squared, other.speed_squared);
    runaway = runaway || other.runaway;
  }
};

// v += dt a, and with `drifts` x += dt v: together Euler-Cromer. Empty slots stay where they are: all that they read is
// zero or nowhere. (In a tile's first register they count as particles at rest, which makes lists of a few particles stale
// a little early.)
template <int Dim, bool kicks, bool drifts>
struct Motion {
  static constexpr int components = 0;
  using Result = MotionExtremes<Dim>;
  template <class R>
  struct Running {
    R least[Dim]{};
    R most[Dim]{};
    R speed_squared{};
    bool runaway = false;
  };

  Real dt = 0;     // s
  Real reach = 0;  // m
  VectorInput<Dim> acceleration;
  float* x[Dim] = {};
  float* compensation[Dim] = {};
  float* velocity[Dim] = {};

  template <class Slots>
  void operator()(const Slots& at, Running<typename Slots::Number>& running) const {
    using R = typename Slots::Number;
    R speed_squared{};
    for (int d = 0; d < Dim; ++d) {
      R v = at.load(velocity[d]);
      if constexpr (kicks) {
        v = kicked(v, at.load(acceleration.component[d]), R(dt));
        at.store(v, velocity[d]);
      }
      if constexpr (drifts) {
        R position = at.load(x[d]);
        R owed = at.load(compensation[d]);
        drift(position, owed, v, R(dt));
        at.store(position, x[d]);
        at.store(owed, compensation[d]);
        running.least[d] = at.first() ? v : at.of_particles(smaller(running.least[d], v), running.least[d]);
        running.most[d] = at.first() ? v : at.of_particles(larger(running.most[d], v), running.most[d]);
      }
      speed_squared = multiply_add(v, v, speed_squared);
    }
    running.speed_squared = larger(running.speed_squared, speed_squared);
    // Written so that a speed that is NaN is caught, too.
    running.runaway = running.runaway || !all(at_most(R(dt) * R(dt) * speed_squared, R(reach) * R(reach)));
  }
  template <class R>
  Result result(const Running<R>& running) const {
    Result extremes;
    extremes.speed_squared = greatest(running.speed_squared);
    extremes.runaway = running.runaway;
    for (int d = 0; d < Dim; ++d) {
      extremes.moved.least[d] = dt * least(running.least[d]);
      extremes.moved.greatest[d] = dt * greatest(running.most[d]);
    }
    return extremes;
  }
};

template <int Dim>
using EulerCromer = Motion<Dim, true, true>;
template <int Dim>
using Kick = Motion<Dim, true, false>;
template <int Dim>
using Drift = Motion<Dim, false, true>;

}  // namespace weir
