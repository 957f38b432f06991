#include "sph/wcsph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "equations/kernels.h"
#include "equations/momentum.h"
#include "scene/sampling.h"
#include "support/scenes.h"

namespace weir {
namespace {

template <class T>
class WcsphIn : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(WcsphIn, Dimensions);

// A disordered start: every particle is moved by up to 0.2 dx and given a random velocity.
Sampling shaken(const Scene& scene, unsigned seed) {
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
void accelerate(Wcsph<Dim>& solver) {
  solver.find_neighbours();
  solver.compute_density_and_pressure();
  solver.compute_accelerations();
}

// What the solver holds, in the order of ids and in double.
template <int Dim>
struct State {
  std::vector<Vec<Dim, double>> position, velocity, acceleration, wall;
  std::vector<double> density;

  explicit State(const Wcsph<Dim>& solver) {
    const auto& fluid = solver.fluid();
    for (auto* each : {&position, &velocity, &acceleration}) each->resize(fluid.count);
    density.resize(fluid.count);
    for (std::size_t slot = 0; slot < fluid.slots(); ++slot) {
      if (fluid.empty(slot)) continue;
      const auto i = static_cast<std::size_t>(fluid.id[slot]);
      position[i] = fluid.position(slot);
      velocity[i] = convert<double>(fluid.velocity_of(slot));
      acceleration[i] = convert<double>(fluid.acceleration_of(slot));
      density[i] = fluid.density[slot];
    }
    for (std::size_t slot = 0; slot < solver.walls().slots(); ++slot) {
      if (!solver.walls().empty(slot)) wall.push_back(solver.walls().position(slot));
    }
  }
  std::size_t size() const { return position.size(); }
};

// The equations of physics.md once more, in double, over all pairs, written from the page and not from src/equations.
template <int Dim>
struct BruteForce {
  using V = Vec<Dim, double>;
  const Scene& scene;
  const State<Dim>& state;
  double h = smoothing_length(scene);
  double m = particle_mass(scene);
  double rho0 = scene.fluid.rest_density;
  double nu = scene.fluid.viscosity.kinematic;

  double alpha() const { return Dim == 2 ? 5 / (14 * pi * h * h) : 1 / (4 * pi * h * h * h); }
  double w(double r) const {
    const double q = r / h;
    return q >= 2 ? 0 : alpha() * (std::pow(2 - q, 3) - (q < 1 ? 4 * std::pow(1 - q, 3) : 0));
  }
  V grad_w(const V& x) const {
    const double r = std::sqrt(dot(x, x));
    const double q = r / h;
    if (q >= 2 || r == 0) return V{};
    return (alpha() / h * (-3 * std::pow(2 - q, 2) + (q < 1 ? 12 * std::pow(1 - q, 2) : 0)) / r) * x;
  }
  double density(std::size_t i) const {
    double rho = 0;
    for (const V& x_j : state.position) rho += m * w(norm(state.position[i] - x_j));
    for (const V& x_j : state.wall) rho += m * w(norm(state.position[i] - x_j));
    return rho;
  }
  static double norm(const V& x) { return std::sqrt(dot(x, x)); }
  double pressure(double rho) const {
    return std::max(0.0, stiffness(scene) * (std::pow(rho / rho0, scene.solver.exponent) - 1));
  }
  V acceleration(std::size_t i, const std::vector<double>& rho) const {
    V a = from_scene<Dim, double>(scene.gravity);
    const double term_i = pressure(rho[i]) / (rho[i] * rho[i]);
    const auto viscous = [&](const V& x_ij, const V& v_ij, double volume) {  // Morris' form
      const double r2 = dot(x_ij, x_ij);
      return (2 * nu * volume * dot(x_ij, grad_w(x_ij)) / (r2 + 0.01 * h * h)) * v_ij;
    };
    for (std::size_t j = 0; j < state.size(); ++j) {
      if (j == i) continue;
      const V x_ij = state.position[i] - state.position[j];
      a += (-m * (term_i + pressure(rho[j]) / (rho[j] * rho[j]))) * grad_w(x_ij);
      a += viscous(x_ij, state.velocity[i] - state.velocity[j], 2 * m / (rho[i] + rho[j]));
      a += scene.fluid.surface_tension.coefficient * grad_w(x_ij);
    }
    for (const V& x_j : state.wall) {
      const V x_ij = state.position[i] - x_j;
      a += (-2 * m * term_i) * grad_w(x_ij);
      a += viscous(x_ij, state.velocity[i], 2 * m / (rho[i] + rho0));
    }
    return a;
  }
};

TYPED_TEST(WcsphIn, DensityAndAccelerationEqualADoublePrecisionBruteForce) {
  constexpr int dim = TypeParam::value;
  Scene scene = small_dam_break(dim, dim == 2 ? 0.025 : 0.05);
  scene.fluid.viscosity = {ViscosityModel::morris, 0.01};
  scene.fluid.surface_tension = {SurfaceTensionModel::seed_a, dim == 2 ? 1e-4 : 1e-6};
  const Sampling sampling = shaken(scene, 3);
  Team team(2);
  for (const InstructionSet set : usable_instruction_sets()) {
    Wcsph<dim> solver(scene, sampling, team, set);
    accelerate(solver);
    const State<dim> state(solver);
    const BruteForce<dim> exact{scene, state};
    std::vector<double> rho(state.size());
    for (std::size_t i = 0; i < rho.size(); ++i) {
      rho[i] = exact.density(i);
      // Some 30 (2D) or 90 (3D) terms in single precision: far less than 30 eps = 2e-6 of the sum.
      EXPECT_NEAR(state.density[i], rho[i], 2e-6 * rho[i]) << name_of(set);
    }
    std::vector<Vec<dim, double>> a(state.size());
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      a[i] = exact.acceleration(i, rho);
      largest = std::max(largest, exact.norm(a[i]));
    }
    // rho/rho0 - 1 is formed from densities good to 2e-6, and the pressure raises that by the exponent 7; the terms that
    // cancel are of the size of the largest acceleration.
    const double tolerance = 7 * 2e-6 * 10;
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (int d = 0; d < dim; ++d) {
        EXPECT_NEAR(state.acceleration[i][d], a[i][d], tolerance * largest) << name_of(set);
      }
    }
  }
}

// Every choice of terms, kernel and instruction set against the same passes in double over all pairs: what the loops add
// is lists, masks, shifts between tiles and registers, and none of it may be seen in the result.
template <int Dim, class Kernel, class... Terms>
std::vector<Vec<Dim, double>> accelerations_over_all_pairs(const State<Dim>& state, const Scene& scene,
                                                           const std::vector<double>& pressure, const Kernel& kernel,
                                                           bool slip, const Terms&... terms) {
  const double rho0 = scene.fluid.rest_density;
  std::vector<Vec<Dim, double>> result(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) {
    result[i] = from_scene<Dim, double>(scene.gravity);
    Pair<Dim, double> pair{.x_ij = {},
                           .v_ij = {},
                           .r2 = 0,
                           .f = 0,
                           .rho_i = state.density[i],
                           .rho_j = 0,
                           .pressure_i = pressure[i],
                           .pressure_j = 0};
    const auto meet = [&](const Vec<Dim, double>& x_j) {
      pair.x_ij = state.position[i] - x_j;
      pair.r2 = dot(pair.x_ij, pair.x_ij);
      pair.f = kernel.derivative_over_r(std::sqrt(pair.r2));
      return pair.f != 0;
    };
    for (std::size_t j = 0; j < state.size(); ++j) {
      if (i == j || !meet(state.position[j])) continue;
      pair.v_ij = state.velocity[i] - state.velocity[j];
      pair.rho_j = state.density[j];
      pair.pressure_j = pressure[j];
      ((result[i] += acceleration(pair, terms.from_fluid(pair))), ...);
    }
    for (const auto& x_j : state.wall) {
      if (!meet(x_j)) continue;
      pair.v_ij = state.velocity[i];
      pair.rho_j = rho0;
      const auto add = [&](const auto& term) {
        constexpr bool pressure_term = std::is_same_v<std::remove_cvref_t<decltype(term)>, Pressure>;
        if constexpr (requires { term.from_wall(pair); }) {
          if (pressure_term || !slip) result[i] += acceleration(pair, term.from_wall(pair));
        }
      };
      (add(terms), ...);
    }
  }
  return result;
}

template <int Dim, class Kernel>
std::vector<Vec<Dim, double>> accelerations_over_all_pairs(const State<Dim>& state, const Scene& scene,
                                                           const std::vector<double>& pressure, const Kernel& kernel) {
  const bool slip = scene.solver.wall_slip == WallSlip::free_slip;
  const double h = smoothing_length(scene);
  const double nu = scene.fluid.viscosity.kinematic;
  const Pressure push;
  const auto with = [&](const auto&... viscosity) {
    if (scene.fluid.surface_tension.model == SurfaceTensionModel::none) {
      return accelerations_over_all_pairs<Dim>(state, scene, pressure, kernel, slip, push, viscosity...);
    }
    const auto tension = SeedASurfaceTension::of(scene.fluid.surface_tension.coefficient, particle_mass(scene));
    return accelerations_over_all_pairs<Dim>(state, scene, pressure, kernel, slip, push, viscosity..., tension);
  };
  switch (scene.fluid.viscosity.model) {
    case ViscosityModel::none:
      return with();
    case ViscosityModel::morris:
      return with(MorrisViscosity::of<Dim>(nu, h));
    case ViscosityModel::monaghan:
      return with(MonaghanViscosity::of<Dim>(nu, h));
    case ViscosityModel::seed_a:
      return with(SeedAViscosity::of<Dim>(nu, h));
  }
  return {};
}

template <int Dim>
void expect_equal_to_all_pairs(const Scene& scene, const Sampling& sampling, Team& team, InstructionSet set) {
  Wcsph<Dim> solver(scene, sampling, team, set);
  accelerate(solver);
  const State<Dim> state(solver);
  std::vector<double> pressure(state.size());
  for (std::size_t slot = 0; slot < solver.fluid().slots(); ++slot) {
    if (!solver.fluid().empty(slot))
      pressure[static_cast<std::size_t>(solver.fluid().id[slot])] = solver.fluid().pressure[slot];
  }
  const double h = smoothing_length(scene);
  const double minus_m = -particle_mass(scene);
  const auto exact =
      scene.solver.kernel.name == KernelName::wendland_c2
          ? accelerations_over_all_pairs<Dim>(state, scene, pressure, kernel_at<WendlandC2, Dim, double>(h, minus_m))
          : accelerations_over_all_pairs<Dim>(state, scene, pressure, kernel_at<CubicSpline, Dim, double>(h, minus_m));
  double largest = 0;
  double worst = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    largest = std::max(largest, std::sqrt(dot(exact[i], exact[i])));
    for (int d = 0; d < Dim; ++d) worst = std::max(worst, std::abs(state.acceleration[i][d] - exact[i][d]));
  }
  // Distances are good to 1e-6 dx, which changes grad W by some 1e-5 of its largest value; sums of 100 terms of either
  // sign add less.
  EXPECT_LE(worst, 2e-5 * largest) << name_of(set) << ", kernel " << static_cast<int>(scene.solver.kernel.name)
                                   << ", viscosity " << static_cast<int>(scene.fluid.viscosity.model);
}

