// Water at rest in a tank, for 50 sqrt(H/g): u = 0 and the pressure of a column that its own weight compresses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "sph/simulation.h"

namespace weir {
namespace {

constexpr double gravity = 9.81;  // m/s^2
constexpr double height = 1;      // H, m
constexpr double rho0 = 1000;     // kg/m^3
constexpr int rows = 40;          // H / dx
const double wave_speed = std::sqrt(gravity * height);
const double c0 = 10 * wave_speed;

// scenes/validation/tank_at_rest.yaml, in 2D or as a slab of 3D.
Scene tank(int dimension, WallPressure walls) {
  const int up = dimension - 1;
  Scene scene;
  scene.name = "tank_at_rest";
  scene.dimension = dimension;
  scene.duration = 50 * std::sqrt(height / gravity);
  scene.particle_spacing = height / (dimension == 2 ? rows : 12);
  scene.gravity = Vec3(0);
  scene.gravity[up] = -gravity;
  Vec3 size(dimension == 2 ? 1 : 0.5, 0.5, 0);
  size[up] = height;
  if (dimension == 2) size.z = 0;
  scene.fluid.volumes = {{.shape = Box{Vec3(0), size}, .pressure = StartPressure::hydrostatic}};
  size[up] *= 1.4;
  scene.walls = {{.shape = Tank{Vec3(0), size, {Side::top}}, .layers = 0, .holes = {}}};
  scene.solver.method = Method::delta_sph;
  scene.solver.wall_pressure = walls;
  scene.solver.kernel = {KernelName::wendland_c2, dimension == 2 ? 2.0 : 1.5};
  scene.solver.compressibility = SoundSpeed{c0};
  scene.solver.exponent = 1;
  scene.solver.negative_pressure = NegativePressure::keep;
  scene.render.fps = 1;
  scene.output.movie.reset();
  return scene;
}

// Of the energy of compression at the start over the potential energy: what the log's sum of energies leaves out.
const double elastic_share = gravity * height / (3 * c0 * c0);

struct Rest {
  double pressure_error = 0;  // L2 of p - p(y), over rho0 g H
  double max_speed = 0;       // over sqrt(gH)
  double energy_gain = 0;     // kinetic and potential, over that at the start
  bool inside = true;
};

Rest settled(const Scene& scene) {
  const auto simulation = make_simulation(scene, 0);
  const Diagnostics start = simulation->diagnostics();
  while (!simulation->finished()) simulation->step();
  const Diagnostics end = simulation->diagnostics();
  Snapshot snapshot;
  simulation->fill(snapshot, {.fluid = {Quantity::pressure}});
  const std::vector<float>& pressure = snapshot.fluid.reals(Quantity::pressure);
  const int up = scene.dimension - 1;
  const Tank& walls = std::get<Tank>(scene.walls[0].shape);
  Rest rest;
  double squares = 0;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    const glm::vec3& x = snapshot.fluid.positions[i];
    // Linear equation of state, mass conserved.
    const double surface = c0 * c0 / gravity * std::log1p(gravity * height / (c0 * c0));
    const double exact = rho0 * c0 * c0 * std::expm1(gravity * (surface - x[up]) / (c0 * c0));
    squares += (pressure[i] - exact) * (pressure[i] - exact);
    for (int d = 0; d < scene.dimension; ++d) {
      rest.inside = rest.inside && x[d] > walls.min[d] && x[d] < walls.max[d];
    }
  }
  rest.pressure_error = std::sqrt(squares / static_cast<double>(pressure.size())) / (rho0 * gravity * height);
  rest.max_speed = end.max_speed / wave_speed;
  const double energy = start.kinetic_energy + start.potential_energy;
  rest.energy_gain = (end.kinetic_energy + end.potential_energy - energy) / energy;
  testing::Test::RecordProperty("pressure_error_over_rho_g_H", std::to_string(rest.pressure_error));
  testing::Test::RecordProperty("max_speed_over_sqrt_gH", std::to_string(rest.max_speed));
  return rest;
}

// Artificial viscosity of alpha = 0.02, as is customary: nu = alpha h c0 / (2 (Dim + 2)) [Monaghan 2005, eq. 8.8].
double customary_viscosity(const Scene& scene) {
  return 0.02 * smoothing_length(scene) * c0 / (2 * (scene.dimension + 2));
}

// The column of a linear equation of state is (c0^2 / (g H)) ln(1 + g H / c0^2) high, 0.5 % of H less than the lattice on
// which it starts: what it settles by is the model's, not an error. The speed is the published anchor of schemes that
// carry a density (1e-3).
TEST(TankAtRest, ExtrapolatedWallsHoldTheColumnIn2D) {
  Scene scene = tank(2, WallPressure::extrapolated);
  scene.solver.wall_slip = WallSlip::free_slip;
  scene.fluid.viscosity = {ViscosityModel::monaghan, customary_viscosity(scene)};
  const double settled_by = 1 - c0 * c0 / (gravity * height) * std::log1p(gravity * height / (c0 * c0));
  EXPECT_NEAR(settled_by, 0.005, 1e-4);
  const Rest rest = settled(scene);
  EXPECT_LE(rest.pressure_error, settled_by);
  EXPECT_LE(rest.max_speed, 1e-3);
  EXPECT_LE(rest.energy_gain, elastic_share);
  EXPECT_TRUE(rest.inside);
}

TEST(TankAtRest, ExtrapolatedWallsHoldTheColumnIn3D) {
  Scene scene = tank(3, WallPressure::extrapolated);
  scene.duration /= 5;
  scene.solver.wall_slip = WallSlip::free_slip;
  scene.fluid.viscosity = {ViscosityModel::monaghan, customary_viscosity(scene)};
  const Rest rest = settled(scene);
  // 12 rows: what particles of the top row lack, half a spacing of depth, is 1/24 of rho g H for a twelfth of them.
  EXPECT_LE(rest.pressure_error, 1.0 / 24 * std::sqrt(1.0 / 12));
  EXPECT_LE(rest.energy_gain, elastic_share);
  EXPECT_TRUE(rest.inside);
}

// A mirrored wall has the pressure of the particle itself where the true one grows by rho g times their distance, h at the
// mean: the floor's error is h/H of rho g H. It feeds energy unless viscosity takes it (0.03 h c0).
TEST(TankAtRest, MirroredWallsHoldAViscousColumn) {
  Scene scene = tank(2, WallPressure::mirrored);
  scene.fluid.viscosity = {ViscosityModel::monaghan, 0.03 * smoothing_length(scene) * c0};
  const Rest rest = settled(scene);
  EXPECT_LE(rest.pressure_error, smoothing_length(scene) / height);
  EXPECT_TRUE(rest.inside);
}

TEST(TankAtRest, HasTheSameBitsForAnyNumberOfThreads) {
  Scene scene = tank(2, WallPressure::extrapolated);
  scene.duration = 0.2;
  const auto hash = [&](int threads) {
    const auto simulation = make_simulation(scene, threads);
    while (!simulation->finished()) simulation->step();
    return simulation->state_hash();
  };
  const std::string one = hash(1);
  for (const int threads : {2, 3, 8}) EXPECT_EQ(hash(threads), one) << threads;
}

}  // namespace
}  // namespace weir
