// Periodic axes: what leaves at one end enters at the other.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sph/brute_force.h"
#include "sph/simulation.h"

namespace weir {
namespace {

constexpr double dx = 0.1;

// A box of n spacings along each axis, full of fluid, periodic along the first `axes` of them and without walls on others.
Scene periodic_box(int dimension, const std::vector<int>& n, int axes) {
  Scene scene;
  scene.name = "periodic_box";
  scene.dimension = dimension;
  scene.duration = 1;
  scene.gravity = Vec3(0);
  scene.particle_spacing = dx;
  Vec3 size(0);
  for (int d = 0; d < dimension; ++d) size[d] = n[static_cast<std::size_t>(d)] * dx;
  scene.fluid.volumes = {{.shape = Box{Vec3(0), size}}};
  scene.fluid.viscosity = {ViscosityModel::morris, 0.1};
  scene.solver.kernel = {KernelName::wendland_c2, 1.3};
  scene.solver.compressibility = Stiffness{1e3};
  scene.solver.negative_pressure = NegativePressure::keep;
  for (int d = 0; d < axes; ++d) scene.periodic.push_back(static_cast<Axis>(d));
  scene.output.movie.reset();
  return scene;
}

// Back into the domain, as particles are where they start.
void wrap(const Scene& scene, Sampling& sampling) {
  const Bounds extent = periodic_extent(scene);
  for (Vec3& x : sampling.fluid_positions) {
    for (int d = 0; d < scene.dimension; ++d) {
      if (!is_periodic(scene, d)) continue;
      const double length = extent.max[d] - extent.min[d];
      x[d] -= std::floor((x[d] - extent.min[d]) / length) * length;
    }
  }
}

// Boxes of one, two and several tiles along an axis (a tile of few particles is 16 spacings wide in 2D and 8 in 3D): where
// a tile is its own neighbour, or the same one on both sides.
std::vector<std::vector<int>> sizes(int dimension) {
  if (dimension == 2) return {{8, 8}, {20, 8}, {33, 20}, {50, 35}};
  return {{6, 6, 6}, {17, 6, 9}, {26, 9, 17}};
}

template <class T>
class PeriodicIn : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(PeriodicIn, Dimensions);

TYPED_TEST(PeriodicIn, EqualsABruteForceOverImages) {
  constexpr int dim = TypeParam::value;
  ThreadPool pool(2);
  for (int axes = 1; axes <= dim; ++axes) {
    for (const std::vector<int>& n : sizes(dim)) {
      const Scene scene = periodic_box(dim, n, axes);
      Sampling sampling = shaken(scene, 21);
      wrap(scene, sampling);
      for (const InstructionSet set : usable_instruction_sets()) {
        SCOPED_TRACE(fmt::format("{} axes, {} wide, {}", axes, n[0], name_of(set)));
        const auto solver = make_solver<dim>(scene, sampling, pool, set);
        accelerate(*solver);
        const State<dim> state(*solver);
        const BruteForce<dim> exact{scene, state};
        const std::vector<double> rho = exact.densities();
        const auto a = exact.accelerations(rho);
        const double by_terms = acceleration_tolerance * largest_norm<dim>(a);
        for (std::size_t i = 0; i < a.size(); ++i) {
          ASSERT_NEAR(state.density[i], rho[i], density_tolerance * rho[i]) << i;
          const auto by_pressure = exact.acceleration_tolerance_by_pressure(i, rho);
          for (int d = 0; d < dim; ++d) {
            ASSERT_NEAR(state.acceleration[i][d], a[i][d], by_terms + by_pressure[d]) << i;
          }
        }
      }
    }
  }
}

TYPED_TEST(PeriodicIn, MomentumStaysToRoundOff) {
  constexpr int dim = TypeParam::value;
  for (const Method method : {Method::wcsph, Method::delta_sph}) {
    Scene scene = periodic_box(dim, sizes(dim)[1], dim);
    scene.solver.method = method;
    ThreadPool pool(2);
    Sampling sampling = shaken(scene, 22);
    wrap(scene, sampling);
    const auto solver = make_solver<dim>(scene, sampling, pool, default_instruction_set());
    const auto momentum = [&] {
      const State<dim> state(*solver);
      Vec<dim, double> sum{};
      for (const auto& v : state.velocity) sum += v;
      return sum;
    };
    const Vec<dim, double> before = momentum();
    const State<dim> start(*solver);
    constexpr int steps = 200;
    double kicks = 0;  // sum of |dt a| over steps and particles
    for (int step = 0; step < steps; ++step) {
      const StepReport report = solver->advance(1);
      ASSERT_FALSE(report.runaway);
      for (const auto& a : State<dim>(*solver).acceleration) kicks += report.dt * norm<dim>(a);
    }
    const Vec<dim, double> after = momentum();
    double speeds = 0;
    for (const auto& v : start.velocity) speeds += norm<dim>(v);
    // Forces of a pair cancel to the last bit; what is left is the rounding of sums of 100 terms, of their product with dt,
    // and of each velocity that takes it.
    for (int d = 0; d < dim; ++d) {
      EXPECT_NEAR(after[d], before[d], rounding * (100 * kicks + steps * speeds)) << static_cast<int>(method);
    }
  }
}

TYPED_TEST(PeriodicIn, AccelerationsDoNotDependOnWhereTheSeamIs) {
  constexpr int dim = TypeParam::value;
  ThreadPool pool(2);
  const Scene scene = periodic_box(dim, sizes(dim)[1], dim);
  Sampling sampling = shaken(scene, 23);
  wrap(scene, sampling);
  const auto accelerations = [&](const Vec3& shift) {
    Sampling shifted = sampling;
    for (Vec3& x : shifted.fluid_positions) x += shift;
    wrap(scene, shifted);
    const auto solver = make_solver<dim>(scene, shifted, pool, default_instruction_set());
    accelerate(*solver);
    return State<dim>(*solver).acceleration;
  };
  const auto at_rest = accelerations(Vec3(0));
  const double tolerance = 2 * acceleration_tolerance * largest_norm<dim>(at_rest);
  for (const Vec3& shift : {Vec3(0.05, 0, 0), Vec3(0.77, 0.31, dim == 3 ? 0.12 : 0)}) {
    const auto shifted = accelerations(shift);
    for (std::size_t i = 0; i < shifted.size(); ++i) {
      for (int d = 0; d < dim; ++d) ASSERT_NEAR(shifted[i][d], at_rest[i][d], tolerance) << i;
    }
  }
}

// A lattice carried round the domain meets its own images and feels nothing. Positions come back, what counts unwrapped
// positions goes on.
TYPED_TEST(PeriodicIn, AUniformFlowGoesRoundUnharmed) {
  constexpr int dim = TypeParam::value;
  for (const std::vector<int>& n : sizes(dim)) {
    Scene scene = periodic_box(dim, n, dim);
    const double length = n[0] * dx;
    scene.fluid.volumes[0].velocity = Vec3(length, 0, 0);  // once round in a second
    scene.render.fps = 1;
    const auto simulation = make_simulation(scene, 2);
    const double start = simulation->diagnostics().center_of_mass[0];
    while (!simulation->finished()) simulation->step();
    const Diagnostics end = simulation->diagnostics();
    EXPECT_NEAR(end.center_of_mass[0] - start, length, 1e-4 * dx);
    EXPECT_NEAR(end.max_speed, length, 1e-4 * length);
    Snapshot snapshot;
    simulation->fill(snapshot, {});
    for (const glm::vec3& particle : snapshot.fluid.positions) {
      for (int d = 0; d < dim; ++d) {
        ASSERT_GE(particle[d], -1e-5);
        ASSERT_LE(particle[d], n[static_cast<std::size_t>(d)] * dx + 1e-5);
      }
    }
  }
}

TYPED_TEST(PeriodicIn, HasTheSameBitsForAnyNumberOfThreads) {
  constexpr int dim = TypeParam::value;
  Scene scene = periodic_box(dim, sizes(dim)[2], dim);
  scene.fluid.volumes[0].velocity = Vec3(3, 1, 0);
  scene.fluid.volumes[0].perturbation = 0.2;
  scene.duration = 0.2;
  const auto hash = [&](int threads) {
    const auto simulation = make_simulation(scene, threads);
    while (!simulation->finished()) simulation->step();
    return simulation->state_hash();
  };
  const std::string one = hash(1);
  for (const int threads : {2, 3}) EXPECT_EQ(hash(threads), one) << threads;
}

}  // namespace
}  // namespace weir
