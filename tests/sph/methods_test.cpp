// Every method with every kind of wall: against the papers' equations in double over all pairs, and running.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.h"
#include "scene/names.h"
#include "sph/brute_force.h"
#include "sph/simulation.h"
#include "support/scenes.h"

namespace weir {
namespace {

template <class T>
class MethodsIn : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(MethodsIn, Dimensions);

Scene walled(int dim, Method method, WallPressure walls, WallSlip slip, KernelName kernel) {
  Scene scene = small_dam_break(dim, dim == 2 ? 0.025 : 0.05);
  scene.solver.method = method;
  scene.solver.wall_pressure = walls;
  scene.solver.wall_slip = slip;
  scene.solver.kernel = {kernel, 1.5};
  scene.fluid.viscosity = {ViscosityModel::morris, 0.02};
  scene.walls[0].layers = 0;
  if (walls == WallPressure::extrapolated && slip == WallSlip::no_slip) scene.walls[0].slide = Vec3(0.3, 0, 0);
  return scene;
}

std::string name_of_case(const Scene& scene, InstructionSet set) {
  return fmt::format("{} {} {} {} {}", name_of(scene.solver.method), name_of(scene.solver.wall_pressure),
                     name_of(scene.solver.wall_slip), name_of(scene.solver.kernel.name), name_of(set));
}

// Calls visit(scene, sampling, set) for both methods and slips, both kernels and every instruction set.
template <int Dim, class Visit>
void for_each_case(WallPressure walls, const Visit& visit) {
  for (const Method method : {Method::wcsph, Method::delta_sph}) {
    for (const WallSlip slip : {WallSlip::no_slip, WallSlip::free_slip}) {
      for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2, KernelName::wendland_c4}) {
        const Scene scene = walled(Dim, method, walls, slip, kernel);
        const Sampling sampling = shaken(scene, 31);
        for (const InstructionSet set : usable_instruction_sets()) {
          SCOPED_TRACE(name_of_case(scene, set));
          visit(scene, sampling, set);
        }
      }
    }
  }
}

// State of the walls, in the order of State::wall; zero velocity where walls have none.
template <int Dim>
struct WallsOf {
  std::vector<double> pressure, density, depth;
  std::vector<Vec<Dim, double>> velocity, slide;

  explicit WallsOf(const SphSolver<Dim>& solver) {
    const WallFields<Dim>& fields = solver.wall_fields();
    for (std::size_t slot = 0; slot < solver.walls().slots(); ++slot) {
      if (solver.walls().empty(slot)) continue;
      const double rho = fields.density->at(slot);
      density.push_back(rho);
      pressure.push_back(fields.pressure_term->at(slot) * rho * rho);
      velocity.push_back({});
      slide.push_back({});
      depth.push_back(fields.depth == nullptr ? 0 : static_cast<double>(fields.depth->at(slot)));
      if (fields.velocity == nullptr) continue;
      velocity.back() = convert<double>(solver.walls().vector_at(*fields.velocity, slot));
      slide.back() = convert<double>(solver.walls().vector_at(*fields.slide, slot));
    }
  }
};

// A start with densities that differ from rest, where the method carries them.
template <int Dim>
void stir_density(SphSolver<Dim>& solver) {
  std::mt19937 random(32);
  std::uniform_real_distribution<float> u(0, 0.02F);
  for (const Field& field : solver.fluid().fields()) {
    if (field.name != "compression") continue;
    for (std::size_t slot = 0; slot < solver.fluid().slots(); ++slot) {
      if (!solver.fluid().empty(slot)) const_cast<Field&>(field).data()[slot] = u(random);
    }
  }
}

template <int Dim>
std::vector<double> compressions(const SphSolver<Dim>& solver) {
  std::vector<double> of(solver.fluid().count);
  for (const Field& field : solver.fluid().fields()) {
    if (field.name != "compression") continue;
    for (std::size_t slot = 0; slot < solver.fluid().slots(); ++slot) {
      if (!solver.fluid().empty(slot)) of[static_cast<std::size_t>(solver.fluid().id[slot])] = field.at(slot);
    }
  }
  return of;
}

