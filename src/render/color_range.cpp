#include <algorithm>
#include <array>

#include "equations/energy.h"
#include "equations/state.h"
#include "render/nice_numbers.h"
#include "render/renderer.h"
#include "scene/sampling.h"

namespace weir {

namespace {

// Pa; a change of pressure over the relative change of density: the stiffness of the linear state equation with the same
// sound speed.
double bulk_modulus(const Scene& scene) { return stiffness_of_state(sound_speed(scene), 1, scene.fluid.rest_density); }

// From 0 to the last of `count` numbers; never empty.
std::array<double, 2> numbers(std::int64_t count) {
  return {0, static_cast<double>(std::max<std::int64_t>(count - 1, 1))};
}

}  // namespace

std::array<double, 2> color_range(const Scene& scene, const StaticScene& static_scene) {
  if (scene.render.color.range) return *scene.render.color.range;
  const double speed = static_scene.max_speed_estimate;
  // rho0 g H for a column that collapses from height H with speed sqrt(2 g H).
  const double pressure = dynamic_pressure(scene.fluid.rest_density, speed);
  switch (facts_of(scene.render.color.by).range) {
    case RangeEstimate::none:
      break;
    case RangeEstimate::speed:
      return {0, round_up_nicely(speed)};
    case RangeEstimate::pressure:
      return {0, round_up_nicely(pressure)};
    case RangeEstimate::density: {
      const double modulus = bulk_modulus(scene);
      const double strain = modulus > 0 && pressure > 0 ? std::min(pressure / modulus, 1.0) : 0.01;
      const double change = round_up_nicely(scene.fluid.rest_density * strain);
      return {scene.fluid.rest_density - change, scene.fluid.rest_density + change};
    }
    case RangeEstimate::vorticity: {
      const double most = round_up_nicely(speed / (8 * scene.particle_spacing));
      return {scene.dimension == 2 ? -most : 0, most};
    }
    case RangeEstimate::particle_number:
      return numbers(count_fluid(scene));
    case RangeEstimate::volume_number:
      return numbers(static_cast<std::int64_t>(scene.fluid.volumes.size()));
  }
  return {0, 1};
}

}  // namespace weir
