// The speed that a scene can reach, estimated from its energies.
#include <algorithm>
#include <cmath>
#include <limits>

#include "equations/energy.h"
#include "scene/geometry.h"
#include "scene/scene.h"
#include "scene/span.h"

namespace weir {

namespace {

// Least and largest coordinate of a box along a direction.
struct Span {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};
void cover(Span& span, const Bounds& box, const Vec3& direction) {
  double low = 0;
  double high = 0;
  for (int axis = 0; axis < 3; ++axis) {
    low += std::min(direction[axis] * box.min[axis], direction[axis] * box.max[axis]);
    high += std::max(direction[axis] * box.min[axis], direction[axis] * box.max[axis]);
  }
  span.low = std::min(span.low, low);
  span.high = std::max(span.high, high);
}

// v^2 gained by falling, from the highest fluid to the lowest wall, or for the whole run where nothing is below.
double fall(const Scene& scene, const Vec3& gravity, double first_speed) {
  const double g = glm::length(gravity);
  if (g == 0) return 0;
  Span fluid;
  Span walls;
  for (const Volume& volume : scene.fluid.volumes)
    cover(fluid, shape_bounds(volume.shape, scene.dimension), gravity / g);
  for (const Wall& wall : scene.walls) cover(walls, wall_span(wall.shape, scene.dimension), gravity / g);
  const double free_speed = first_speed + g * scene.duration;
  const double free = free_speed * free_speed - first_speed * first_speed;
  const double height = std::max(walls.high, fluid.high) - fluid.low;
  const bool floor = walls.high >= fluid.high;
  return floor && height > 0 ? std::min(free, speed_squared_of_fall(g, height)) : free;
}

double initial_speed(const Scene& scene) {
  double speed = 0;
  for (const Volume& volume : scene.fluid.volumes) {
    const Bounds box = shape_bounds(volume.shape, scene.dimension);
    const double reach = 0.5 * glm::length(box.max - box.min);
    const double vortices = volume.flow.taylor_green ? std::abs(volume.flow.taylor_green->speed) : 0;
    speed = std::max(speed, glm::length(volume.velocity) + glm::length(volume.angular_velocity) * reach + vortices);
  }
  for (const Wall& wall : scene.walls) speed = std::max(speed, glm::length(wall.slide));
  return speed;
}

}  // namespace

double max_speed_estimate(const Scene& scene) {
  const double first = initial_speed(scene);
  const bool cohesive = scene.fluid.surface_tension.model != SurfaceTensionModel::none;
  double gained = fall(scene, scene.gravity, first);
  double tension = cohesive ? scene.fluid.surface_tension.coefficient : 0;
  for (const TimelineEvent& event : scene.timeline) {
    if (event.set.gravity) gained = std::max(gained, fall(scene, *event.set.gravity, first));
    if (event.set.surface_tension && cohesive) tension = std::max(tension, *event.set.surface_tension);
  }
  return std::sqrt(first * first + gained +
                   speed_squared_of_cohesion(tension, scene.particle_spacing, scene.dimension));
}

}  // namespace weir
