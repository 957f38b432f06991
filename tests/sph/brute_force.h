// The solver's twin: the equations of one step in double, over all pairs, written from the sources that src/equations
// names and not from its code; and what single precision may differ from it.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "scene/sampling.h"
#include "scene/scene.h"
#include "sph/solver.h"

namespace weir {

// Of one operation in single precision, relative.
constexpr double rounding = 0x1p-24;

// Relative. Errors of either sign grow as the root of their number: 10 roundings for the up to 100 terms of a sum in 3D,
// and as much again for what each term's own operations and the distances (good to 1e-6 spacings, of which the same
// share of the kernel's width is seen) leave. In all less than 30 roundings.
constexpr double density_tolerance = 2e-6;

// Of the largest acceleration, given the densities and pressures. Distances are good to 1e-6 dx, which changes grad W by
// some 1e-5 of its largest value; sums of 100 terms of either sign add less.
constexpr double acceleration_tolerance = 2e-5;

// A disordered start: every particle is moved by up to 0.2 dx and given a random velocity.
inline Sampling shaken(const Scene& scene, unsigned seed) {
  Sampling sampling = sample(scene);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  for (std::size_t i = 0; i < sampling.fluid_positions.size(); ++i) {
    for (int d = 0; d < scene.dimension; ++d) {
      sampling.fluid_positions[i][d] += 0.2 * scene.particle_spacing * u(random);
      sampling.fluid_velocities[i][d] = u(random);
    }
  }
  return sampling;
}

template <int Dim>
void accelerate(SphSolver<Dim>& solver) {
  solver.refresh();
  solver.accelerate();
}

template <int Dim>
double norm(const Vec<Dim, double>& x) {
  return std::sqrt(dot(x, x));
}

template <int Dim>
double largest_norm(const std::vector<Vec<Dim, double>>& vectors) {
  double largest = 0;
  for (const auto& each : vectors) largest = std::max(largest, norm(each));
  return largest;
}

// What the solver holds, in the order of ids and in double.
template <int Dim>
struct State {
  std::vector<Vec<Dim, double>> position, velocity, acceleration, wall;
  std::vector<double> density, pressure, pressure_term;  // the last is p / rho^2

  explicit State(const SphSolver<Dim>& solver) {
    const auto& fluid = solver.fluid();
    for (auto* each : {&position, &velocity, &acceleration}) each->resize(fluid.count);
    for (auto* each : {&density, &pressure, &pressure_term}) each->resize(fluid.count);
    for (std::size_t slot = 0; slot < fluid.slots(); ++slot) {
      if (fluid.empty(slot)) continue;
      const auto i = static_cast<std::size_t>(fluid.id[slot]);
      position[i] = fluid.position(slot);
      velocity[i] = convert<double>(fluid.vector_at(solver.velocity(), slot));
      acceleration[i] = convert<double>(fluid.vector_at(solver.acceleration(), slot));
      density[i] = solver.density().at(slot);
      pressure[i] = solver.pressure_at(slot);
      pressure_term[i] = solver.pressure_term().at(slot);
    }
    for (std::size_t slot = 0; slot < solver.walls().slots(); ++slot) {
      if (!solver.walls().empty(slot)) wall.push_back(solver.walls().position(slot));
    }
  }
  std::size_t size() const { return position.size(); }
};

template <int Dim>
struct BruteForce {
  using V = Vec<Dim, double>;
  const Scene& scene;
  const State<Dim>& state;
  double h = smoothing_length(scene);
  double m = particle_mass(scene);
  double rho0 = scene.fluid.rest_density;
  double k = stiffness(scene);
  double n = scene.solver.exponent;
  double nu = scene.fluid.viscosity.kinematic;
  KernelName kernel = scene.solver.kernel.name;
  std::vector<V> images = images_of(scene);  // displacements of the scene's copies, itself the first

  // One copy to each side along each periodic axis.
  static std::vector<V> images_of(const Scene& scene) {
    const Bounds extent = periodic_extent(scene);
    std::vector<V> all{V{}};
    for (int d = 0; d < Dim; ++d) {
      if (!is_periodic(scene, d)) continue;
      for (std::size_t image = all.size(); image-- > 0;) {
        for (const double sign : {-1.0, 1.0}) {
          V moved = all[image];
          moved[d] += sign * (extent.max[d] - extent.min[d]);
          all.push_back(moved);
        }
      }
    }
    return all;
  }
  // visit(j, x_ij) for every other particle of `others`, and every image.
  template <class Visit>
  void for_each_other(const V& x_i, const std::vector<V>& others, std::size_t self, const Visit& visit) const {
    for (std::size_t j = 0; j < others.size(); ++j) {
      for (std::size_t image = 0; image < images.size(); ++image) {
        if (j == self && image == 0) continue;
        const V x_ij = x_i - others[j] - images[image];
        if (dot(x_ij, x_ij) < 4 * h * h) visit(j, x_ij);
      }
    }
  }
  static constexpr auto none = static_cast<std::size_t>(-1);

