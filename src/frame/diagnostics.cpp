#include "frame/diagnostics.h"

namespace weir {

namespace {

struct LimitName {
  StepLimit limit;
  std::string_view name;
};
constexpr std::array limit_names{
    LimitName{StepLimit::none, "none"},         LimitName{StepLimit::fixed, "fixed"},
    LimitName{StepLimit::velocity, "velocity"}, LimitName{StepLimit::acoustic, "acoustic"},
    LimitName{StepLimit::force, "force"},       LimitName{StepLimit::viscosity, "viscosity"},
    LimitName{StepLimit::maximum, "maximum"},
};

constexpr std::array columns{
    DiagnosticColumn{"time", "s", &Diagnostics::time},
    DiagnosticColumn{"step", "", &Diagnostics::step},
    DiagnosticColumn{"dt", "s", &Diagnostics::dt},
    DiagnosticColumn{"cfl", "1", &Diagnostics::cfl},
    DiagnosticColumn{"max_speed", "m/s", &Diagnostics::max_speed},
    DiagnosticColumn{"mean_density_error", "1", &Diagnostics::mean_density_error},
    DiagnosticColumn{"mean_compression", "1", &Diagnostics::mean_compression},
    DiagnosticColumn{"max_density_error", "1", &Diagnostics::max_density_error},
    DiagnosticColumn{"kinetic_energy", "J", &Diagnostics::kinetic_energy},
    DiagnosticColumn{"potential_energy", "J", &Diagnostics::potential_energy},
    DiagnosticColumn{"momentum", "kg*m/s", &Diagnostics::momentum},
    DiagnosticColumn{"simulated_time", "s", &Diagnostics::simulated_time},
    DiagnosticColumn{"limit", "", &Diagnostics::limit},
    DiagnosticColumn{"center_of_mass", "m", &Diagnostics::center_of_mass},
};

}  // namespace

std::string_view name_of(StepLimit limit) {
  for (const LimitName& each : limit_names) {
    if (each.limit == limit) return each.name;
  }
  return "?";
}

std::span<const DiagnosticColumn> diagnostic_columns() { return columns; }

}  // namespace weir
