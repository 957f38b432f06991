// What a scene lacks is left out: it gives the same bits as the same scene with a term, a wall or a seam that does nothing.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "scene/names.h"
#include "sph/brute_force.h"
#include "sph/simulation.h"
#include "support/scenes.h"

namespace weir {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string hash_after(const Scene& scene, InstructionSet set) {
  const auto simulation = make_simulation(scene, 2, set);
  while (!simulation->finished()) simulation->step();
  return simulation->state_hash();
}

Scene short_dam_break(int dimension) {
  Scene scene = small_dam_break(dimension, dimension == 2 ? 0.02 : 0.05);
  scene.duration = 0.1;
  return scene;
}

// Calls visit(scene, set) for a dam break in every dimension, by every method, with either kind of wall, for every
// instruction set.
template <class Visit>
void for_each_dam_break(const Visit& visit) {
  for (const int dimension : {2, 3}) {
    for (const Method method : {Method::wcsph, Method::delta_sph}) {
      for (const WallPressure walls : {WallPressure::mirrored, WallPressure::extrapolated}) {
        Scene scene = short_dam_break(dimension);
        scene.solver.method = method;
        scene.solver.wall_pressure = walls;
        for (const InstructionSet set : usable_instruction_sets()) {
          SCOPED_TRACE(fmt::format("{}D, {}, {}, {}", dimension, name_of(method), name_of(walls), name_of(set)));
          visit(scene, set);
        }
      }
    }
  }
}

TEST(Skip, AnAbsentViscosityIsAViscosityOfNothing) {
  for_each_dam_break([](Scene scene, InstructionSet set) {
    scene.fluid.viscosity = {ViscosityModel::none, 0};
    const std::string bare = hash_after(scene, set);
    for (const ViscosityModel model :
         {ViscosityModel::morris, ViscosityModel::monaghan, ViscosityModel::artificial, ViscosityModel::hinsch2024}) {
      scene.fluid.viscosity = {model, 0};
      for (const WallSlip slip : {WallSlip::no_slip, WallSlip::free_slip}) {
        scene.solver.wall_slip = slip;
        EXPECT_EQ(hash_after(scene, set), bare) << name_of(model) << ", " << name_of(slip);
      }
    }
    scene.fluid.viscosity = {ViscosityModel::morris, 0.01};
    EXPECT_NE(hash_after(scene, set), bare) << "a viscosity acts";
  });
}

TEST(Skip, AnAbsentCohesionIsACohesionOfNothing) {
  for_each_dam_break([](Scene scene, InstructionSet set) {
    const std::string bare = hash_after(scene, set);
    scene.fluid.surface_tension = {SurfaceTensionModel::hinsch2024, 0};
    EXPECT_EQ(hash_after(scene, set), bare);
    scene.fluid.surface_tension.coefficient = scene.dimension == 2 ? 1e-4 : 1e-6;
    EXPECT_NE(hash_after(scene, set), bare) << "cohesion acts";
  });
}

void move_by(Scene& scene, std::size_t wall, double distance) {
  Tank& tank = std::get<Tank>(scene.walls.at(wall).shape);
  tank.min.x += distance;
  tank.max.x += distance;
}

TEST(Skip, WallsOutOfReachAreNotThere) {
  for_each_dam_break([](Scene scene, InstructionSet set) {
    const std::string near_walls = hash_after(scene, set);
    scene.walls.push_back(scene.walls.front());
    move_by(scene, 1, 100);
    EXPECT_EQ(hash_after(scene, set), near_walls);
  });
}

TEST(Skip, AnAbsentWallIsAWallOutOfReach) {
  for_each_dam_break([](Scene scene, InstructionSet set) {
    scene.fluid.volumes[0].perturbation = 0.2;
    const std::string in_tank = hash_after(scene, set);
    move_by(scene, 0, 100);
    const std::string out_of_reach = hash_after(scene, set);
    scene.walls.clear();
    EXPECT_EQ(hash_after(scene, set), out_of_reach);
    EXPECT_NE(in_tank, out_of_reach) << "a wall acts";
  });
}

template <class T>
class SkipIn : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(SkipIn, Dimensions);

// Tiles of a periodic axis are a whole fraction of it and begin elsewhere, so positions are rounded otherwise.
TYPED_TEST(SkipIn, AnAxisThatIsNotPeriodicIsOneWhoseSeamIsFarAway) {
  constexpr int dim = TypeParam::value;
  ThreadPool pool(2);
  Scene scene = small_dam_break(dim, dim == 2 ? 0.025 : 0.05);
  scene.fluid.viscosity = {ViscosityModel::morris, 0.01};
  const Sampling sampling = shaken(scene, 31);
  for (const InstructionSet set : usable_instruction_sets()) {
    const auto solver = make_solver<dim>(scene, sampling, pool, set);
    accelerate(*solver);
    const State<dim> state(*solver);
    const BruteForce<dim> exact{scene, state};
    const std::vector<double> rho = exact.densities();
    const double by_terms = acceleration_tolerance * largest_norm<dim>(state.acceleration);
    for (int axes = 1; axes <= dim; ++axes) {
      SCOPED_TRACE(fmt::format("{} axes, {}", axes, name_of(set)));
      Scene periodic = scene;
      periodic.domain = Bounds{Vec3(-1.03), Vec3(2.17)};
      for (int d = 0; d < axes; ++d) periodic.periodic.push_back(static_cast<Axis>(d));
      const auto other = make_solver<dim>(periodic, sampling, pool, set);
      ASSERT_TRUE(other->search().lattice().periodic().along(axes - 1));
      accelerate(*other);
      const State<dim> seen(*other);
      for (std::size_t i = 0; i < state.size(); ++i) {
        ASSERT_NEAR(seen.density[i], state.density[i], 2 * density_tolerance * rho[i]) << i;
        // Either may differ so much from double precision.
        const auto by_pressure = exact.acceleration_tolerance_by_pressure(i, rho);
        for (int d = 0; d < dim; ++d) {
          ASSERT_NEAR(seen.acceleration[i][d], state.acceleration[i][d], 2 * (by_terms + by_pressure[d])) << i;
        }
      }
    }
  }
}

// Largest difference, over the largest change, between what a step does to the density and the continuity equation in double
// over all pairs; at the second step, as diffusion needs differences of density.
template <int Dim>
double departure_from_continuity(const Scene& scene, const Sampling& sampling, ThreadPool& pool, InstructionSet set) {
  const auto solver = make_solver<Dim>(scene, sampling, pool, set);
  const auto dt = static_cast<double>(1e-3F);
  accelerate(*solver);
  EXPECT_FALSE(solver->move(dt));
  accelerate(*solver);
  State<Dim> state(*solver);
  EXPECT_FALSE(solver->move(dt));
  const State<Dim> after(*solver);
  state.velocity = after.velocity;  // the density follows with the velocities after the kick
  const BruteForce<Dim> exact{scene, state};
  double difference = 0;
  double change = 0;
  for (std::size_t i = 0; i < state.size(); ++i) {
    double rate = 0;  // of rho, kg/m^Dim/s
    exact.for_each_other(state.position[i], state.position, i, [&](std::size_t j, const Vec<Dim, double>& x_ij) {
      rate += exact.m * dot(state.velocity[i] - state.velocity[j], exact.grad_w(x_ij));
    });
    exact.for_each_other(state.position[i], state.wall, exact.none, [&](std::size_t, const Vec<Dim, double>& x_ij) {
      rate += exact.m * dot(state.velocity[i], exact.grad_w(x_ij));
    });
    difference = std::max(difference, std::abs(after.density[i] - state.density[i] - dt * rate));
    change = std::max(change, std::abs(dt * rate));
  }
  return difference / change;
}

TYPED_TEST(SkipIn, ADensityDiffusionOfZeroLeavesContinuityAlone) {
  constexpr int dim = TypeParam::value;
  ThreadPool pool(2);
  Scene scene = small_dam_break(dim, dim == 2 ? 0.025 : 0.05);
  scene.solver.method = Method::delta_sph;
  const Sampling sampling = shaken(scene, 32);
  for (const InstructionSet set : usable_instruction_sets()) {
    scene.solver.density_diffusion = 0;
    const double without = departure_from_continuity<dim>(scene, sampling, pool, set);
    // As of accelerations, which are sums of the same gradients; and two densities are rounded, which change by some 1e-2.
    EXPECT_LT(without, acceleration_tolerance + 2 * rounding / 1e-2) << name_of(set);
    scene.solver.density_diffusion = 0.1;
    EXPECT_GT(departure_from_continuity<dim>(scene, sampling, pool, set), 30 * without) << name_of(set);
  }
}

template <int Dim>
std::vector<std::string_view> wall_fields(const Scene& scene) {
  ThreadPool pool(1);
  const auto solver = make_solver<Dim>(scene, sample(scene), pool, default_instruction_set());
  std::vector<std::string_view> names;
  for (const Field& field : solver->walls().fields()) names.push_back(field.name);
  return names;
}

TYPED_TEST(SkipIn, WallsHaveOnlyTheFieldsThatTheirSceneReads) {
  constexpr int dim = TypeParam::value;
  Scene scene = short_dam_break(dim);
  for (const Method method : {Method::wcsph, Method::delta_sph}) {
    scene.solver.method = method;
    for (const WallSlip slip : {WallSlip::no_slip, WallSlip::free_slip}) {
      scene.solver.wall_slip = slip;
      scene.solver.wall_pressure = WallPressure::mirrored;
      scene.fluid.viscosity = {ViscosityModel::morris, 0.01};
      EXPECT_THAT(wall_fields<dim>(scene), IsEmpty()) << name_of(slip);
      scene.solver.wall_pressure = WallPressure::extrapolated;
      if (slip == WallSlip::no_slip) {
        EXPECT_THAT(wall_fields<dim>(scene), ElementsAre("density", "pressure_term", "depth", "slide", "velocity"));
      } else {
        EXPECT_THAT(wall_fields<dim>(scene), ElementsAre("density", "pressure_term"));
      }
      scene.fluid.viscosity = {ViscosityModel::none, 0};
      EXPECT_THAT(wall_fields<dim>(scene), ElementsAre("density", "pressure_term")) << name_of(slip);
    }
  }
}

TYPED_TEST(SkipIn, MirroredWallsListNoFluid) {
  constexpr int dim = TypeParam::value;
  Scene scene = short_dam_break(dim);
  ThreadPool pool(1);
  for (const WallPressure walls : {WallPressure::mirrored, WallPressure::extrapolated}) {
    scene.solver.wall_pressure = walls;
    const auto solver = make_solver<dim>(scene, sample(scene), pool, default_instruction_set());
    solver->refresh();
    EXPECT_NO_THROW(solver->search().lists(solver->fluid(), solver->walls()));
    const auto of_walls = [&] { return solver->search().lists(solver->walls(), solver->fluid()).listed.size(); };
    if (walls == WallPressure::mirrored) {
      EXPECT_THROW(of_walls(), std::logic_error);
    } else {
      EXPECT_GT(of_walls(), 0U);
    }
    EXPECT_THROW(solver->search().lists(solver->walls(), solver->walls()), std::logic_error);
  }
}

TYPED_TEST(SkipIn, WallsAreSortedOnce) {
  constexpr int dim = TypeParam::value;
  Scene scene = short_dam_break(dim);
  ThreadPool pool(1);
  for (const WallPressure walls : {WallPressure::mirrored, WallPressure::extrapolated}) {
    scene.solver.wall_pressure = walls;
    const Sampling sampling = sample(scene);
    const auto solver = make_solver<dim>(scene, sampling, pool, default_instruction_set());
    for (int k = 0; k < 3; ++k) {
      solver->reset(sampling);
      ASSERT_FALSE(solver->advance(1).runaway);
    }
    EXPECT_EQ(solver->search().sorts(solver->fluid()), 3);
    EXPECT_EQ(solver->search().sorts(solver->walls()), 1);
  }
}

}  // namespace
}  // namespace weir