// Adami, Hu & Adams 2012, eqs. 22, 23 and 27, over all pairs in double, of the fluid as the solver has it.
TYPED_TEST(MethodsIn, WallsHaveTheExtrapolatedStateOfAllFluidAround) {
  constexpr int dim = TypeParam::value;
  using V = Vec<dim, double>;
  ThreadPool pool(2);
  for_each_case<dim>(WallPressure::extrapolated, [&](const Scene& scene, const Sampling& sampling, InstructionSet set) {
    const auto solver = make_solver<dim>(scene, sampling, pool, set);
    stir_density(*solver);
    solver->refresh();
    const State<dim> state(*solver);
    const BruteForce<dim> exact{scene, state};
    const WallsOf<dim> walls(*solver);
    const auto g = from_scene<dim, double>(scene.gravity);
    double highest = 0;
    for (const double p : state.pressure) highest = std::max(highest, p);
    int compared = 0;
    for (std::size_t w = 0; w < state.wall.size(); ++w) {
      double weights = 0, pressure = 0;
      V velocity{}, displacement{};
      exact.for_each_other(state.wall[w], state.position, BruteForce<dim>::none, [&](std::size_t j, const V& x_wj) {
        const double weight = exact.w(norm(x_wj));
        weights += weight;
        pressure += weight * (state.pressure[j] + state.density[j] * dot(g, x_wj));
        velocity += weight * state.velocity[j];
        displacement += weight * x_wj;
      });
      // At the edge of the support the quotient of two small sums has few digits in single precision.
      if (weights < 1e-2 * exact.w(0)) continue;
      ++compared;
      // Sums of weights to 2e-6; the weights themselves change by distances good to 1e-6 dx, 1e-4 of them here at most.
      ASSERT_NEAR(walls.pressure[w], std::max(0.0, pressure / weights), 1e-3 * highest);
      const double rho = scene.fluid.rest_density;
      ASSERT_NEAR(walls.density[w], rho * (1 + walls.pressure[w] / (7 * stiffness(scene))), 1e-6 * rho);
      if (scene.solver.wall_slip == WallSlip::free_slip) continue;
      // On the line from the wall's velocity at its face to the fluid's mean at its mean distance.
      const double distance = std::max(norm(displacement) / weights - walls.depth[w], 0.25 * scene.particle_spacing);
      const double ratio = walls.depth[w] / distance;
      const V expected = walls.slide[w] + ratio * (walls.slide[w] - (1 / weights) * velocity);
      for (int d = 0; d < dim; ++d) ASSERT_NEAR(walls.velocity[w][d], expected[d], 1e-3 * (1 + ratio * ratio));
    }
    EXPECT_GT(compared, 50);
  });
}

TYPED_TEST(MethodsIn, AccelerationsEqualABruteForceWithTheWallsState) {
  constexpr int dim = TypeParam::value;
  using V = Vec<dim, double>;
  ThreadPool pool(2);
  for_each_case<dim>(WallPressure::extrapolated, [&](const Scene& scene, const Sampling& sampling, InstructionSet set) {
    const auto solver = make_solver<dim>(scene, sampling, pool, set);
    stir_density(*solver);
    accelerate(*solver);
    const State<dim> state(*solver);
    const BruteForce<dim> exact{scene, state};
    const WallsOf<dim> walls(*solver);
    const bool friction = scene.solver.wall_slip == WallSlip::no_slip;
    const double nu = scene.fluid.viscosity.kinematic;
    std::vector<V> a(state.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      a[i] = from_scene<dim, double>(scene.gravity);
      const auto add = [&](const V& x_ij, double term_j, double rho_j, const V& v_j, bool viscous) {
        const V gradient = exact.grad_w(x_ij);
        a[i] += (-exact.m * (state.pressure_term[i] + term_j)) * gradient;
        if (!viscous) return;
        const double volume = 2 * exact.m / (state.density[i] + rho_j);
        const double r2 = dot(x_ij, x_ij) + 0.01 * exact.h * exact.h;
        a[i] += (2 * nu * volume * dot(x_ij, gradient) / r2) * (state.velocity[i] - v_j);
      };
      exact.for_each_other(state.position[i], state.position, i, [&](std::size_t j, const V& x_ij) {
        add(x_ij, state.pressure_term[j], state.density[j], state.velocity[j], true);
      });
      exact.for_each_other(state.position[i], state.wall, BruteForce<dim>::none, [&](std::size_t w, const V& x_ij) {
        const double rho = walls.density[w];
        add(x_ij, walls.pressure[w] / (rho * rho), rho, walls.velocity[w], friction);
      });
    }
    const double tolerance = acceleration_tolerance * largest_norm<dim>(a);
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (int d = 0; d < dim; ++d) ASSERT_NEAR(state.acceleration[i][d], a[i][d], tolerance);
    }
  });
}

