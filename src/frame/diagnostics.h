// The numbers of one log row, and the table of the log's columns.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>

namespace weir {

// The bound that set the length of the last time step.
enum class StepLimit { none, fixed, velocity, acoustic, force, viscosity, maximum };
std::string_view name_of(StepLimit limit);

// Sums and extremes over the fluid particles at one instant; SI units. Computed only when a row is written.
struct Diagnostics {
  double time = 0;            // run time, s
  double simulated_time = 0;  // s
  std::int64_t step = 0;
  double dt = 0;
  StepLimit limit = StepLimit::none;
  double cfl = 0;                          // dt v_max / h
  double max_speed = 0;                    // m/s
  double mean_density_error = 0;           // mean of rho/rho0 - 1, signed [Hinsch24 ch. 7]
  double mean_compression = 0;             // mean of max(rho/rho0 - 1, 0)
  double max_density_error = 0;            // maximum of max(rho/rho0 - 1, 0)
  double kinetic_energy = 0;               // J (per metre of depth in 2D)
  double potential_energy = 0;             // J, -m g.x
  std::array<double, 3> momentum{};        // kg m/s
  std::array<double, 3> center_of_mass{};  // m
};

// A number, a count, a name, or a vector with one component per axis.
using DiagnosticValue = std::variant<double Diagnostics::*, std::int64_t Diagnostics::*, StepLimit Diagnostics::*,
                                     std::array<double, 3> Diagnostics::*>;

struct DiagnosticColumn {
  std::string_view name;
  std::string_view unit;  // SI, 1 for ratios; empty: a count or a name
  DiagnosticValue value;
};

// In the order of the log. Columns that scripts rely on come first; new ones are added at the end.
std::span<const DiagnosticColumn> diagnostic_columns();

}  // namespace weir
