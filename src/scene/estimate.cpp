#include <algorithm>
#include <cmath>

#include "equations/time_step.h"
#include "scene/check.h"
#include "scene/geometry.h"
#include "scene/memory.h"
#include "scene/origin.h"
#include "scene/sampling.h"

namespace weir {

namespace {

// The time step at the estimated top speed; the force limit takes the accelerations that can be known beforehand.
double time_step(const Scene& scene) {
  if (const auto* fixed = std::get_if<FixedStep>(&scene.solver.time_step)) return fixed->dt;
  const AdaptiveStep& step = std::get<AdaptiveStep>(scene.solver.time_step);
  const double h = smoothing_length(scene);
  const double speed = max_speed_estimate(scene);
  double dt = acoustic_limit(step.acoustic, h, signal_speed(sound_speed(scene), speed));
  if (speed > 0) dt = std::min(dt, velocity_limit(step.cfl, h, speed));
  const double g = glm::length(scene.gravity);
  if (g > 0) dt = std::min(dt, force_limit(step.force, h, g));
  const double nu = scene.fluid.viscosity.kinematic;
  if (scene.fluid.viscosity.model != ViscosityModel::none && nu > 0) {
    const bool central = scene.fluid.viscosity.model == ViscosityModel::monaghan ||
                         scene.fluid.viscosity.model == ViscosityModel::artificial;
    dt = std::min(dt, viscous_limit(step.viscous, h, central ? central_diffusivity(nu) : nu));
  }
  if (step.maximum > 0) dt = std::min(dt, step.maximum);
  return dt;
}

}  // namespace

Estimate estimate(const Scene& scene) {
  const Scene at_origin = relative_to(scene, scene_origin(scene));
  Estimate result;
  result.fluid_particles = count_fluid(at_origin);
  result.wall_particles = count_walls(at_origin);
  result.memory = bytes_per_particle(scene) * static_cast<double>(result.fluid_particles) +
                  bytes_per_wall_particle(scene) * static_cast<double>(result.wall_particles);
  result.dt = time_step(scene);
  // Every frame time is landed on, so that each frame takes a whole number of steps.
  const double frame = 1.0 / scene.render.fps;
  const double steps = std::ceil(frame / result.dt) * std::ceil(scene.duration / frame - 1e-9);
  result.steps = static_cast<std::int64_t>(std::min(steps, 9e18));  // a step of 1e-300 s is allowed
  result.mass = particle_mass(scene) * static_cast<double>(result.fluid_particles);
  double exact = 0;
  for (const Volume& volume : scene.fluid.volumes) exact += measure(volume.shape, scene.dimension);
  result.mass_error = result.mass / (exact * scene.fluid.rest_density) - 1;
  return result;
}

}  // namespace weir