// A step of delta-SPH: d rho_i / dt = sum m_j v_ij . grad W_ij, and from the fluid 2 delta h c0 sum V_j (rho_ji - rho^H_ji)
// x_ji . grad W_ij / r^2 (Fourtakas et al. 2019), with the new velocities at the positions before.
TYPED_TEST(MethodsIn, DensityFollowsContinuityAndDiffusion) {
  constexpr int dim = TypeParam::value;
  using V = Vec<dim, double>;
  ThreadPool pool(2);
  for_each_case<dim>(WallPressure::mirrored, [&](const Scene& scene, const Sampling& sampling, InstructionSet set) {
    if (scene.solver.method != Method::delta_sph) return;
    const auto solver = make_solver<dim>(scene, sampling, pool, set);
    stir_density(*solver);
    accelerate(*solver);
    const std::vector<double> before = compressions(*solver);
    const State<dim> old(*solver);
    const BruteForce<dim> exact{scene, old};
    const double dt = 1e-4F;
    ASSERT_FALSE(solver->move(dt));
    const std::vector<double> after = compressions(*solver);
    const State<dim> now(*solver);
    const double c0 = sound_speed(scene);
    const double diffusivity = 2 * scene.solver.density_diffusion * exact.h * c0;
    const auto g = from_scene<dim, double>(scene.gravity);
    double largest = 0;
    std::vector<double> change(before.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      double rate = 0;
      const auto add = [&](const V& x_ij, const V& v_ij) {
        rate += exact.m * dot(v_ij, exact.grad_w(x_ij)) / exact.rho0;
      };
      exact.for_each_other(old.position[i], old.position, i, [&](std::size_t j, const V& x_ij) {
        add(x_ij, now.velocity[i] - now.velocity[j]);
        const double difference = before[j] - before[i] + dot(g, x_ij) / (c0 * c0);
        const double slope = -dot(x_ij, exact.grad_w(x_ij)) / dot(x_ij, x_ij);
        rate += diffusivity * exact.m / exact.rho0 * difference * slope;
      });
      exact.for_each_other(old.position[i], old.wall, BruteForce<dim>::none,
                           [&](std::size_t, const V& x_ij) { add(x_ij, now.velocity[i]); });
      change[i] = dt * rate;
      largest = std::max(largest, std::abs(change[i]));
    }
    for (std::size_t i = 0; i < before.size(); ++i) {
      // Of the largest change as accelerations are of the largest, and a rounding of the sum.
      ASSERT_NEAR(after[i] - before[i], change[i], acceleration_tolerance * largest + rounding * 0.1) << i;
    }
  });
}

double energy_at_start(const Scene& scene) {
  const Diagnostics start = make_simulation(scene, 1)->diagnostics();
  return start.kinetic_energy + start.potential_energy;
}

// Both methods, both kinds of walls and slips, both kernels and dimensions: each runs, lets no particle into a wall, keeps
// its bits for any number of threads.
TYPED_TEST(MethodsIn, EveryPairRuns) {
  constexpr int dim = TypeParam::value;
  for (const WallPressure walls : {WallPressure::mirrored, WallPressure::extrapolated}) {
    for (const Method method : {Method::wcsph, Method::delta_sph}) {
      for (const WallSlip slip : {WallSlip::no_slip, WallSlip::free_slip}) {
        for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2, KernelName::wendland_c4}) {
          Scene scene = walled(dim, method, walls, slip, kernel);
          scene.walls[0].slide = Vec3(0);
          scene.duration = 0.15;
          SCOPED_TRACE(name_of_case(scene, default_instruction_set()));
          std::string hash;
          for (const int threads : {1, 3}) {
            const auto simulation = make_simulation(scene, threads);
            ASSERT_NO_THROW(while (!simulation->finished()) simulation->step());
            if (hash.empty()) hash = simulation->state_hash();
            EXPECT_EQ(simulation->state_hash(), hash);
            Snapshot snapshot;
            simulation->fill(snapshot, {});
            const Tank& tank = std::get<Tank>(scene.walls[0].shape);
            // The first layer of a wall stands half a spacing behind its face: none may pass that.
            const double layer = 0.5 * scene.particle_spacing;
            for (const glm::vec3& x : snapshot.fluid.positions) {
              for (int d = 0; d < dim; ++d) ASSERT_GT(x[d], tank.min[d] - layer);
              for (int d = 0; d < dim - 1; ++d) ASSERT_LT(x[d], tank.max[d] + layer);
            }
            const Diagnostics end = simulation->diagnostics();
            if (walls == WallPressure::extrapolated && method == Method::delta_sph) {
              EXPECT_LE(end.kinetic_energy + end.potential_energy, energy_at_start(scene));
            }
          }
        }
      }
    }
  }
}

