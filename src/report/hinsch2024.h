// The figures of Hinsch 2024, one function each. Those that simulate take their scene, so that tests can give them less.
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

// Figures 7.2 and 7.3: the mean over the fluid of rho/rho0 - 1 against time. One fixed time step that suits the highest
// stiffness for all three in 7.2; the tower's own stiffness for all three time steps in 7.3. `tower` is taken as it is
// but for these two; the curves have `samples_per_second` points.
inline constexpr int samples_per_second = 200;
LinePlot stiffness_figure(const Scene& tower, const ReportOptions& options);
LinePlot time_step_figure(const Scene& tower, const ReportOptions& options);

// The largest of 1, 2.5, 5 times a power of ten that divides 1 / samples_per_second and is at most
// 0.4 h / c0 at this stiffness (Pa).
double tower_time_step(const Scene& tower, double stiffness);

// Figure 7.4: what finding the neighbours of so many particles costs, with either search, alone and in a step that searches,
// as the paper's do; weir's own steps mostly keep their lists. Times are of this machine.
LinePlot search_figure(const Scene& tower, const std::vector<std::int64_t>& particles, const ReportOptions& options);

// Figure 8.1: nine pictures over the whole duration, and what the log knows of these instants.
struct Stills {
  PictureGrid grid;
  std::string csv;
};
Stills stills_figure(const Scene& dam_break, const ReportOptions& options);

}  // namespace weir
