#include "sph/solver.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "equations/kernels.h"
#include "equations/momentum.h"
#include "sph/brute_force.h"
#include "support/scenes.h"

namespace weir {
namespace {

template <class T>
class WcsphIn : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(WcsphIn, Dimensions);

// Calls visit(scene) for each kernel, at both of the usual smoothing lengths.
template <class Visit>
void for_each_kernel(Scene scene, const Visit& visit) {
  for (const KernelName name : {KernelName::cubic_spline, KernelName::wendland_c2, KernelName::wendland_c4}) {
    for (const double smoothing : {1.0, 1.3}) {
      scene.solver.kernel = {name, smoothing};
      visit(scene);
    }
  }
}

std::string told(const Scene& scene, InstructionSet set) {
  return fmt::format("{}: kernel {} at {} dx, exponent {}, {}", name_of(set),
                     static_cast<int>(scene.solver.kernel.name), scene.solver.kernel.smoothing, scene.solver.exponent,
                     scene.solver.negative_pressure == NegativePressure::clamp ? "clamp" : "keep");
}

template <int Dim>
void expect_density_and_pressure_of_brute_force(const Scene& scene, const Sampling& sampling, ThreadPool& pool,
                                                InstructionSet set) {
  const auto owned_solver = make_solver<Dim>(scene, sampling, pool, set);
  SphSolver<Dim>& solver = *owned_solver;
  solver.refresh();
  const State<Dim> state(solver);
  const BruteForce<Dim> exact{scene, state};
  const std::vector<double> rho = exact.densities();
  for (std::size_t i = 0; i < rho.size(); ++i) {
    ASSERT_NEAR(state.density[i], rho[i], density_tolerance * rho[i]) << told(scene, set);
    ASSERT_NEAR(state.pressure[i], exact.pressure(rho[i]), exact.pressure_tolerance(rho[i])) << told(scene, set);
  }
  EXPECT_GT(*std::max_element(state.pressure.begin(), state.pressure.end()), 0) << told(scene, set);
  const double least = *std::min_element(state.pressure.begin(), state.pressure.end());
  if (scene.solver.negative_pressure == NegativePressure::clamp) {
    EXPECT_EQ(least, 0) << told(scene, set);
  } else {
    EXPECT_LT(least, 0) << told(scene, set);
  }
}

TYPED_TEST(WcsphIn, DensityAndPressureEqualADoublePrecisionBruteForce) {
  constexpr int dim = TypeParam::value;
  ThreadPool pool(2);
  for_each_kernel(small_dam_break(dim, dim == 2 ? 0.025 : 0.05), [&](Scene scene) {
    const Sampling sampling = shaken(scene, 2);
    for (const int exponent : {1, 7}) {
      scene.solver.exponent = exponent;
      for (const NegativePressure negative : {NegativePressure::clamp, NegativePressure::keep}) {
        scene.solver.negative_pressure = negative;
        for (const InstructionSet set : usable_instruction_sets()) {
          expect_density_and_pressure_of_brute_force<dim>(scene, sampling, pool, set);
        }
      }
    }
  });
}

Scene viscous_and_cohesive_dam_break(int dim) {
  Scene scene = small_dam_break(dim, dim == 2 ? 0.025 : 0.05);
  scene.fluid.viscosity = {ViscosityModel::morris, 0.01};
  scene.fluid.surface_tension = {SurfaceTensionModel::hinsch2024, dim == 2 ? 1e-4 : 1e-6};
  return scene;
}

TYPED_TEST(WcsphIn, AccelerationEqualsADoublePrecisionBruteForce) {
  constexpr int dim = TypeParam::value;
  ThreadPool pool(2);
  for_each_kernel(viscous_and_cohesive_dam_break(dim), [&](const Scene& scene) {
    const Sampling sampling = shaken(scene, 3);
    for (const InstructionSet set : usable_instruction_sets()) {
      const auto owned_solver = make_solver<dim>(scene, sampling, pool, set);
      SphSolver<dim>& solver = *owned_solver;
      accelerate(solver);
      const State<dim> state(solver);
      const BruteForce<dim> exact{scene, state};
      const std::vector<double> rho = exact.densities();
      const auto a = exact.accelerations(rho);
      const double by_terms = acceleration_tolerance * largest_norm<dim>(a);
      for (std::size_t i = 0; i < a.size(); ++i) {
        const auto by_pressure = exact.acceleration_tolerance_by_pressure(i, rho);
        for (int d = 0; d < dim; ++d) {
          ASSERT_NEAR(state.acceleration[i][d], a[i][d], by_terms + by_pressure[d]) << told(scene, set);
        }
      }
    }
  });
}

// Every choice of terms, kernel and instruction set against the same passes in double over all pairs: what the loops add
// is lists, masks, shifts between tiles and registers, and none of it may be seen in the result.
template <int Dim, class Kernel, class... Terms>
std::vector<Vec<Dim, double>> accelerations_over_all_pairs(const State<Dim>& state, const Scene& scene,
                                                           const std::vector<double>& pressure, const Kernel& kernel,
                                                           bool slip, const Terms&... terms) {
  const double rho0 = scene.fluid.rest_density;
  const double support_squared = support_radius(scene) * support_radius(scene);
  std::vector<Vec<Dim, double>> result(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) {
    result[i] = from_scene<Dim, double>(scene.gravity);
    Pair<Dim, double> pair{.x_ij = {},
                           .v_ij = {},
                           .r2 = 0,
                           .f = 0,
                           .rho_i = state.density[i],
                           .rho_j = 0,
                           .pressure_term_i = pressure[i],
                           .pressure_term_j = 0};
    const auto meet = [&](const Vec<Dim, double>& x_j) {
      pair.x_ij = state.position[i] - x_j;
      pair.r2 = dot(pair.x_ij, pair.x_ij);
      if (pair.r2 >= support_squared) return false;
      pair.f = kernel.derivative_over_r(std::sqrt(pair.r2));
      return pair.f != 0;
    };
    for (std::size_t j = 0; j < state.size(); ++j) {
      if (i == j || !meet(state.position[j])) continue;
      pair.v_ij = state.velocity[i] - state.velocity[j];
      pair.rho_j = state.density[j];
      pair.pressure_term_j = pressure[j];
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
    const auto tension = Hinsch2024SurfaceTension::of(scene.fluid.surface_tension.coefficient, particle_mass(scene));
    return accelerations_over_all_pairs<Dim>(state, scene, pressure, kernel, slip, push, viscosity..., tension);
  };
  switch (scene.fluid.viscosity.model) {
    case ViscosityModel::none:
      return with();
    case ViscosityModel::morris:
      return with(MorrisViscosity::of<Dim>(nu, h));
    case ViscosityModel::monaghan:
      return with(MonaghanViscosity::of<Dim>(nu, h));
    case ViscosityModel::artificial:
      return with(ArtificialViscosity::of<Dim>(nu, h));
    case ViscosityModel::hinsch2024:
      return with(Hinsch2024Viscosity::of<Dim>(nu, h));
  }
  return {};
}

template <int Dim>
void expect_equal_to_all_pairs(const Scene& scene, const Sampling& sampling, ThreadPool& pool, InstructionSet set) {
  const auto owned_solver = make_solver<Dim>(scene, sampling, pool, set);
  SphSolver<Dim>& solver = *owned_solver;
  accelerate(solver);
  const State<Dim> state(solver);
  const std::vector<double>& pressure = state.pressure_term;
  const double h = smoothing_length(scene);
  const double minus_m = -particle_mass(scene);
  const auto over_all_pairs = [&](const auto& kernel) {
    return accelerations_over_all_pairs<Dim>(state, scene, pressure, kernel);
  };
  const auto exact = [&] {
    switch (scene.solver.kernel.name) {
      case KernelName::wendland_c2:
        return over_all_pairs(kernel_at<WendlandC2, Dim, double>(h, minus_m));
      case KernelName::wendland_c4:
        return over_all_pairs(kernel_at<WendlandC4, Dim, double>(h, minus_m));
      case KernelName::cubic_spline:
        break;
    }
    return over_all_pairs(kernel_at<CubicSpline, Dim, double>(h, minus_m));
  }();
  double worst = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    for (int d = 0; d < Dim; ++d) worst = std::max(worst, std::abs(state.acceleration[i][d] - exact[i][d]));
  }
  EXPECT_LE(worst, acceleration_tolerance * largest_norm<Dim>(exact))
      << name_of(set) << ", kernel " << static_cast<int>(scene.solver.kernel.name) << ", viscosity "
      << static_cast<int>(scene.fluid.viscosity.model);
}

TYPED_TEST(WcsphIn, EveryChoiceOfTermsEqualsTheSamePassesInDoubleOverAllPairs) {
  constexpr int dim = TypeParam::value;
  ThreadPool pool(2);
  for (const InstructionSet set : usable_instruction_sets()) {
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2, KernelName::wendland_c4}) {
      for (const ViscosityModel viscosity : {ViscosityModel::none, ViscosityModel::morris, ViscosityModel::monaghan,
                                             ViscosityModel::artificial, ViscosityModel::hinsch2024}) {
        for (const WallSlip slip : {WallSlip::no_slip, WallSlip::free_slip}) {
          for (const SurfaceTensionModel tension : {SurfaceTensionModel::none, SurfaceTensionModel::hinsch2024}) {
            Scene scene = small_dam_break(dim, dim == 2 ? 0.025 : 0.05);
            scene.solver.kernel = {kernel, 1.3};
            scene.fluid.viscosity = {viscosity, 0.01};
            scene.solver.wall_slip = slip;
            scene.fluid.surface_tension = {tension, dim == 2 ? 1e-4 : 1e-6};
            expect_equal_to_all_pairs<dim>(scene, shaken(scene, 4), pool, set);
          }
        }
      }
    }
  }
}

