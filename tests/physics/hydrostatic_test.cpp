// Water at rest in Hinsch's tower: p = rho g (H - y), u = 0.
#include <gtest/gtest.h>

#include <cmath>

#include "sph/simulation.h"

namespace weir {
namespace {

constexpr double gravity = 9.81;  // m/s^2
constexpr double height = 1;      // H, m
constexpr double width = 0.4;     // m
constexpr double rho0 = 1000;     // kg/m^3

// scenes/tower.yaml with the sound speed 20 sqrt(g H).
Scene tower(double duration) {
  Scene scene;
  scene.name = "tower";
  scene.duration = duration;
  scene.particle_spacing = 0.02;
  scene.fluid.viscosity = {ViscosityModel::morris, 0.02};
  scene.fluid.volumes = {{.shape = Box{Vec3(0), {width, height, 0}}}};
  scene.walls = {{.shape = Tank{Vec3(0), {width, 1.4 * height, 0}, {Side::top}}, .layers = 2, .holes = {}}};
  scene.solver.compressibility = SoundSpeed{20 * std::sqrt(gravity * height)};
  scene.output.movie.reset();
  return scene;
}

// The line p = a + b y that fits particles between y0 and y1 best; returns a, the pressure on the floor.
double floor_pressure(const SetSnapshot& fluid, double y0, double y1) {
  double n = 0, sum_y = 0, sum_p = 0, sum_yy = 0, sum_yp = 0;
  for (std::size_t i = 0; i < fluid.count; ++i) {
    const double y = fluid.positions[i].y;
    const double p = fluid.reals(Quantity::pressure)[i];
    if (y < y0 || y > y1) continue;
    n += 1;
    sum_y += y;
    sum_p += p;
    sum_yy += y * y;
    sum_yp += y * p;
  }
  const double slope = (n * sum_yp - sum_y * sum_p) / (n * sum_yy - sum_y * sum_y);
  return (sum_p - slope * sum_y) / n;
}

TEST(Hydrostatic, TowerComesToRestUnderItsOwnWeight) {
  const Scene scene = tower(20 * std::sqrt(height / gravity));
  const auto simulation = make_simulation(scene, 0);
  while (!simulation->finished()) simulation->step();
  Snapshot snapshot;
  simulation->fill(snapshot, {.fluid = {Quantity::pressure}});

  const double exact = rho0 * gravity * height;
  // From the lower half of the column. The lowest row alone, half a spacing above the floor, reads 3 % more: the wall
  // mirrors its pressure where the true one still grows by rho g dx a row.
  const double on_floor = floor_pressure(snapshot.fluid, 0, 0.5 * height);
  EXPECT_NEAR(on_floor / exact, 1, 0.03);

  EXPECT_LT(simulation->diagnostics().max_speed, 0.01 * std::sqrt(gravity * height));

  for (const glm::vec3& particle : snapshot.fluid.positions) {
    EXPECT_TRUE(particle.x > 0 && particle.x < width && particle.y > 0 && particle.y < height + scene.particle_spacing)
        << particle.x << ", " << particle.y;
  }
  RecordProperty("floor_pressure_over_rho_g_H", std::to_string(on_floor / exact));
}

TEST(Hydrostatic, TowerHasTheSameBitsForAnyNumberOfThreads) {
  const auto hash = [](int threads) {
    const auto simulation = make_simulation(tower(0.2), threads);
    while (!simulation->finished()) simulation->step();
    return simulation->state_hash();
  };
  const std::string one = hash(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(hash(threads), one) << threads;
}

}  // namespace
}  // namespace weir
