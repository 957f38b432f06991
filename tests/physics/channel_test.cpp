// Flow between plates from rest, driven by a body force (Poiseuille) or by the upper plate (Couette).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "equations/kernels.h"
#include "equations/momentum.h"
#include "physics/exact.h"
#include "physics/state.h"
#include "scene/names.h"
#include "scene/reader.h"

namespace weir {
namespace {

constexpr double d = 1e-3;              // between the plates, m
constexpr double nu = 1e-6;             // m^2/s
constexpr double v_top = 1.25e-5;       // m/s, in the middle of the one, at the plate of the other
constexpr int widths[] = {10, 20, 40};  // d / dx

// What `morris` with Wendland's kernel makes of nu lap u on a lattice with h = 2 dx, over that: its softening of r^2 takes
// 1.5 % off. The flow is compared with that of this viscosity, so that what is left falls with dx.
double lattice_share() {
  constexpr int reach = 4;
  const auto kernel = kernel_at<WendlandC2, 2, double>(2);
  double sum = 0;
  for (int x = -reach; x <= reach; ++x)
    for (int y = -reach; y <= reach; ++y) {
      const double r2 = x * x + y * y;
      if (r2 == 0) continue;
      // u_x = y^2 / 2, whose Laplacian is 1.
      sum -= y * y * kernel.derivative_over_r(std::sqrt(r2)) * r2 / (r2 + viscosity_softening * 4);
    }
  return sum;
}

// What the sum of W makes of the density on that lattice, over the rest density: with summed densities viscosity acts on
// fluid that is so much denser.
double lattice_density() {
  constexpr int reach = 4;
  const auto kernel = kernel_at<WendlandC2, 2, double>(2);
  double sum = 0;
  for (int x = -reach; x <= reach; ++x)
    for (int y = -reach; y <= reach; ++y) sum += kernel.value(std::hypot(x, y));
  return sum;
}

struct Errors {
  double largest = 0;  // over v_top
  double l2 = 0;       // root of the mean square, over that of the exact flow
};

// At each of Morris's times and in the steady state. Scene: "poiseuille" or "couette".
std::map<double, Errors> errors(const std::string& scene, const Channel& exact, int width,
                                std::vector<Override> overrides) {
  overrides.push_back({"particles.spacing", fmt::format("{}", d / width)});
  overrides.push_back({"output.movie", "false"});
  const auto simulation = make_simulation(read_scene("scenes/validation/" + scene + ".yaml", overrides), 1);
  std::map<double, Errors> at;
  for (const double time : {0.0225, 0.045, 0.1125, 0.225, 1.0}) {
    run_to(*simulation, time);
    double squares = 0, exact_squares = 0;
    for (const Particle& particle : particles(*simulation)) {
      const double u = exact.velocity(particle.x.y, simulation->time());
      const double error = particle.v.x - u;
      at[time].largest = std::max(at[time].largest, std::abs(error) / v_top);
      squares += error * error;
      exact_squares += u * u;
    }
    at[time].l2 = std::sqrt(squares / exact_squares);
  }
  return at;
}

class ChannelOf : public testing::TestWithParam<Method> {
 protected:
  static std::vector<Override> settings() { return {{"solver.method", std::string(name_of(GetParam()))}}; }
  static double viscosity() { return lattice_share() * nu / (GetParam() == Method::wcsph ? lattice_density() : 1); }
};
INSTANTIATE_TEST_SUITE_P(Methods, ChannelOf, testing::Values(Method::wcsph, Method::delta_sph),
                         [](const auto& choice) { return std::string(name_of(choice.param)); });

TEST_P(ChannelOf, PoiseuilleFlowConvergesWithTheSquareOfTheSpacing) {
  const Channel exact{.d = d, .nu = viscosity(), .force = 8 * nu * v_top / (d * d)};
  std::map<double, Errors> coarse;
  for (const int width : widths) {
    const auto fine = errors("poiseuille", exact, width, settings());
    for (const auto& [time, error] : coarse) {
      EXPECT_GT(observed_order(error.l2, fine.at(time).l2), 1.8) << width << " across, " << time << " s";
    }
    coarse = fine;
  }
}

// Walls continue a straight profile as it is: the steady flow is exact, and what start-up errs by is of second order.
TEST_P(ChannelOf, CouetteFlowConvergesWithTheSquareOfTheSpacingAndIsExactInTheEnd) {
  const Channel exact{.d = d, .nu = viscosity(), .v_upper = v_top};
  std::map<double, Errors> coarse;
  for (const int width : widths) {
    const auto fine = errors("couette", exact, width, settings());
    // A rounding of 2^-24 in each of the 3200 steps of the finest, at most.
    EXPECT_LT(fine.at(1.0).largest, 3200 * 0x1p-24) << width << " across";
    for (const auto& [time, error] : coarse) {
      if (time == 1.0) continue;
      EXPECT_GT(observed_order(error.l2, fine.at(time).l2), 1.8) << width << " across, " << time << " s";
    }
    coarse = fine;
  }
}

// Mirrored walls are fluid at rest where their particles stand: the channel is wider by a number of spacings.
TEST_P(ChannelOf, MirroredWallsWidenTheChannelInProportionToTheSpacing) {
  const Channel exact{.d = d, .nu = lattice_share() * nu, .force = 8 * nu * v_top / (d * d)};
  auto mirrored = settings();
  mirrored.push_back({"solver.wall_pressure", "mirrored"});
  double coarse = 0;
  for (const int width : widths) {
    const double fine = errors("poiseuille", exact, width, mirrored).at(1.0).largest;
    if (coarse > 0) {
      EXPECT_NEAR(observed_order(coarse, fine), 1, 0.2) << width << " across";
    }
    coarse = fine;
  }
}

// The viscosity of `monaghan` is 5 % too low on a lattice with h = 2 dx, and particles leave their lattice; the rest is left
// to the walls.
TEST_P(ChannelOf, PoiseuilleFlowIsStableWithMonaghansViscosity) {
  const Channel exact{.d = d, .nu = nu, .force = 8 * nu * v_top / (d * d)};
  auto monaghan = settings();
  monaghan.push_back({"fluid.viscosity.model", "monaghan"});
  EXPECT_LT(errors("poiseuille", exact, 40, monaghan).at(1.0).largest, 0.1);
}

// Morris's own numbers for the middle of the channel.
TEST(Channel, ExactSolutionsAreThoseOfThePaper) {
  const Channel poiseuille{.d = d, .nu = nu, .force = 8 * nu * v_top / (d * d)};
  const Channel couette{.d = d, .nu = nu, .v_upper = v_top};
  EXPECT_NEAR(poiseuille.velocity(d / 2, 0.0225), 2.2327e-6, 1e-10);
  EXPECT_NEAR(poiseuille.velocity(d / 2, 0.225), 1.1100e-5, 1e-9);
  EXPECT_NEAR(couette.velocity(d / 2, 0.0225), 2.3028e-7, 1e-11);
  EXPECT_NEAR(couette.velocity(d / 2, 0.225), 5.3863e-6, 1e-10);
}

}  // namespace
}  // namespace weir
