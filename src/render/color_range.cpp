#include <algorithm>
#include <array>
#include <variant>

#include "render/nice_numbers.h"
#include "render/renderer.h"

namespace weir {

namespace {

// rho0 c0^2 in Pa: what a change of pressure is divided by to give the relative change of density.
double bulk_modulus(const Scene& scene) {
  if (const auto* speed = std::get_if<SoundSpeed>(&scene.solver.compressibility))
    return scene.fluid.rest_density * speed->c0 * speed->c0;
  return scene.solver.exponent * std::get<Stiffness>(scene.solver.compressibility).k;
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
