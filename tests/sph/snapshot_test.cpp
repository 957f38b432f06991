// What a simulation puts into a snapshot.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "core/sha256.h"
#include "sph/simulation.h"
#include "support/scenes.h"

namespace weir {
namespace {

std::unique_ptr<Simulation> stepped(const Scene& scene, int steps) {
  auto simulation = make_simulation(scene, 2);
  for (int k = 0; k < steps; ++k) simulation->step();
  return simulation;
}

Scene small(int dimension) { return small_dam_break(dimension, dimension == 2 ? 0.02 : 0.05); }

TEST(Snapshot, HoldsOnlyWhatWasAskedFor) {
  const auto simulation = stepped(small(2), 3);
  Snapshot snapshot;
  simulation->fill(snapshot, {.fluid = {Quantity::speed, Quantity::id}, .wall_positions = Precision::single});
  const auto particles = static_cast<std::size_t>(simulation->fluid_particles());
  EXPECT_EQ(snapshot.fluid.count, particles);
  EXPECT_EQ(snapshot.fluid.positions.size(), particles);
  EXPECT_TRUE(snapshot.fluid.exact_positions.empty());
  EXPECT_EQ(snapshot.fluid.reals(Quantity::speed).size(), particles);
  EXPECT_EQ(snapshot.fluid.integers(Quantity::id).size(), particles);
  EXPECT_THROW(snapshot.fluid.field(Quantity::density), std::out_of_range);
  EXPECT_EQ(snapshot.walls.positions.size(), static_cast<std::size_t>(simulation->wall_particles()));

  // Nothing is left of an earlier request.
  simulation->fill(snapshot, {.fluid_positions = Precision::exact, .fluid = {Quantity::volume}});
  EXPECT_TRUE(snapshot.fluid.positions.empty());
  EXPECT_EQ(snapshot.fluid.exact_positions.size(), particles);
  EXPECT_EQ(snapshot.fluid.fields.size(), 1U);
  EXPECT_EQ(snapshot.walls.count, 0U);
  EXPECT_TRUE(snapshot.walls.positions.empty());
}

TEST(Snapshot, HoldsEveryQuantityOfTheTable) {
  for (const int dimension : {2, 3}) {
    const auto simulation = stepped(small(dimension), 3);
    Snapshot snapshot;
    SnapshotRequest request;
    for (const QuantityFacts& facts : quantities) request.fluid.push_back(facts.quantity);
    simulation->fill(snapshot, request);
    ASSERT_EQ(snapshot.fluid.fields.size(), quantities.size());
    for (const QuantityFacts& facts : quantities) {
      const FieldValues& field = snapshot.fluid.field(facts.quantity);
      EXPECT_EQ(field.components, components_of(facts.quantity, dimension)) << facts.name;
      const std::size_t numbers = field.components * snapshot.fluid.count;
      if (facts.kind == NumberKind::integer) {
        EXPECT_EQ(snapshot.fluid.integers(facts.quantity).size(), numbers) << facts.name;
      } else {
        const std::vector<float>& values = snapshot.fluid.reals(facts.quantity);
        EXPECT_EQ(values.size(), numbers) << facts.name;
        EXPECT_TRUE(std::all_of(values.begin(), values.end(), [](float value) { return std::isfinite(value); }))
            << facts.name;
        EXPECT_TRUE(std::any_of(values.begin(), values.end(), [](float value) { return value != 0; })) << facts.name;
      }
    }
  }
}

TEST(Snapshot, HoldsEveryBitOfTheState) {
  for (const int dimension : {2, 3}) {
    const auto simulation = stepped(small(dimension), 5);
    Snapshot snapshot;
    simulation->fill(snapshot, {.fluid_positions = Precision::exact, .fluid = {Quantity::id, Quantity::velocity}});
    const std::vector<std::int32_t>& id = snapshot.fluid.integers(Quantity::id);
    const std::vector<float>& velocity = snapshot.fluid.reals(Quantity::velocity);
    std::vector<std::size_t> particle(id.size());
    for (std::size_t i = 0; i < id.size(); ++i) particle[static_cast<std::size_t>(id[i])] = i;
    const auto axes = static_cast<std::size_t>(dimension);
    Sha256 hash;
    for (const std::size_t i : particle) {
      hash.add(&snapshot.fluid.exact_positions[i], axes * sizeof(double));
      hash.add(&velocity[axes * i], axes * sizeof(float));
    }
    EXPECT_EQ(hash.hex(), simulation->state_hash());
  }
}

TEST(Snapshot, HasTheSpeedOfTheVelocity) {
  const auto simulation = stepped(small(3), 5);
  Snapshot snapshot;
  simulation->fill(snapshot, {.fluid = {Quantity::velocity, Quantity::speed}});
  const std::vector<float>& v = snapshot.fluid.reals(Quantity::velocity);
  for (std::size_t i = 0; i < snapshot.fluid.count; ++i) {
    // The square, two sums and the root round.
    EXPECT_NEAR(snapshot.fluid.reals(Quantity::speed)[i], std::hypot(v[3 * i], v[3 * i + 1], v[3 * i + 2]),
                4e-7 * simulation->diagnostics().max_speed);
  }
}

// The density of a snapshot is that of its positions, as the log's.
TEST(Snapshot, IsNotAStepBehindTheLog) {
  const Scene scene = small(2);
  const auto simulation = stepped(scene, 5);
  Snapshot snapshot;
  simulation->fill(snapshot, {.fluid = {Quantity::density}});
  double sum = 0;
  for (const float density : snapshot.fluid.reals(Quantity::density)) sum += density / scene.fluid.rest_density - 1;
  EXPECT_NEAR(sum / static_cast<double>(snapshot.fluid.count), simulation->diagnostics().mean_density_error, 1e-12);
}

TEST(Snapshot, NumbersVolumesInTheOrderOfTheScene) {
  Scene scene = free_fluid(2, 4);
  scene.fluid.volumes.push_back({.shape = Box{Vec3(2, 0, 0), Vec3(2.2, 0.3, 0)}});
  const auto simulation = stepped(scene, 1);
  Snapshot snapshot;
  simulation->fill(snapshot, {.fluid = {Quantity::volume}});
  const std::vector<std::int32_t>& volume = snapshot.fluid.integers(Quantity::volume);
  EXPECT_EQ(std::count(volume.begin(), volume.end(), 0), 16);
  EXPECT_EQ(std::count(volume.begin(), volume.end(), 1), 6);
  for (std::size_t i = 0; i < volume.size(); ++i) EXPECT_EQ(volume[i], snapshot.fluid.positions[i].x > 1 ? 1 : 0);
}

}  // namespace
}  // namespace weir
