// How long the next time step may be.
#pragma once

#include <limits>
#include <optional>

#include "equations/time_step.h"
#include "frame/diagnostics.h"
#include "scene/scene.h"

namespace weir {

struct StepChoice {
  double dt = std::numeric_limits<double>::infinity();  // s
  StepLimit limit = StepLimit::none;

  void at_most(double bound, StepLimit reason) {
    if (bound < dt) *this = {bound, reason};
  }
};

// What steps are limited by, at one instant.
struct StepBounds {
  double h = 0;                         // m
  double max_speed = 0;                 // m/s
  double max_signal_speed = 0;          // m/s
  double max_acceleration = 0;          // m/s^2
  std::optional<double> diffusivity{};  // of velocity, m^2/s
};

inline StepChoice choose_step(const TimeStep& settings, const StepBounds& bounds) {
  StepChoice choice;
  if (const auto* fixed = std::get_if<FixedStep>(&settings)) {
    choice.at_most(fixed->dt, StepLimit::fixed);
    return choice;
  }
  const AdaptiveStep& factors = std::get<AdaptiveStep>(settings);
  choice.at_most(velocity_limit(factors.cfl, bounds.h, bounds.max_speed), StepLimit::velocity);
  choice.at_most(acoustic_limit(factors.acoustic, bounds.h, bounds.max_signal_speed), StepLimit::acoustic);
  choice.at_most(force_limit(factors.force, bounds.h, bounds.max_acceleration), StepLimit::force);
  if (bounds.diffusivity) {
    choice.at_most(viscous_limit(factors.viscous, bounds.h, *bounds.diffusivity), StepLimit::viscosity);
  }
  if (factors.maximum > 0) choice.at_most(factors.maximum, StepLimit::maximum);
  return choice;
}

}  // namespace weir
