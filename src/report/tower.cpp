#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/hinsch2024.h"
#include "sph/simulation.h"

namespace weir {

namespace {

struct Case {
  double stiffness = 0;  // Pa
  double dt = 0;         // s
};

Series density_error(Scene tower, const Case& values, std::string label, const ReportOptions& options) {
  tower.solver.compressibility = Stiffness{values.stiffness};
  tower.solver.time_step = FixedStep{values.dt};
  // Steps land on frame times: samples are at the same times for every step length, without interpolation.
  tower.render.fps = samples_per_second;
  Series series{std::move(label), {}, {}};
  const std::unique_ptr<Simulation> simulation = make_simulation(tower, options.threads);
  while (true) {
    if (simulation->frame_index() >= 0) {
      series.x.push_back(simulation->time());
      series.y.push_back(simulation->diagnostics().mean_density_error);
    }
    if (simulation->finished()) return series;
    simulation->step();
  }
}

LinePlot empty_figure() {
  LinePlot plot;
  plot.x = {"time t in s", "time[s]"};
  plot.y = {"mean of ρ/ρ₀ − 1", "mean_density_error[1]"};
  return plot;
}

}  // namespace

double tower_time_step(const Scene& tower, double stiffness) {
  Scene stiff = tower;
  stiff.solver.compressibility = Stiffness{stiffness};
  const double limit = 0.4 * smoothing_length(stiff) / sound_speed(stiff);
  double dt = 1.0 / samples_per_second;  // 5e-3; then 2.5e-3, 1e-3, 5e-4 ...
  for (int k = 0; dt > limit; ++k) dt /= k % 3 == 1 ? 2.5 : 2;
  return dt;
}

LinePlot stiffness_figure(const Scene& tower, const ReportOptions& options) {
  const double k = stiffness(tower);
  const double dt = tower_time_step(tower, 4 * k);
  LinePlot plot = empty_figure();
  plot.title = fmt::format("Tower: density error for three stiffnesses, time step {:.3g} ms", 1e3 * dt);
  plot.legend = "k in kPa";
  plot.series_column = "stiffness[kPa]";
  for (const double factor : {0.25, 1.0, 4.0}) {
    const std::string label = fmt::format("{:.4g}", 1e-3 * factor * k);
    options.message(fmt::format("figure 7.2: tower with k = {} kPa", label));
    plot.series.push_back(density_error(tower, {factor * k, dt}, label, options));
  }
  return plot;
}

LinePlot time_step_figure(const Scene& tower, const ReportOptions& options) {
  const double k = stiffness(tower);
  const double longest = tower_time_step(tower, k);
  LinePlot plot = empty_figure();
  plot.title = fmt::format("Tower: density error for three time steps, stiffness {:.4g} kPa", 1e-3 * k);
  plot.legend = "Δt in ms";
  plot.series_column = "time_step[ms]";
  for (const double factor : {1.0, 0.5, 0.25}) {
    const std::string label = fmt::format("{:.4g}", 1e3 * factor * longest);
    options.message(fmt::format("figure 7.3: tower with time steps of {} ms", label));
    plot.series.push_back(density_error(tower, {k, factor * longest}, label, options));
  }
  return plot;
}

}  // namespace weir
