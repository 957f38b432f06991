// The state of a simulation, and sums over it.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "sph/simulation.h"

namespace weir {

struct Particle {
  Vec3 x{0};       // m
  Vec3 v{0};       // m/s
  double rho = 0;  // kg/m^Dim
  double p = 0;    // Pa
};

inline std::vector<Particle> particles(Simulation& simulation, int dimension = 2) {
  Snapshot snapshot;
  simulation.fill(snapshot, {.fluid_positions = Precision::exact,
                             .fluid = {Quantity::velocity, Quantity::density, Quantity::pressure}});
  const SetSnapshot& fluid = snapshot.fluid;
  const std::vector<float>& v = fluid.reals(Quantity::velocity);
  std::vector<Particle> list(fluid.count);
  for (std::size_t i = 0; i < fluid.count; ++i) {
    list[i].x = fluid.exact_positions[i];
    for (int d = 0; d < dimension; ++d) list[i].v[d] = static_cast<double>(v[i * dimension + d]);
    list[i].rho = static_cast<double>(fluid.reals(Quantity::density)[i]);
    list[i].p = static_cast<double>(fluid.reals(Quantity::pressure)[i]);
  }
  return list;
}

// Kinetic energy, and that of compression, the integral of p / rho^2 over rho from rho0; J.
inline double energy(const Scene& scene, const std::vector<Particle>& particles) {
  const int n = scene.solver.exponent;
  double sum = 0;
  for (const Particle& particle : particles) {
    const double r = particle.rho / scene.fluid.rest_density;
    const double work = n == 1 ? std::log(r) : (std::pow(r, n - 1) - 1) / (n - 1);
    sum += dot(particle.v, particle.v) / 2 + stiffness(scene) / scene.fluid.rest_density * (work + 1 / r - 1);
  }
  return sum * particle_mass(scene);
}

// Steps until run time has reached `time`, s.
inline void run_to(Simulation& simulation, double time) {
  while (simulation.time() < time && !simulation.finished()) simulation.step();
}

// log2 of how much smaller an error is at half the spacing.
inline double observed_order(double coarse, double fine) { return std::log2(coarse / fine); }

}  // namespace weir
