// Sums and extremes over the particles, for a row of the log.
#pragma once

#include <algorithm>

#include "core/parallel.h"
#include "equations/density.h"
#include "equations/energy.h"
#include "frame/diagnostics.h"
#include "sph/solver.h"

namespace weir {

// What of a row is a sum or an extreme over particles; the solver is fresh. Positions are those of the user's coordinates:
// `origin` (m) is where the solver's begin, and a particle that went round a periodic axis has gone on.
template <int Dim>
Diagnostics sum_of_particles(const SphSolver<Dim>& solver, const Scene& scene, const Vec3& gravity, const Vec3& origin,
                             ThreadPool& pool) {
  const ParticleSet<Dim>& fluid = solver.fluid();
  const double m = solver.particle_mass();
  const auto g = from_scene<Dim, double>(gravity);
  const auto start = from_scene<Dim, double>(origin);
  const Vec<Dim, double> period = solver.search().lattice().periodic().length;

  struct Sums {
    double error = 0, compression = 0, max_compression = 0, kinetic = 0, potential = 0;
    Vec<Dim, double> momentum{}, center{};
  };
  const Sums sums = parallel_reduce(
      fluid.slots(), pool, Sums{},
      [&](std::size_t begin, std::size_t end) {
        Sums block;
        for (std::size_t slot = begin; slot < end; ++slot) {
          if (fluid.empty(slot)) continue;
          const double error = density_error(static_cast<double>(solver.density().at(slot)), scene.fluid.rest_density);
          const auto v = convert<double>(fluid.vector_at(solver.velocity(), slot));
          const Vec<Dim, double> x = start + fluid.unwrapped_position(slot, period);
          block.error += error;
          block.compression += positive_part(error);
          block.max_compression = std::max(block.max_compression, error);
          block.kinetic += kinetic_energy(m, v);
          block.potential += potential_energy(m, g, x);
          block.momentum += m * v;
          block.center += x;
        }
        return block;
      },
      [](Sums a, const Sums& b) {
        a.error += b.error;
        a.compression += b.compression;
        a.max_compression = std::max(a.max_compression, b.max_compression);
        a.kinetic += b.kinetic;
        a.potential += b.potential;
        a.momentum += b.momentum;
        a.center += b.center;
        return a;
      });

  const double n = static_cast<double>(std::max<std::size_t>(fluid.count, 1));
  Diagnostics row;
  row.mean_density_error = sums.error / n;
  row.mean_compression = sums.compression / n;
  row.max_density_error = sums.max_compression;
  row.kinetic_energy = sums.kinetic;
  row.potential_energy = sums.potential;
  for (int d = 0; d < Dim; ++d) {
    row.momentum[d] = sums.momentum[d];
    row.center_of_mass[d] = sums.center[d] / n;
  }
  return row;
}

}  // namespace weir
