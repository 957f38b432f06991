#include "report/hinsch2024.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/write_text.h"
#include "report/scenes.h"

namespace weir {

namespace {

// s; the oscillations that the figures show have decayed by then.
constexpr double shown = 2;

}  // namespace

void report_hinsch2024(const ReportOptions& options) {
  ReportOptions checked = options;
  if (!checked.message) checked.message = [](const std::string&) {};
  const std::filesystem::path& folder = options.folder;

  write_plot(folder / "figure_4_1", kernel_figure());
  write_plot(folder / "figure_4_2", kernel_derivative_figure());
  Scene tower = shipped_tower();
  tower.duration = std::min(tower.duration, shown);
  write_plot(folder / "figure_7_2", stiffness_figure(tower, checked));
  write_plot(folder / "figure_7_3", time_step_figure(tower, checked));
  write_plot(folder / "figure_7_4", search_figure(tower, {1000, 2000, 4000, 7000, 14000}, checked));

  const Stills stills = stills_figure(shipped_dam_break(), checked);
  write_plot(folder / "figure_8_1", stills.grid);
  write_text(folder / "figure_8_1.csv", stills.csv);
}

}  // namespace weir
