// The settings of timeline events in one table: keys of `set`, their description, and the parameter that each changes.
#pragma once

#include <optional>
#include <string_view>

#include "scene/scene.h"
#include "scene/spec.h"

namespace weir {

inline constexpr Spec gravity_spec{.meaning = "acceleration of everything", .unit = "m/s^2"};
inline constexpr Spec viscosity_spec{.meaning = "kinematic viscosity", .unit = "m^2/s", .range = not_negative};
inline constexpr Spec surface_tension_spec{
    .meaning = "strength of the cohesion; d is the dimension", .unit = "m^(d+2)/s^2", .range = not_negative};
inline constexpr Spec stiffness_spec{
    .meaning = "k of p = k ((rho / rest_density)^exponent - 1)", .unit = "Pa", .range = positive};
inline constexpr Spec sound_speed_spec{
    .meaning = "in place of stiffness: k = rest_density sound_speed^2 / exponent", .unit = "m/s", .range = positive};

// The member of Parameters that a setting changes.
enum class Parameter { gravity, viscosity, surface_tension, stiffness };
inline constexpr std::size_t parameter_count = 4;

template <class T>
struct Setting {
  std::string_view key;
  std::optional<T> Settings::*value;
  Parameter parameter;
  Spec spec;
};

template <class Visit>
void for_each_setting(Visit visit) {
  visit(Setting<Vec3>{"gravity", &Settings::gravity, Parameter::gravity, gravity_spec});
  visit(Setting<double>{"fluid.viscosity.kinematic", &Settings::viscosity, Parameter::viscosity, viscosity_spec});
  visit(Setting<double>{"fluid.surface_tension.coefficient", &Settings::surface_tension, Parameter::surface_tension,
                        surface_tension_spec});
  visit(Setting<double>{"solver.stiffness", &Settings::stiffness, Parameter::stiffness, stiffness_spec});
  visit(Setting<double>{"solver.sound_speed", &Settings::sound_speed, Parameter::stiffness, sound_speed_spec});
}

}  // namespace weir
