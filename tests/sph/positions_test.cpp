// How exactly positions are kept.
#include "sph/positions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math.h"
#include "equations/kernels.h"
#include "sph/solver.h"

namespace weir {
namespace {

// What two of the particles see of each other while all of them fly on together, which is right in every frame of
// reference: a place x from its tile's centre is rounded to 2^-24 of its size, which the solver lets grow to a tile's
// width, 32 spacings; two of them, and the shift from one tile's frame to another's: 3 * 2^-24 * 32 = 6e-6 spacings.
TEST(Positions, ErrorOfPairsStaysBelowSixMillionthsOfASpacingHoweverFarTilesDrift) {
  Scene scene;
  scene.name = "flight";
  scene.gravity = Vec3(0);
  const double dx = scene.particle_spacing = 0.01;
  scene.solver.kernel = {KernelName::wendland_c2, 1.3};
  scene.solver.compressibility = Stiffness{1e-12};  // no force to speak of
  // Several tiles, off the lattice's own round numbers.
  scene.fluid.volumes = {
      {.shape = Box{Vec3(0.1037, 0.0511, 0), Vec3(1.3037, 1.2511, 0)}, .velocity = Vec3(7.1, -3.3, 0)}};
  ThreadPool pool(1);
  const Sampling sampling = sample(scene);
  const auto owned = make_solver<2>(scene, sampling, pool, default_instruction_set());
  SphSolver<2>& solver = *owned;
  solver.refresh();

  const auto kernel = kernel_at<WendlandC2, 2, double>(1.3 * dx, solver.particle_mass());
  double slopes = 0;  // sum of m |W'| around a particle of the lattice
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j) {
      const double r = dx * std::hypot(i, j);
      slopes += std::abs(kernel.derivative_over_r(r)) * r;
    }
  const double sum_rounding = 25 * std::ldexp(1, -24) * 1000;  // 21 neighbours and some operations each
  const double bound = 6e-6 * dx * slopes + sum_rounding;

  double farthest = 0;
  const std::int64_t sorts = solver.search().sorts(solver.fluid());
  double drift = 0;
  while (drift < 10 * dx) {  // a tile may drift (32 - 2 * 1.3 - 0.6) / 2 = 14 spacings
    solver.accelerate();
    solver.move(2e-4);
    drift += 14.2e-4;
    solver.refresh();
    for (std::size_t slot = 0; slot < solver.fluid().slots(); ++slot) {
      if (solver.fluid().empty(slot)) continue;
      farthest = std::max(farthest, std::abs(static_cast<double>(solver.fluid().x[0][slot])) / dx);
      // Away from the block's edges every particle has the density of the lattice.
      const Vec3 start = sampling.fluid_positions[static_cast<std::size_t>(solver.fluid().id[slot])];
      if (start.x < 0.2 || start.x > 1.2 || start.y < 0.15 || start.y > 1.15) continue;
      double lattice = 0;
      for (int i = -3; i <= 3; ++i)
        for (int j = -3; j <= 3; ++j) lattice += kernel.value(dx * std::hypot(i, j));
      ASSERT_NEAR(static_cast<double>(solver.density().at(slot)), lattice, bound) << "after " << drift / dx;
    }
  }
  EXPECT_EQ(solver.search().sorts(solver.fluid()), sorts) << "nothing drifted";
  EXPECT_GT(farthest, 20) << "of 32 spacings";
}

}  // namespace
}  // namespace weir