TYPED_TEST(WcsphIn, ConservesMomentumToRoundOff) {
  constexpr int dim = TypeParam::value;
  ThreadPool pool(2);
  for (const ViscosityModel model : {ViscosityModel::none, ViscosityModel::morris, ViscosityModel::monaghan}) {
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2, KernelName::wendland_c4}) {
      Scene scene = free_fluid(dim, dim == 2 ? 30 : 10);
      scene.fluid.viscosity = {model, 0.1};
      scene.fluid.surface_tension = {SurfaceTensionModel::hinsch2024, 1e-3};
      scene.solver.kernel = {kernel, 1.2};
      scene.solver.negative_pressure = NegativePressure::keep;
      const auto owned_solver = make_solver<dim>(scene, shaken(scene, 5), pool, default_instruction_set());
      SphSolver<dim>& solver = *owned_solver;
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

// The largest is found whichever particle it is: in whichever lane, register and tile.
TYPED_TEST(WcsphIn, LargestSignalSpeedAndAccelerationAreThoseOfAllParticles) {
  constexpr int dim = TypeParam::value;
  Scene scene = small_dam_break(dim, dim == 2 ? 0.025 : 0.05);
  scene.fluid.viscosity = {ViscosityModel::morris, 0.01};
  const Sampling sampling = shaken(scene, 6);
  ThreadPool pool(2);
  for (const int exponent : {1, 7}) {
    scene.solver.exponent = exponent;
    // Rounded are the ratio of densities (the reciprocal and the product), which counts (exponent - 1)/2 times, as do the
    // products of its power; c0, the root, their product, |v| and the sum.
    const double per_density = 0.5 * (exponent - 1);
    const double by_formula = (per_density * 3 + 8) * rounding;
    for (const InstructionSet set : usable_instruction_sets()) {
      const auto owned_solver = make_solver<dim>(scene, sampling, pool, set);
      SphSolver<dim>& solver = *owned_solver;
      accelerate(solver);
      const State<dim> state(solver);
      const BruteForce<dim> exact{scene, state};
      double fastest = 0;
      for (std::size_t i = 0; i < state.size(); ++i) {
        fastest = std::max(fastest, exact.signal_speed(i, exact.density(i)));
      }
      EXPECT_NEAR(solver.max_signal_speed(), fastest, (by_formula + per_density * density_tolerance) * fastest);

      auto& velocity = solver.velocity().values[0];
      for (std::size_t slot = 0; slot < solver.fluid().slots(); ++slot) {
        if (solver.fluid().empty(slot)) continue;
        const float before = std::exchange(velocity[slot], 1e4F);  // no other has such a speed, nor such a drag
        solver.accelerate();
        const State<dim> now(solver);
        const auto i = static_cast<std::size_t>(solver.fluid().id[slot]);
        const double signal = BruteForce<dim>{scene, now}.signal_speed(i, now.density[i]);
        ASSERT_NEAR(solver.max_signal_speed(), signal, by_formula * signal) << name_of(set) << ", slot " << slot;
        const double largest = largest_norm<dim>(now.acceleration);
        ASSERT_EQ(norm<dim>(now.acceleration[i]), largest);
        ASSERT_NEAR(solver.max_acceleration(), largest, (dim + 1) * rounding * largest) << name_of(set);
        velocity[slot] = before;
      }
    }
  }
}

// Euler-Cromer with the places' rounding errors kept: a hundred steps, each of some millionth of a place, lose nothing.
TYPED_TEST(WcsphIn, IntegrationEqualsEulerCromerInDouble) {
  constexpr int dim = TypeParam::value;
  const Scene scene = small_dam_break(dim, dim == 2 ? 0.025 : 0.05);
  const Sampling sampling = shaken(scene, 7);
  ThreadPool pool(2);
  const double dt = 1e-6F;
  constexpr int steps = 100;
  const double widest = 1;  // m, more than any place in its tile
  for (const InstructionSet set : usable_instruction_sets()) {
    const auto owned_solver = make_solver<dim>(scene, sampling, pool, set);
    SphSolver<dim>& solver = *owned_solver;
    accelerate(solver);
    State<dim> last(solver);
    auto place = last.position;
    auto tolerance = last.position;
    for (auto& each : tolerance) each = {};
    for (int step = 0; step < steps; ++step) {
      ASSERT_FALSE(solver.move(dt));
      const State<dim> now(solver);
      for (std::size_t i = 0; i < now.size(); ++i) {
        for (int d = 0; d < dim; ++d) {
          const double v = last.velocity[i][d];
          const double dv = dt * last.acceleration[i][d];
          // A product and a sum.
          ASSERT_NEAR(now.velocity[i][d], v + dv, rounding * (2 * std::abs(dv) + std::abs(v + dv))) << name_of(set);
          const double dx = dt * now.velocity[i][d];
          place[i][d] += dx;
          // The product, what is owed added to it (at most a rounding of the place), and the two differences that say
          // what is owed next.
          tolerance[i][d] += 4 * rounding * (std::abs(dx) + rounding * widest);
          ASSERT_NEAR(now.position[i][d], place[i][d], tolerance[i][d]) << name_of(set) << ", step " << step;
        }
      }
      const double fastest = largest_norm<dim>(now.velocity);
      ASSERT_NEAR(solver.max_speed(), fastest, (dim + 1) * rounding * fastest) << name_of(set);
      last.velocity = now.velocity;
    }
  }
}

// Each set is good to a tolerance, so any two differ by at most twice that. A pair that one of them leaves out is some
// hundredth of the sum.
TYPED_TEST(WcsphIn, InstructionSetsAgreeParticleByParticle) {
  constexpr int dim = TypeParam::value;
  ThreadPool pool(2);
  for_each_kernel(viscous_and_cohesive_dam_break(dim), [&](const Scene& scene) {
    const Sampling sampling = shaken(scene, 8);
    const auto owned_first = make_solver<dim>(scene, sampling, pool, usable_instruction_sets().front());
    SphSolver<dim>& first = *owned_first;
    accelerate(first);
    const State<dim> one(first);
    const double largest = largest_norm<dim>(one.acceleration);
    for (const InstructionSet set : usable_instruction_sets()) {
      const auto owned_solver = make_solver<dim>(scene, sampling, pool, set);
      SphSolver<dim>& solver = *owned_solver;
      accelerate(solver);
      const State<dim> own(solver);
      for (std::size_t i = 0; i < own.size(); ++i) {
        ASSERT_NEAR(own.density[i], one.density[i], 2 * density_tolerance * one.density[i]) << told(scene, set);
      }
      // Accelerations of the same densities and pressures: how a pressure raises the error of a density is another matter.
      auto& fluid = solver.fluid();
      for (std::size_t slot = 0; slot < fluid.slots(); ++slot) {
        if (fluid.empty(slot)) continue;
        const auto i = static_cast<std::size_t>(fluid.id[slot]);
        solver.density().data()[slot] = static_cast<float>(one.density[i]);
        solver.pressure_term().data()[slot] = static_cast<float>(one.pressure_term[i]);
      }
      solver.accelerate();
      const State<dim> same(solver);
      for (std::size_t i = 0; i < same.size(); ++i) {
        for (int d = 0; d < dim; ++d) {
          ASSERT_NEAR(same.acceleration[i][d], one.acceleration[i][d], 2 * acceleration_tolerance * largest)
              << told(scene, set);
        }
      }
    }
  });
}

// A particle that has no number for a place or a velocity is found in the step in which that happens, in whichever lane.
template <int Dim, class Spoil>
void expect_found_in_any_slot(const Spoil& spoil) {
  const Scene scene = small_dam_break(Dim, Dim == 2 ? 0.025 : 0.05);
  const Sampling sampling = shaken(scene, 9);
  ThreadPool pool(2);
  for (const InstructionSet set : usable_instruction_sets()) {
    const auto owned_solver = make_solver<Dim>(scene, sampling, pool, set);
    SphSolver<Dim>& solver = *owned_solver;
    for (std::size_t slot = 0; slot < solver.fluid().slots(); slot += 7) {  // 7: every lane of 16 in turn
      solver.reset(sampling);
      solver.refresh();
      if (solver.fluid().empty(slot)) continue;
      spoil(solver, slot);
      solver.recompute();
      solver.accelerate();
      const std::optional<Runaway> escape = solver.move(1e-6);
      ASSERT_TRUE(escape) << name_of(set) << ", slot " << slot;
      EXPECT_FALSE(std::isfinite(escape->distance)) << name_of(set);
      EXPECT_LE(escape->id, solver.fluid().id[slot]) << name_of(set);
      const auto v = convert<double>(solver.fluid().vector_at(solver.velocity(), slot));
      EXPECT_FALSE(std::isfinite(dot(v, v))) << name_of(set) << ", slot " << slot;
    }
  }
}

TYPED_TEST(WcsphIn, FindsAVelocityThatIsNoNumber) {
  constexpr int dim = TypeParam::value;
  expect_found_in_any_slot<dim>([](auto& solver, std::size_t slot) {
    solver.velocity().data(dim - 1)[slot] = std::numeric_limits<float>::quiet_NaN();
  });
}

TYPED_TEST(WcsphIn, FindsAPlaceThatIsNoNumber) {
  constexpr int dim = TypeParam::value;
  expect_found_in_any_slot<dim>([](auto& solver, std::size_t slot) {
    solver.fluid().x[dim - 1][slot] = std::numeric_limits<float>::quiet_NaN();
  });
}

}  // namespace
}  // namespace weir
