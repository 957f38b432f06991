// The numbers of one log row.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace weir {

// What kept the last time step from being longer.
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

}  // namespace weir