// curl v = sum V_j v_ij x grad W_ij over all pairs in double; looking at it changes nothing.
TYPED_TEST(MethodsIn, VorticityEqualsABruteForceAndIsNotPartOfTheState) {
  constexpr int dim = TypeParam::value;
  ThreadPool pool(2);
  for_each_case<dim>(WallPressure::extrapolated, [&](const Scene& scene, const Sampling& sampling, InstructionSet set) {
    const auto solver = make_solver<dim>(scene, sampling, pool, set);
    const auto unseen = make_solver<dim>(scene, sampling, pool, set);
    for (const auto& each : {solver.get(), unseen.get()}) {
      accelerate(*each);
      ASSERT_FALSE(each->move(1e-4));
    }
    const Field& field = solver->vorticity();
    const State<dim> state(*solver);
    const BruteForce<dim> exact{scene, state};
    std::vector<Vec<3, double>> curl(state.size());
    double largest = 0;
    for (std::size_t i = 0; i < curl.size(); ++i) {
      exact.for_each_other(state.position[i], state.position, i, [&](std::size_t j, const Vec<dim, double>& x_ij) {
        Vec<3, double> v{}, w{};
        for (int d = 0; d < dim; ++d) {
          v[d] = state.velocity[i][d] - state.velocity[j][d];
          w[d] = exact.m / state.density[j] * exact.grad_w(x_ij)[d];
        }
        curl[i] += Vec<3, double>{v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
      });
      largest = std::max(largest, std::sqrt(dot(curl[i], curl[i])));
    }
    ASSERT_GT(largest, 1);
    for (std::size_t slot = 0; slot < solver->fluid().slots(); ++slot) {
      if (solver->fluid().empty(slot)) continue;
      const auto i = static_cast<std::size_t>(solver->fluid().id[slot]);
      for (int c = 0; c < field.components; ++c) {
        ASSERT_NEAR(field.at(slot, c), curl[i][dim == 2 ? 2 : c], acceleration_tolerance * largest);
      }
    }
    accelerate(*solver);
    accelerate(*unseen);
    const State<dim> seen(*solver), other(*unseen);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      for (int d = 0; d < dim; ++d) ASSERT_EQ(seen.acceleration[i][d], other.acceleration[i][d]);
    }
  });
}

// The diffusion and the continuity equation exchange density and take none: without walls the sum of compressions follows
// the divergence alone, and of a fluid at rest it stays, to rounding.
TYPED_TEST(MethodsIn, DiffusionConservesMass) {
  constexpr int dim = TypeParam::value;
  Scene scene = free_fluid(dim, dim == 2 ? 20 : 8);
  scene.solver.method = Method::delta_sph;
  scene.solver.kernel = {KernelName::wendland_c2, 1.5};
  ThreadPool pool(2);
  const auto solver = make_solver<dim>(scene, sample(scene), pool, default_instruction_set());
  stir_density(*solver);
  accelerate(*solver);
  const auto sum = [&] {
    double total = 0;
    for (const double c : compressions(*solver)) total += c;
    return total;
  };
  const double before = sum();
  for (std::size_t slot = 0; slot < solver->fluid().slots(); ++slot) {
    for (int d = 0; d < dim; ++d) solver->acceleration().data(d)[slot] = 0;
  }
  solver->move(1e-3);
  const auto n = static_cast<double>(solver->fluid().count);
  // Pairs cancel to the last bit; each compression of 0.02 at most takes its sum with a rounding.
  EXPECT_NEAR(sum(), before, n * 0.02 * rounding * 2);
}

}  // namespace
}  // namespace weir
