#include <algorithm>
#include <array>

#include "equations/energy.h"
#include "equations/state.h"
#include "render/nice_numbers.h"
#include "render/renderer.h"

namespace weir {

namespace {

// Stiffness of the linear equation of state with the same sound speed, Pa: relative change of density = change of
// pressure / this.
double bulk_modulus(const Scene& scene) { return stiffness_of_state(sound_speed(scene), 1, scene.fluid.rest_density); }

}  // namespace

std::array<double, 2> color_range(const Scene& scene, const StaticScene& static_scene) {
  if (scene.render.color.range) return *scene.render.color.range;
  const double speed = static_scene.max_speed_estimate;
  // rho0 g H for a column that collapses from height H with speed sqrt(2 g H).
  const double pressure = dynamic_pressure(scene.fluid.rest_density, speed);
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
