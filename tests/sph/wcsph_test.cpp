#include "sph/wcsph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

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
  solver.compute_density();
  solver.compute_pressure();
  solver.compute_accelerations();
}

// The equations of physics.md once more, in double, over all pairs, written from the page and not from src/equations.
template <int Dim>
struct BruteForce {
  using V = Vec<Dim, double>;
  const Scene& scene;
  const Wcsph<Dim>& solver;
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
    for (const V& x_j : solver.fluid().position) rho += m * w(norm(solver.fluid().position[i] - x_j));
    for (const V& x_j : solver.walls().position) rho += m * w(norm(solver.fluid().position[i] - x_j));
    return rho;
  }
  static double norm(const V& x) { return std::sqrt(dot(x, x)); }
  double pressure(double rho) const {
    return std::max(0.0, stiffness(scene) * (std::pow(rho / rho0, scene.solver.exponent) - 1));
  }
  V acceleration(std::size_t i, const std::vector<double>& rho) const {
    V a = from_scene<Dim, double>(scene.gravity);
    const auto& fluid = solver.fluid();
    const double term_i = pressure(rho[i]) / (rho[i] * rho[i]);
    const auto v_i = convert<double>(fluid.velocity[i]);
    const auto viscous = [&](const V& x_ij, const V& v_ij, double volume) {  // Morris' form
      const double r2 = dot(x_ij, x_ij);
      return (2 * nu * volume * dot(x_ij, grad_w(x_ij)) / (r2 + 0.01 * h * h)) * v_ij;
    };
    for (std::size_t j = 0; j < fluid.size(); ++j) {
      if (j == i) continue;
      const V x_ij = fluid.position[i] - fluid.position[j];
      a += (-m * (term_i + pressure(rho[j]) / (rho[j] * rho[j]))) * grad_w(x_ij);
      a += viscous(x_ij, v_i - convert<double>(fluid.velocity[j]), 2 * m / (rho[i] + rho[j]));
      a += scene.fluid.surface_tension.coefficient * grad_w(x_ij);
    }
    for (const V& x_j : solver.walls().position) {
      const V x_ij = fluid.position[i] - x_j;
      a += (-2 * m * term_i) * grad_w(x_ij);
      a += viscous(x_ij, v_i, 2 * m / (rho[i] + rho0));
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
  Wcsph<dim> solver(scene, sampling, team);
  accelerate(solver);

  const BruteForce<dim> exact{scene, solver};
  std::vector<double> rho(solver.fluid().size());
  double largest = 0;
  for (std::size_t i = 0; i < rho.size(); ++i) {
    rho[i] = exact.density(i);
    // Some 30 (2D) or 90 (3D) terms in single precision: far less than 30 eps = 2e-6 of the sum.
    EXPECT_NEAR(solver.fluid().density[i], rho[i], 2e-6 * rho[i]);
    largest = std::max(largest, exact.norm(exact.acceleration(i, rho)));
  }
  // rho/rho0 - 1 is formed from densities good to 2e-6, and the pressure raises that by the exponent 7; the terms that
  // cancel are of the size of the largest acceleration.
  const double tolerance = 7 * 2e-6 * 10;
  rho.clear();
  for (std::size_t i = 0; i < solver.fluid().size(); ++i) rho.push_back(exact.density(i));
  for (std::size_t i = 0; i < rho.size(); ++i) {
    const auto a = exact.acceleration(i, rho);
    for (int d = 0; d < dim; ++d) EXPECT_NEAR(solver.fluid().acceleration[i][d], a[d], tolerance * largest);
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
      const auto n = static_cast<double>(solver.fluid().size());
      double typical = 0;
      Vec<dim, double> mean{};
      for (const auto& a : solver.fluid().acceleration) {
        typical += std::sqrt(static_cast<double>(dot(a, a))) / n;
        mean += (1 / n) * convert<double>(a);
      }
      EXPECT_GT(typical, 0.1);
      // The forces of each pair cancel to the last bit; what remains is the rounding of sums of up to 100 terms.
      for (int d = 0; d < dim; ++d) EXPECT_NEAR(mean[d], 0, 100 * 6e-8 * typical);
    }
  }
}

}  // namespace
}  // namespace weir