TYPED_TEST(WcsphIn, EveryChoiceOfTermsEqualsTheSamePassesInDoubleOverAllPairs) {
  constexpr int dim = TypeParam::value;
  Team team(2);
  for (const InstructionSet set : usable_instruction_sets()) {
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
      for (const ViscosityModel viscosity :
           {ViscosityModel::none, ViscosityModel::morris, ViscosityModel::monaghan, ViscosityModel::seed_a}) {
        for (const WallSlip slip : {WallSlip::no_slip, WallSlip::free_slip}) {
          Scene scene = small_dam_break(dim, dim == 2 ? 0.025 : 0.05);
          scene.solver.kernel = {kernel, 1.3};
          scene.fluid.viscosity = {viscosity, 0.01};
          scene.solver.wall_slip = slip;
          if (slip == WallSlip::free_slip) {
            scene.fluid.surface_tension = {SurfaceTensionModel::seed_a, dim == 2 ? 1e-4 : 1e-6};
          }
          expect_equal_to_all_pairs<dim>(scene, shaken(scene, 4), team, set);
        }
      }
    }
  }
}

TYPED_TEST(WcsphIn, ConservesMomentumToRoundOff) {
  constexpr int dim = TypeParam::value;
  Team team(2);
  for (const ViscosityModel model : {ViscosityModel::none, ViscosityModel::morris, ViscosityModel::monaghan}) {
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
      Scene scene = free_fluid(dim, dim == 2 ? 30 : 10);
      scene.fluid.viscosity = {model, 0.1};
      scene.fluid.surface_tension = {SurfaceTensionModel::seed_a, 1e-3};
      scene.solver.kernel = {kernel, 1.2};
      scene.solver.negative_pressure = NegativePressure::keep;
      Wcsph<dim> solver(scene, shaken(scene, 5), team);
      accelerate(solver);
      const State<dim> state(solver);
      const auto n = static_cast<double>(state.size());
      double typical = 0;
      Vec<dim, double> mean{};
      for (const auto& a : state.acceleration) {
        typical += std::sqrt(dot(a, a)) / n;
        mean += (1 / n) * a;
      }
      EXPECT_GT(typical, 0.1);
      // The forces of each pair cancel to the last bit; what remains is the rounding of sums of up to 100 terms.
      for (int d = 0; d < dim; ++d) EXPECT_NEAR(mean[d], 0, 100 * 6e-8 * typical);
    }
  }
}

}  // namespace
}  // namespace weir
