#include "render/nice_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace weir {

namespace {

// Tolerance of quotients: 0.3 / 0.1 rounds to less than 3.
constexpr double slack = 1e-9;

}  // namespace

double round_up_nicely(double value) {
  if (!(value > 0)) return 1;
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (value <= step * decade * (1 + slack)) return step * decade;
  return 10 * decade;
}

double round_down_125(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value * (1 + slack))));
  for (const double step : {5.0, 2.0})
    if (step * decade <= value * (1 + slack)) return step * decade;
  return decade;
}

std::string length_text(double metres) {
  const DisplayUnit unit = display_unit("m", metres);
  return fmt::format("{:.6g} {}", metres * unit.factor, unit.name);
}

DisplayUnit display_unit(const std::string& si_unit, double largest) {
  const double size = std::abs(largest) * (1 + slack);
  if (si_unit == "m") {
    if (size < 1e-3) return {1e6, "µm"};
    if (size < 1e-2) return {1e3, "mm"};
    if (size < 1) return {1e2, "cm"};
    if (size >= 1e3) return {1e-3, "km"};
  } else if (si_unit == "m/s") {
    if (size < 1e-3) return {1e6, "µm/s"};
    if (size < 1e-1) return {1e3, "mm/s"};
  } else if (si_unit == "Pa") {
    if (size >= 1e6) return {1e-6, "MPa"};
    if (size >= 1e3) return {1e-3, "kPa"};
  }
  return {1, si_unit};
}

}  // namespace weir
