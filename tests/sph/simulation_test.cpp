#include "sph/simulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.h"
#include "support/scenes.h"

namespace weir {
namespace {

std::string hash_after(const Scene& scene, int threads) {
  const auto simulation = make_simulation(scene, threads);
  while (!simulation->finished()) simulation->step();
  return simulation->state_hash();
}

Scene short_dam_break(int dimension) {
  Scene scene = small_dam_break(dimension, dimension == 2 ? 0.02 : 0.05);
  scene.duration = 0.1;
  scene.fluid.surface_tension = {SurfaceTensionModel::hinsch2024, dimension == 2 ? 1e-4 : 1e-6};
  return scene;
}

TEST(Simulation, HasTheSameBitsForAnyNumberOfThreads) {
  for (const int dimension : {2, 3}) {
    const Scene scene = short_dam_break(dimension);
    const std::string one = hash_after(scene, 1);
    for (const int threads : {2, 3, 8}) EXPECT_EQ(hash_after(scene, threads), one) << dimension << "D " << threads;
  }
}

// Over some dozens of tiles, which threads take in any order.
TEST(Simulation, EveryMethodHasTheSameBitsForAnyNumberOfThreads) {
  for (const int dimension : {2, 3}) {
    for (const Method method : {Method::wcsph, Method::delta_sph}) {
      Scene scene = small_dam_break(dimension, dimension == 2 ? 0.008 : 0.02);
      scene.duration = dimension == 2 ? 0.03 : 0.02;
      scene.solver.method = method;
      scene.solver.wall_pressure = WallPressure::extrapolated;
      const std::string one = hash_after(scene, 1);
      for (const int threads : {2, 3, 8}) EXPECT_EQ(hash_after(scene, threads), one) << dimension << "D " << threads;
    }
  }
}

TEST(Simulation, LookingChangesNothing) {
  Scene scene = short_dam_break(2);
  const std::string unseen = hash_after(scene, 2);
  const auto simulation = make_simulation(scene, 2);
  Snapshot snapshot;
  for (int k = 0; !simulation->finished(); ++k) {
    if (k % 2 == 0) simulation->diagnostics();
    if (k % 3 == 0) simulation->fill(snapshot, {.fluid = {Quantity::pressure}});
    if (k % 5 == 0) simulation->state_hash();
    simulation->step();
  }
  EXPECT_EQ(simulation->state_hash(), unseen);
}

TEST(Simulation, InstructionSetsAgreeToRounding) {
  for (const int dimension : {2, 3}) {
    Scene scene = short_dam_break(dimension);
    scene.duration = 0.02;
    std::vector<Diagnostics> rows;
    for (const InstructionSet set : usable_instruction_sets()) {
      const auto simulation = make_simulation(scene, 2, set);
      EXPECT_EQ(simulation->instruction_set(), set);
      while (!simulation->finished()) simulation->step();
      rows.push_back(simulation->diagnostics());
    }
    // A step is as long as sound at rest takes to cross its share of h, or somewhat less: speeds add to that of sound,
    // and the frame time on the way may cost one more, as may the end.
    const double longest =
        AdaptiveStep{}.acoustic * smoothing_length(scene) / std::sqrt(7 * stiffness(scene) / scene.fluid.rest_density);
    EXPECT_GE(static_cast<double>(rows[0].step), scene.duration / longest);
    EXPECT_LE(static_cast<double>(rows[0].step), 1.5 * scene.duration / longest + 2);
    for (const Diagnostics& row : rows) {
      EXPECT_EQ(row.step, rows[0].step);
      // An acceleration is good to some 1e-5 of the largest, and those tens of steps do not yet amplify it.
      EXPECT_NEAR(row.kinetic_energy, rows[0].kinetic_energy, 1e-4 * rows[0].kinetic_energy);
      EXPECT_NEAR(row.center_of_mass[0], rows[0].center_of_mass[0], 1e-6);
    }
  }
}

TEST(Simulation, TheHashTellsStatesApart) {
  Scene scene = short_dam_break(2);
  const std::string before = hash_after(scene, 2);
  scene.fluid.volumes[0].velocity.x = 1e-6;
  EXPECT_NE(hash_after(scene, 2), before);
}

// 0.2 s of free fall: speed g t to the rounding of single-precision sums, place by Euler-Cromer's exact sum.
TEST(Simulation, ParticlesWithoutNeighboursFallExactly) {
  for (const int dimension : {2, 3}) {
    Scene scene = free_fluid(dimension, 1, 0.01);
    scene.gravity = dimension == 2 ? Vec3{0, -9.81, 0} : Vec3{0, 0, -9.81};
    scene.solver.time_step = FixedStep{1e-3};
    scene.render.fps = 50;
    scene.duration = 0.2;
    const auto simulation = make_simulation(scene, 1);
    while (!simulation->finished()) simulation->step();
    EXPECT_EQ(simulation->steps(), 200);
    const Diagnostics d = simulation->diagnostics();
    EXPECT_NEAR(d.max_speed, 9.81 * 0.2, 200 * 6e-8 * 9.81 * 0.2);
    const double fallen = 9.81 * 1e-6 * 200 * 201 / 2;
    EXPECT_NEAR(d.center_of_mass[dimension - 1], 0.005 - fallen, 200 * 6e-8 * fallen);
  }
}

TEST(Simulation, SnapshotsHoldEveryParticleOnce) {
  Scene scene = short_dam_break(2);
  const Sampling sampling = sample(scene);
  const auto simulation = make_simulation(scene, 2);
  for (int k = 0; k < 3; ++k) simulation->step();
  Snapshot snapshot;
  simulation->fill(snapshot, {});
  ASSERT_EQ(snapshot.fluid.positions.size(), sampling.fluid_positions.size());
  // A few steps from rest move nothing by as much as half a spacing.
  std::vector<int> seen(sampling.fluid_positions.size());
  for (const glm::vec3& shown : snapshot.fluid.positions) {
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const Vec3& x = sampling.fluid_positions[i];
      const double half = 0.5 * scene.particle_spacing;
      if (std::abs(shown.x - x.x) < half && std::abs(shown.y - x.y) < half) ++seen[i];
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(seen.size()));
}

TEST(Simulation, PauseHoldsTheStateWhileRunTimeGoesOn) {
  Scene scene = short_dam_break(2);
  scene.duration = 0.2;
  scene.timeline = {{.at = 0.1, .pause = true}};
  const auto simulation = make_simulation(scene, 2);
  std::int64_t frames = 0;
  for (; !simulation->finished(); simulation->step()) frames += simulation->frame_index() >= 0;
  EXPECT_EQ(simulation->time(), 0.2);
  EXPECT_NEAR(simulation->simulated_time(), 0.1, 1e-12);
  EXPECT_EQ(frames, 12) << "frames 0 to 11 of 60 a second; the last one is at the end";
  EXPECT_EQ(simulation->state_hash(), hash_after(short_dam_break(2), 2));
}

TEST(Simulation, ResetStartsTheSameMotionAgain) {
  Scene scene = short_dam_break(2);
  scene.duration = 0.15;
  scene.timeline = {{.at = 0.05, .reset = true}};
  const auto simulation = make_simulation(scene, 2);
  while (!simulation->finished()) simulation->step();
  EXPECT_NEAR(simulation->simulated_time(), 0.1, 1e-12);
  EXPECT_EQ(simulation->state_hash(), hash_after(short_dam_break(2), 2));
}

TEST(Simulation, ATimelineChangesWhatItSays) {
  Scene scene = free_fluid(2, 1, 0.01);
  scene.solver.time_step = FixedStep{1e-3};
  scene.duration = 0.3;
  scene.render.fps = 10;
  scene.timeline = {{.at = 0.1, .set = {.gravity = Vec3{3, 0, 0}}}, {.at = 0.2, .set = {.gravity = Vec3{0, 0, 0}}}};
  const auto simulation = make_simulation(scene, 1);
  while (!simulation->finished()) simulation->step();
  EXPECT_NEAR(simulation->diagnostics().max_speed, 0.3, 1e-6);
}

TEST(Simulation, NamesWhatDivergedWhenAndWhatToTry) {
  Scene scene = small_dam_break(2, 0.02);
  scene.solver.time_step = FixedStep{0.02};
  const auto simulation = make_simulation(scene, 2);
  std::string text;
  try {
    while (!simulation->finished()) simulation->step();
  } catch (const SimulationError& error) {
    text = error.what();
  }
  EXPECT_NE(text.find("diverged in step "), std::string::npos) << text;
  EXPECT_NE(text.find(" at t = "), std::string::npos) << text;
  EXPECT_NE(text.find(": particle "), std::string::npos) << text;
  EXPECT_NE(text.find("support radius 0.04 m"), std::string::npos) << text;
  EXPECT_NE(text.find("try a smaller solver.time_step.fixed"), std::string::npos) << text;
}

TEST(Simulation, NamesAParticleWhoseVelocityIsNoNumber) {
  Scene scene = small_dam_break(2, 0.02);
  scene.solver.compressibility = Stiffness{1e39};  // pressures overflow, and their differences are no numbers
  scene.solver.time_step = FixedStep{1e-4};
  for (const InstructionSet set : usable_instruction_sets()) {
    const auto simulation = make_simulation(scene, 2, set);
    std::string text;
    try {
      for (int i = 0; i < 10; ++i) simulation->step();
    } catch (const SimulationError& error) {
      text = error.what();
    }
    EXPECT_NE(text.find("has a velocity that is no longer a finite number"), std::string::npos) << name_of(set) << text;
  }
}

TEST(Simulation, LogsTheLimitThatBinds) {
  const auto limit = [](Scene scene) {
    const auto simulation = make_simulation(scene, 1);
    simulation->step();
    simulation->step();
    return simulation->diagnostics().limit;
  };
  Scene scene = small_dam_break(2, 0.02);
  EXPECT_EQ(limit(scene), StepLimit::acoustic);
  scene.fluid.viscosity.kinematic = 10;
  EXPECT_EQ(limit(scene), StepLimit::viscosity);
  scene.fluid.viscosity.kinematic = 0;
  scene.solver.time_step = AdaptiveStep{.maximum = 1e-6};
  EXPECT_EQ(limit(scene), StepLimit::maximum);
  scene.solver.time_step = AdaptiveStep{.cfl = 1e-9};
  EXPECT_EQ(limit(scene), StepLimit::velocity);
  scene.solver.time_step = AdaptiveStep{.force = 1e-9};
  EXPECT_EQ(limit(scene), StepLimit::force);
  scene.solver.time_step = FixedStep{1e-6};
  EXPECT_EQ(limit(scene), StepLimit::fixed);
}

TEST(Simulation, ReportsEnergiesAndMomentumOfAMovingBlock) {
  Scene scene = free_fluid(2, 4, 0.5);
  scene.gravity = {0, -10, 0};
  scene.fluid.volumes[0].velocity = {3, 4, 0};
  const auto simulation = make_simulation(scene, 1);
  const Diagnostics d = simulation->diagnostics();
  const double mass = 1000 * 4;  // rho0 times the 2 m x 2 m square
  EXPECT_NEAR(d.kinetic_energy, 0.5 * mass * 25, 1e-9 * mass);
  EXPECT_NEAR(d.potential_energy, mass * 10 * 1, 1e-9 * mass);
  EXPECT_NEAR(d.momentum[0], 3 * mass, 1e-9 * mass);
  EXPECT_NEAR(d.momentum[1], 4 * mass, 1e-9 * mass);
  EXPECT_EQ(d.max_speed, 5);
  EXPECT_NEAR(d.center_of_mass[0], 1, 1e-12);
  EXPECT_LT(d.mean_density_error, 0) << "a free surface lacks neighbours";
  EXPECT_NEAR(d.mean_compression, d.max_density_error * 4 / 16, 1e-7) << "four inner particles have the lattice error";
}

}  // namespace
}  // namespace weir
