#include "scene/advice.h"

#include <fmt/format.h>

namespace weir {

namespace {

// Mirrored walls feed energy into the flow, viscosity dissipates it. In a tower at rest 0.001 h c0 did not suffice and
// 0.01 h c0 did.
constexpr double resting_viscosity_per_h_c0 = 0.01;

}  // namespace

std::vector<std::string> advice(const Scene& scene) {
  std::vector<std::string> texts;
  const Viscosity& viscosity = scene.fluid.viscosity;
  const double nu = viscosity.model == ViscosityModel::none ? 0 : viscosity.kinematic;
  const double resting = resting_viscosity_per_h_c0 * smoothing_length(scene) * sound_speed(scene);
  const bool mirrored = !scene.walls.empty() && scene.solver.wall_pressure == WallPressure::mirrored;
  if (mirrored && nu < resting) {
    texts.push_back(
        fmt::format("fluid.viscosity.kinematic is {:.3g} m^2/s: below about 0.01 h c0 = {:.3g} m^2/s, mirrored "
                    "walls may feed energy into the flow until it becomes unstable",
                    nu, resting));
  }
  return texts;
}

}  // namespace weir
