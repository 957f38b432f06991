#include <fmt/format.h>

#include <array>
#include <cmath>

#include "equations/kernels.h"
#include "report/hinsch2024.h"

namespace weir {

namespace {

constexpr std::array<double, 3> smoothing_lengths{0.5, 0.75, 1.0};  // m
constexpr int points = 401;
constexpr double reach = 2;  // m, support radius at the largest smoothing length

template <class Value>
LinePlot over_distance(LinePlot plot, Value value) {
  plot.x = {"x in m", "x[m]"};
  plot.legend = "h in m";
  plot.series_column = "smoothing_length[m]";
  for (const double h : smoothing_lengths) {
    Series series{fmt::format("{}", h), {}, {}};
    const auto kernel = kernel_at<CubicSpline, 2, double>(h);
    for (int k = 0; k < points; ++k) {
      const double x = reach * (2 * k - (points - 1)) / (points - 1);
      series.x.push_back(x);
      series.y.push_back(value(kernel, x));
    }
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace

LinePlot kernel_figure() {
  LinePlot plot;
  plot.title = "Cubic spline kernel in 2D";
  plot.y = {"W in m⁻²", "kernel[1/m^2]"};
  return over_distance(plot, [](const auto& kernel, double x) { return kernel.value(std::abs(x)); });
}

LinePlot kernel_derivative_figure() {
  LinePlot plot;
  plot.title = "Derivative of the cubic spline kernel in 2D";
  plot.y = {"∂W/∂x in m⁻³", "kernel_derivative[1/m^3]"};
  return over_distance(plot, [](const auto& kernel, double x) { return kernel.derivative_over_r(std::abs(x)) * x; });
}

}  // namespace weir
