// The figures of Hinsch 2024, one function each. Simulated figures take their scene as an argument, so that tests can
// use smaller ones.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "plot/plot.h"
#include "report/report.h"
#include "scene/scene.h"

namespace weir {

// Figures 4.1 and 4.2: the cubic spline in 2D and its derivative along x, for three smoothing lengths.
LinePlot kernel_figure();
LinePlot kernel_derivative_figure();

// Figures 7.2 and 7.3: the mean over the fluid of rho/rho0 - 1 over time. 7.2: three stiffnesses, with a fixed time
// step that suits the highest. 7.3: three time steps, with the stiffness of `tower`. Curves have `samples_per_second`
// points.
inline constexpr int samples_per_second = 200;
LinePlot stiffness_figure(const Scene& tower, const ReportOptions& options);
LinePlot time_step_figure(const Scene& tower, const ReportOptions& options);

// The largest of 1, 2.5, 5 times a power of ten that divides 1 / samples_per_second and is at most
// 0.4 h / c0 at this stiffness (Pa).
double tower_time_step(const Scene& tower, double stiffness);

// Figure 7.4: time of the neighbour search over the number of particles, for both searches, alone and within a step
// that searches, as each step of the paper does; most steps of weir reuse their lists. Times are of this machine.
LinePlot search_figure(const Scene& tower, const std::vector<std::int64_t>& particles, const ReportOptions& options);

// Figure 8.1: nine pictures over the whole duration, and log quantities at these times.
struct Stills {
  PictureGrid grid;
  std::string csv;
};
Stills stills_figure(const Scene& dam_break, const ReportOptions& options);

}  // namespace weir
