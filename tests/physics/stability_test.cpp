// How long a step sound and viscosity allow. On a lattice at rest a small wave u exp(i k x) of density and velocity obeys, with the
// summed density and the symmetric pressure force, u'' = -c0^2 |G(k)|^2 u, where G(k) = sum_j V grad W sin(k x_j) is what the
// sum makes of a gradient. Euler-Cromer keeps an oscillation of frequency omega bounded while omega dt < 2 (von Neumann):
// dt c0 / h < 2 / (h max |G|).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/error.h"
#include "equations/kernels.h"
#include "equations/momentum.h"
#include "equations/time_step.h"
#include "sph/simulation.h"

namespace weir {
namespace {

// The largest dt c0 / h, for h / dx.
template <template <int> class Kernel, int Dim>
double sound_limit(double h) {
  const auto kernel = kernel_at<Kernel, Dim, double>(h);
  const int reach = static_cast<int>(std::ceil(2 * h));
  const int waves = Dim == 2 ? 48 : 16;
  double largest = 0;
  const auto gradient = [&](const Vec<3, double>& k) {
    Vec<3, double> g{};
    for (int x = -reach; x <= reach; ++x)
      for (int y = -reach; y <= reach; ++y)
        for (int z = Dim == 3 ? -reach : 0; z <= (Dim == 3 ? reach : 0); ++z) {
          const Vec<3, double> at{double(x), double(y), double(z)};
          const double r = std::sqrt(dot(at, at));
          if (r > 0) g += (kernel.derivative_over_r(r) * std::sin(dot(k, at))) * at;
        }
    return std::sqrt(dot(g, g));
  };
  for (int a = 0; a <= waves; ++a)
    for (int b = 0; b <= waves; ++b)
      for (int c = 0; c <= (Dim == 3 ? waves : 0); ++c)
        largest = std::max(largest, gradient({pi * a / waves, pi * b / waves, pi * c / waves}));
  return 2 / (h * largest);
}

TEST(Stability, TheDefaultStepIsThreeFifthsOfWhatSoundAllowsAtMost) {
  double least = 10;
  for (const double h : {1.0, 1.3, 2.0}) {
    least = std::min({least, sound_limit<CubicSpline, 2>(h), sound_limit<WendlandC2, 2>(h),
                      sound_limit<CubicSpline, 3>(h), sound_limit<WendlandC2, 3>(h)});
  }
  EXPECT_LE(AdaptiveStep{}.acoustic, 0.6 * least);
  EXPECT_GT(AdaptiveStep{}.acoustic, 0.5 * least);
}

// The largest dt nu / h^2, for h / dx. A wave u exp(i k x) of velocity obeys u' = -nu D(k) u, D what the viscosity makes of
// the Laplacian, a matrix; Euler's steps keep it bounded while dt nu D < 2.
template <class Viscosity, template <int> class Kernel, int Dim>
double viscosity_limit(double h) {
  const auto kernel = kernel_at<Kernel, Dim, double>(h, -1);
  const auto viscosity = Viscosity::template of<Dim>(1, h);
  const int reach = static_cast<int>(std::ceil(2 * h));
  const int waves = Dim == 2 ? 24 : 6;
  double largest = 0;
  const auto damping = [&](const Vec<Dim, double>& k, const Vec<Dim, double>& u) {
    Vec<Dim, double> sum{};
    for (int x = -reach; x <= reach; ++x)
      for (int y = -reach; y <= reach; ++y)
        for (int z = Dim == 3 ? -reach : 0; z <= (Dim == 3 ? reach : 0); ++z) {
          Pair<Dim, double> pair{.x_ij = {},
                                 .v_ij = {},
                                 .r2 = 0,
                                 .f = 0,
                                 .rho_i = 1,
                                 .rho_j = 1,
                                 .pressure_term_i = 0,
                                 .pressure_term_j = 0};
          const int at[3] = {x, y, z};
          for (int d = 0; d < Dim; ++d) pair.x_ij[d] = at[d];
          pair.r2 = dot(pair.x_ij, pair.x_ij);
          if (pair.r2 == 0) continue;
          pair.v_ij = (std::cos(dot(k, pair.x_ij)) - 1) * u;
          pair.f = kernel.derivative_over_r(std::sqrt(pair.r2));
          sum += acceleration(pair, viscosity.from_fluid(pair));
        }
    return sum;
  };
  for (int a = 0; a <= waves; ++a)
    for (int b = 0; b <= a; ++b)
      for (int c = 0; c <= (Dim == 3 ? b : 0); ++c) {
        Vec<Dim, double> k{};
        const int wave[3] = {a, b, c};
        for (int d = 0; d < Dim; ++d) k[d] = pi * wave[d] / waves;
        if (a == 0) continue;
        // The most damped direction, by iteration from a start along none of the lattice's axes.
        Vec<Dim, double> u{};
        for (int d = 0; d < Dim; ++d) u[d] = 1 - 0.2 * d;
        for (int i = 0; i < 10; ++i) u = (1 / std::sqrt(dot(u, u))) * damping(k, u);
        largest = std::max(largest, std::sqrt(dot(u, u)));
      }
  return 2 / (h * h * largest);
}

// Of the kernels and widths in use.
template <class Viscosity>
double least_viscosity_limit() {
  double least = 10;
  for (const double h : {1.0, 1.5, 2.0}) {
    least =
        std::min({least, viscosity_limit<Viscosity, CubicSpline, 2>(h), viscosity_limit<Viscosity, WendlandC2, 2>(h),
                  viscosity_limit<Viscosity, CubicSpline, 3>(h), viscosity_limit<Viscosity, WendlandC2, 3>(h)});
  }
  return least;
}

// `monaghan` tends to nu (lap u + 2 grad div u), which spreads waves of compression with 3 nu [Monaghan05].
TEST(Stability, TheDefaultStepIsHalfOfWhatViscosityAllowsAtMost) {
  const double step = AdaptiveStep{}.viscous;
  EXPECT_LE(step, 0.5 * least_viscosity_limit<MorrisViscosity>());
  EXPECT_LE(step, 0.5 * least_viscosity_limit<Hinsch2024Viscosity>());
  EXPECT_LE(step / central_diffusivity(1), 0.5 * least_viscosity_limit<MonaghanViscosity>());
}

// A closed tank full of water, whose halves run into each other at a thousandth of the sound speed. Returns how often the
// kinetic energy at the start the largest of the run is.
double energy_growth(double dt_c0_per_h) {
  Scene scene;
  scene.name = "waves";
  scene.duration = 10;
  scene.gravity = Vec3(0);
  scene.particle_spacing = 0.05;
  const double c0 = 20;
  scene.fluid.volumes = {{.shape = Box{Vec3(0), Vec3(0.5, 1, 0)}, .velocity = Vec3(0.001 * c0, 0, 0)},
                         {.shape = Box{Vec3(0.5, 0, 0), Vec3(1, 1, 0)}, .velocity = Vec3(-0.001 * c0, 0, 0)}};
  scene.walls = {{.shape = Tank{Vec3(0), Vec3(1, 1, 0), {}}, .layers = 0, .holes = {}}};
  // Enough for mirroring walls, which feed energy, and too little to matter to the limit.
  scene.fluid.viscosity = {ViscosityModel::morris, 0.03 * scene.particle_spacing * c0};
  scene.solver.compressibility = SoundSpeed{c0};
  scene.solver.negative_pressure = NegativePressure::keep;
  scene.solver.time_step = FixedStep{dt_c0_per_h * scene.particle_spacing / c0};
  scene.render.fps = 1;
  const auto simulation = make_simulation(scene, 1);
  const double start = simulation->diagnostics().kinetic_energy;
  double most = 0;
  try {
    for (int step = 0; step < 150; ++step) {
      simulation->step();
      const double energy = simulation->diagnostics().kinetic_energy;
      most = std::isfinite(energy) ? std::max(most, energy) : HUGE_VAL;
    }
  } catch (const SimulationError&) {
    return HUGE_VAL;
  }
  return most / start;
}

TEST(Stability, TheSolverTurnsUnstableWhereTheoryHasIt) {
  const double limit = sound_limit<CubicSpline, 2>(1);
  EXPECT_NEAR(limit, 1.89, 0.005);
  EXPECT_LE(energy_growth(0.5 * limit), 1);
  EXPECT_LE(energy_growth(0.9 * limit), 1);
  EXPECT_GT(energy_growth(1.1 * limit), 10);
}

}  // namespace
}  // namespace weir
