// The particles of a run, one array per quantity.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/team.h"
#include "core/types.h"

namespace weir {

// Fluid. The arrays share one order, which follows space and changes when neighbours are sorted; `id` is the particle's
// number in the scene's order and travels with it.
template <int Dim>
struct FluidParticles {
  std::vector<Vec<Dim, double>> position;  // m
  std::vector<Vec<Dim>> velocity;          // m/s
  std::vector<std::int32_t> id;
  // Worked out anew in every step:
  std::vector<Real> density;           // kg/m^Dim
  std::vector<Real> pressure;          // p / rho^2
  std::vector<Vec<Dim>> acceleration;  // m/s^2

  std::size_t size() const { return position.size(); }

  // The particle order[k] comes to place k. Quantities that every step works out are not carried along.
  void reorder(const std::vector<std::int32_t>& order, Team& team);
};

// Walls do not move and have no state: their particles are positions alone.
template <int Dim>
struct WallParticles {
  std::vector<Vec<Dim, double>> position;  // m
  std::size_t size() const { return position.size(); }
};

extern template struct FluidParticles<2>;
extern template struct FluidParticles<3>;

}  // namespace weir
