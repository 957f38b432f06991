#include "report/hinsch2024.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "report/scenes.h"
#include "scene/check.h"

namespace weir {
namespace {

constexpr double exact_pi = 3.141592653589793;

// The cubic spline of [Hinsch24 ch. 4.1], branch by branch as printed.
double cubic_spline_2d(double r, double h) {
  const double q = r / h;
  const double alpha = 5 / (14 * exact_pi * h * h);
  if (q < 1) return alpha * (std::pow(2 - q, 3) - 4 * std::pow(1 - q, 3));
  if (q < 2) return alpha * std::pow(2 - q, 3);
  return 0;
}

double cubic_spline_derivative_2d(double r, double h) {
  const double q = r / h;
  const double alpha = 5 / (14 * exact_pi * h * h);
  if (q < 1) return alpha / h * (-3 * std::pow(2 - q, 2) + 12 * std::pow(1 - q, 2));
  if (q < 2) return alpha / h * (-3 * std::pow(2 - q, 2));
  return 0;
}

// Water 0.2 m wide and 0.4 m high between walls.
Scene small_tower() {
  Scene scene;
  scene.name = "small_tower";
  scene.duration = 0.4;
  scene.particle_spacing = 0.02;
  scene.fluid.volumes = {{.shape = Box{Vec3(0), {0.2, 0.4, 0}}}};
  scene.walls = {{.shape = Tank{Vec3(0), {0.2, 0.6, 0}, {Side::top}}, .layers = 2, .holes = {}}};
  scene.solver.compressibility = Stiffness{4e4};
  scene.output.movie.reset();
  return scene;
}

ReportOptions silent() {
  ReportOptions options;
  options.threads = 1;
  options.device = {"software"};
  options.message = [](const std::string&) {};
  return options;
}

double mean(const std::vector<double>& values, std::size_t from) {
  double sum = 0;
  for (std::size_t k = from; k < values.size(); ++k) sum += values[k];
  return sum / static_cast<double>(values.size() - from);
}

TEST(Hinsch2024, KernelFigureHoldsTheClosedForm) {
  const LinePlot plot = kernel_figure();
  ASSERT_EQ(plot.series.size(), 3u);
  for (const Series& series : plot.series) {
    const double h = std::stod(series.label);
    for (std::size_t k = 0; k < series.x.size(); ++k)
      ASSERT_NEAR(series.y[k], cubic_spline_2d(std::abs(series.x[k]), h), 1e-14) << series.x[k];
  }
  // Read back from the CSV: W(0) = 20 / (14 pi h^2) [Hinsch24 ch. 6.1.1].
  std::istringstream csv(csv_of(plot));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "smoothing_length[m],x[m],kernel[1/m^2]");
  int centres = 0;
  while (std::getline(csv, line)) {
    double h = 0;
    double x = 0;
    double w = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf", &h, &x, &w), 3) << line;
    if (x != 0) continue;
    ++centres;
    EXPECT_NEAR(w, 20 / (14 * exact_pi * h * h), 1e-14);
  }
  EXPECT_EQ(centres, 3);
}

TEST(Hinsch2024, KernelDerivativeFigureHoldsTheClosedForm) {
  const LinePlot plot = kernel_derivative_figure();
  ASSERT_EQ(plot.series.size(), 3u);
  for (const Series& series : plot.series) {
    const double h = std::stod(series.label);
    for (std::size_t k = 0; k < series.x.size(); ++k) {
      const double expected = std::copysign(1.0, series.x[k]) * cubic_spline_derivative_2d(std::abs(series.x[k]), h);
      ASSERT_NEAR(series.y[k], series.x[k] == 0 ? 0 : expected, 1e-13) << series.x[k];
    }
  }
}

// The compression of a column at rest is about rho g z / k: four times the stiffness, a quarter of the error.
TEST(Hinsch2024, DensityErrorFallsWithStiffness) {
  const LinePlot plot = stiffness_figure(small_tower(), silent());
  ASSERT_EQ(plot.series.size(), 3u);
  EXPECT_THAT(plot.series[0].label, "10");
  EXPECT_THAT(plot.series[1].label, "40");
  EXPECT_THAT(plot.series[2].label, "160");
  std::vector<double> errors;
  for (const Series& series : plot.series) {
    ASSERT_EQ(series.x.size(), 81u);
    EXPECT_EQ(series.x.front(), 0);
    EXPECT_NEAR(series.x.back(), 0.4, 1e-12);
    // Relative to the start: the lattice has a constant error at walls and surface.
    errors.push_back(mean(series.y, 20) - series.y.front());
  }
  EXPECT_GT(errors[0], 2 * errors[1]);
  EXPECT_GT(errors[1], errors[2]);
}

// Erratum A5: over time, curves of different time steps nearly coincide.
TEST(Hinsch2024, TimeStepDoesNotChangeTheFrequencyOfTheTower) {
  const LinePlot plot = time_step_figure(small_tower(), silent());
  ASSERT_EQ(plot.series.size(), 3u);
  const auto amplitude = [](const Series& series) {
    return *std::max_element(series.y.begin(), series.y.end()) - *std::min_element(series.y.begin(), series.y.end());
  };
  for (const Series& series : plot.series) {
    ASSERT_EQ(series.x, plot.series[0].x);
    // The first oscillation of the column, 0.1 s, before small differences grow.
    double largest = 0;
    for (std::size_t k = 0; k <= 20; ++k) largest = std::max(largest, std::abs(series.y[k] - plot.series[2].y[k]));
    EXPECT_LT(largest, 0.1 * amplitude(plot.series[2])) << series.label;
  }
}

TEST(Hinsch2024, TimeStepDividesTheSamplingIntervalAndIsStable) {
  for (const double stiffness : {1e2, 1e4, 4e4, 1e5, 3e6, 1e9}) {
    Scene tower = small_tower();
    const double dt = tower_time_step(tower, stiffness);
    const double parts = 1.0 / samples_per_second / dt;
    EXPECT_NEAR(parts, std::round(parts), 1e-9) << stiffness;
    // c0^2 = exponent k / rho0.
    EXPECT_LE(dt, 0.4 * 0.02 / std::sqrt(7 * stiffness / 1000));
  }
}

TEST(Hinsch2024, StillsAreNinePicturesOverTheWholeRun) {
  Scene scene = small_tower();
  scene.title = "Small";
  scene.render.size = {320, 200};
  scene.render.fps = 100;
  const Stills stills = stills_figure(scene, silent());
  ASSERT_EQ(stills.grid.pictures.size(), 9u);
  for (int k = 0; k < 9; ++k) {
    const Picture& picture = stills.grid.pictures[static_cast<std::size_t>(k)];
    EXPECT_EQ(picture.image.width, 640);
    EXPECT_EQ(picture.image.height, 400);
    char caption[32];
    std::snprintf(caption, sizeof caption, "t = %.3f s", 0.05 * k);
    EXPECT_EQ(picture.caption, caption);
  }
  EXPECT_NE(stills.grid.pictures[0].image.rgba, stills.grid.pictures[8].image.rgba);
  EXPECT_THAT(stills.grid.title, testing::HasSubstr("Small: 200 particles, coloured by speed from 0 to"));
  EXPECT_EQ(std::count(stills.csv.begin(), stills.csv.end(), '\n'), 10);
}

TEST(Hinsch2024, ShippedScenesAreValidAndOfThePapersSize) {
  EXPECT_TRUE(check(shipped_tower()).empty());
  EXPECT_TRUE(check(shipped_dam_break()).empty());
  const auto particles = static_cast<double>(estimate(shipped_dam_break()).fluid_particles);
  EXPECT_NEAR(particles, 15000, 0.1 * 15000);  // [Hinsch24 ch. 8]
}

// Times depend on the machine; labels and particle numbers do not.
TEST(Hinsch2024, SearchFigureComparesBothSearchesOnTheSameTowers) {
  const LinePlot plot = search_figure(small_tower(), {200, 800}, silent());
  std::vector<std::string> labels;
  for (const Series& series : plot.series) {
    labels.push_back(series.label);
    EXPECT_THAT(series.x, testing::ElementsAre(200, 800)) << "10 x 20 and 20 x 40 particles";
    EXPECT_THAT(series.y, testing::Each(testing::Gt(0)));
  }
  EXPECT_THAT(labels, testing::ElementsAre("index sort", "step, index sort", "naive", "step, naive"));
}

}  // namespace
}  // namespace weir