  // W h^Dim, by q.
  double w(double r) const {
    const double q = r / h;
    if (q >= 2) return 0;
    const double volume = std::pow(h, Dim);
    switch (kernel) {
      case KernelName::wendland_c2:
        return (Dim == 2 ? 7 / (4 * pi) : 21 / (16 * pi)) / volume * std::pow(1 - q / 2, 4) * (1 + 2 * q);
      case KernelName::wendland_c4:
        return (Dim == 2 ? 9 / (4 * pi) : 495 / (256 * pi)) / volume * std::pow(1 - q / 2, 6) *
               (1 + 3 * q + 35 * q * q / 12);
      case KernelName::cubic_spline:
        break;
    }
    return (Dim == 2 ? 5 / (14 * pi) : 1 / (4 * pi)) / volume *
           (std::pow(2 - q, 3) - (q < 1 ? 4 * std::pow(1 - q, 3) : 0));
  }
  // By a central difference of w, to 1e-8 of its largest value.
  V grad_w(const V& x) const {
    const double r = norm(x);
    if (r >= 2 * h || r == 0) return V{};
    const double step = 1e-5 * h;
    return ((w(r + step) - w(r - step)) / (2 * step) / r) * x;
  }

  double density(std::size_t i) const {
    double rho = m * w(0);
    const auto add = [&](std::size_t, const V& x_ij) { rho += m * w(norm(x_ij)); };
    for_each_other(state.position[i], state.position, i, add);
    for_each_other(state.position[i], state.wall, none, add);
    return rho;
  }
  std::vector<double> densities() const {
    std::vector<double> rho(state.size());
    for (std::size_t i = 0; i < rho.size(); ++i) rho[i] = density(i);
    return rho;
  }

  double pressure(double rho) const {
    const double p = k * (std::pow(rho / rho0, n) - 1);
    return scene.solver.negative_pressure == NegativePressure::clamp ? std::max(0.0, p) : p;
  }
  // What the solver's may differ. The power raises the error of the density, of the quotient by the rest density and of
  // its own products n times; the difference, k, its product, rho^2 and the quotient by that are rounded once each.
  double pressure_tolerance(double rho) const {
    const double power = std::pow(rho / rho0, n);
    return k * power * n * (density_tolerance + 2 * rounding) + 5 * rounding * std::abs(pressure(rho));
  }

  // p / rho^2, and what the solver's may differ.
  double term(double rho) const { return pressure(rho) / (rho * rho); }
  double term_tolerance(double rho) const {
    return pressure_tolerance(rho) / (rho * rho) + 2 * density_tolerance * std::abs(term(rho));
  }

  V acceleration(std::size_t i, const std::vector<double>& rho) const {
    V a = from_scene<Dim, double>(scene.gravity);
    const auto viscous = [&](const V& x_ij, const V& v_ij, double volume) {  // Morris' form
      const double r2 = dot(x_ij, x_ij);
      return (2 * nu * volume * dot(x_ij, grad_w(x_ij)) / (r2 + 0.01 * h * h)) * v_ij;
    };
    for_each_other(state.position[i], state.position, i, [&](std::size_t j, const V& x_ij) {
      a += (-m * (term(rho[i]) + term(rho[j]))) * grad_w(x_ij);
      a += viscous(x_ij, state.velocity[i] - state.velocity[j], 2 * m / (rho[i] + rho[j]));
      a += scene.fluid.surface_tension.coefficient * grad_w(x_ij);
    });
    for_each_other(state.position[i], state.wall, none, [&](std::size_t, const V& x_ij) {
      a += (-2 * m * term(rho[i])) * grad_w(x_ij);
      a += viscous(x_ij, state.velocity[i], 2 * m / (rho[i] + rho0));
    });
    return a;
  }
  std::vector<V> accelerations(const std::vector<double>& rho) const {
    std::vector<V> a(state.size());
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = acceleration(i, rho);
    return a;
  }
  // What errors of the pressures make of the solver's acceleration of i, at most: its own acts through all of its
  // neighbours together, theirs each in the worst direction.
  V acceleration_tolerance_by_pressure(std::size_t i, const std::vector<double>& rho) const {
    V together{};
    V apart{};
    for_each_other(state.position[i], state.position, i, [&](std::size_t j, const V& x_ij) {
      const V gradient = m * grad_w(x_ij);
      together += gradient;
      for (int d = 0; d < Dim; ++d) apart[d] += term_tolerance(rho[j]) * std::abs(gradient[d]);
    });
    for_each_other(state.position[i], state.wall, none,
                   [&](std::size_t, const V& x_ij) { together += 2 * m * grad_w(x_ij); });
    for (int d = 0; d < Dim; ++d) apart[d] += term_tolerance(rho[i]) * std::abs(together[d]);
    return apart;
  }

  // c at this density where compressed, c0 elsewhere: c0^2 = n k / rho0, c^2 = dp/drho.
  double sound_speed(double rho) const {
    return std::sqrt(n * k / rho0) * std::pow(std::max(1.0, rho / rho0), (n - 1) / 2);
  }
  double signal_speed(std::size_t i, double rho) const { return sound_speed(rho) + norm(state.velocity[i]); }
};

}  // namespace weir
