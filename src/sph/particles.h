// The particles of a run, one array per quantity and component.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/aligned.h"
#include "core/thread_pool.h"
#include "sph/positions.h"
#include "sph/tiling.h"

namespace weir {

// Fluid. The arrays share one order of slots, which follows space and changes when particles are sorted. Empty slots
// hold zero velocity.
template <int Dim>
struct FluidParticles : Positions<Dim> {
  std::array<AlignedVector<float>, Dim> velocity;  // m/s
  std::size_t count = 0;                           // particles; slots() is a little more

  // Worked out anew in every step:
  AlignedVector<float> density;                        // kg/m^Dim
  AlignedVector<float> pressure_term;                  // p / rho^2
  std::array<AlignedVector<float>, Dim> acceleration;  // m/s^2

  Vec<Dim> velocity_of(std::size_t slot) const { return of(velocity, slot); }
  Vec<Dim> acceleration_of(std::size_t slot) const { return of(acceleration, slot); }

  // After the positions were sorted: what travels with a particle follows, what is worked out anew gets its size.
  void follow(const Tiling<Dim>& tiling, ThreadPool& pool);

 private:
  static Vec<Dim> of(const std::array<AlignedVector<float>, Dim>& values, std::size_t slot) {
    Vec<Dim> value{};
    for (int d = 0; d < Dim; ++d) value[d] = values[d][slot];
    return value;
  }
};

// Walls do not move and have no state: their particles are positions alone.
template <int Dim>
using WallParticles = Positions<Dim>;

extern template struct FluidParticles<2>;
extern template struct FluidParticles<3>;

}  // namespace weir
