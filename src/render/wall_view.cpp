#include "render/wall_view.h"

#include <algorithm>

namespace weir {

namespace {

// `thickness`: of the layers beyond the faces.

bool hides_inside(const Tank& tank, double thickness, const Vec3& particle, const Vec3& eye) {
  bool beyond_any = false;
  for (int axis = 0; axis < 3; ++axis) {
    const double below = tank.min[axis] - particle[axis];
    const double above = particle[axis] - tank.max[axis];
    if (std::max(below, above) > thickness) return false;
    if (below > 0 && eye[axis] >= tank.min[axis]) return false;
    if (above > 0 && eye[axis] <= tank.max[axis]) return false;
    beyond_any = beyond_any || below > 0 || above > 0;
  }
  return beyond_any;
}

bool hides_inside(const Round& round, double thickness, const Vec3& particle, const Vec3& eye) {
  if (round.solid == Face::inside) return false;
  const Vec3 out = particle - round.center;
  const double beyond = glm::length(out) - round.radius;
  return beyond > 0 && beyond <= thickness && glm::dot(out, eye - particle) > 0;
}

bool hides_inside(const Block&, double, const Vec3&, const Vec3&) { return false; }

// Shapes of 2D scenes.
bool hides_inside(const Polyline&, double, const Vec3&, const Vec3&) { return false; }
bool hides_inside(const PolygonWall&, double, const Vec3&, const Vec3&) { return false; }

}  // namespace

bool hides_inside(const Scene& scene, const Vec3& particle, const Vec3& eye) {
  for (const Wall& wall : scene.walls) {
    const double thickness = wall_layers(scene, wall) * scene.particle_spacing;
    if (std::visit([&](const auto& shape) { return hides_inside(shape, thickness, particle, eye); }, wall.shape))
      return true;
  }
  return false;
}

}  // namespace weir
