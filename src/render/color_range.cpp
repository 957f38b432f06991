#include <algorithm>
#include <array>
#include <variant>

#include "equations/state.h"
#include "render/nice_numbers.h"
#include "render/renderer.h"

namespace weir {

namespace {

// What a change of pressure, Pa, is divided by to give the relative change of density: the stiffness of the linear state
// equation with the same sound speed.
double bulk_modulus(const Scene& scene) {
  const double rest_density = scene.fluid.rest_density;
  const auto* speed = std::get_if<SoundSpeed>(&scene.solver.compressibility);
  const double c0 = speed != nullptr ? speed->c0
                                     : sound_speed_of_state(std::get<Stiffness>(scene.solver.compressibility).k,
                                                            scene.solver.exponent, rest_density);
  return stiffness_of_state(c0, 1, rest_density);
}

}  // namespace

std::array<double, 2> color_range(const Scene& scene, const StillLife& still_life) {
  if (scene.render.color.range) return *scene.render.color.range;
  const double speed = still_life.max_speed_estimate;
  // The pressure that brings fluid to that speed, or that stops it [Bernoulli]: rho0 g H for a column that collapses
  // from height H with speed sqrt(2 g H).
  const double pressure = 0.5 * scene.fluid.rest_density * speed * speed;
  switch (scene.render.color.by) {
    case ColorBy::speed:
      return {0, round_up_nicely(speed)};
    case ColorBy::pressure:
      return {0, round_up_nicely(pressure)};
    case ColorBy::density: {
      const double modulus = bulk_modulus(scene);
      const double strain = modulus > 0 && pressure > 0 ? std::min(pressure / modulus, 1.0) : 0.01;
      const double change = round_up_nicely(scene.fluid.rest_density * strain);
      return {scene.fluid.rest_density - change, scene.fluid.rest_density + change};
    }
  }
  return {0, 1};
}

}  // namespace weir
