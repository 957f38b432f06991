// The fluid's parameters that a run starts with.
#include "equations/state.h"
#include "scene/scene.h"

namespace weir {

double stiffness(const Scene& scene) {
  if (const auto* given = std::get_if<Stiffness>(&scene.solver.compressibility)) return given->k;
  const double c0 = std::get<SoundSpeed>(scene.solver.compressibility).c0;
  return stiffness_of_state(c0, scene.solver.exponent, scene.fluid.rest_density);
}

double sound_speed(const Scene& scene) {
  if (const auto* given = std::get_if<SoundSpeed>(&scene.solver.compressibility)) return given->c0;
  return sound_speed_of_state(stiffness(scene), scene.solver.exponent, scene.fluid.rest_density);
}

Parameters initial_parameters(const Scene& scene) {
  return {.gravity = scene.gravity,
          .viscosity = scene.fluid.viscosity.kinematic,
          .surface_tension = scene.fluid.surface_tension.coefficient,
          .stiffness = stiffness(scene)};
}

bool holds_fluid(const Scene& scene) {
  return scene.solver.wall_pressure == WallPressure::extrapolated && scene.solver.wall_slip == WallSlip::no_slip &&
         scene.fluid.viscosity.model != ViscosityModel::none;
}

}  // namespace weir
