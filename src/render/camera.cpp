#include "render/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weir {

namespace {

Bounds nothing() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {Vec3(infinity), Vec3(-infinity)};
}

void include(Bounds& bounds, const Vec3& point) {
  bounds.min = glm::min(bounds.min, point);
  bounds.max = glm::max(bounds.max, point);
}

void include(Bounds& bounds, const Box& box) {
  include(bounds, box.min);
  include(bounds, box.max);
}

void include(Bounds& bounds, const Ball& ball) {
  include(bounds, ball.center - Vec3(ball.radius));
  include(bounds, ball.center + Vec3(ball.radius));
}

void include(Bounds& bounds, const Polygon& polygon) {
  for (const Vec3& point : polygon.points) include(bounds, point);
}

// Smoothstep between two keyframes: zero velocity at both.
double smoothstep(double along) { return along * along * (3 - 2 * along); }

View2D between(const View2D& from, const View2D& to, double along) {
  const double width = from.width * std::pow(to.width / from.width, along);
  // A similarity other than a translation has a fixed point, which is kept if the centre moves with the width.
  const bool zooms = std::abs(to.width - from.width) > 1e-9 * from.width;
  const double share = zooms ? (width - from.width) / (to.width - from.width) : along;
  return {glm::mix(from.center, to.center, share), width};
}

View3D between(const View3D& from, const View3D& to, double along) {
  const Vec3 from_arm = from.eye - from.target;
  const Vec3 to_arm = to.eye - to.target;
  const double from_length = glm::length(from_arm);
  const double to_length = glm::length(to_arm);
  const Vec3 from_direction = from_arm / from_length;
  const Vec3 to_direction = to_arm / to_length;
  // The eye moves on a sphere around the target along the shorter arc; horizontally between exactly opposite
  // directions.
  const double angle = std::acos(std::clamp(glm::dot(from_direction, to_direction), -1.0, 1.0));
  Vec3 aside = to_direction - glm::dot(from_direction, to_direction) * from_direction;
  if (glm::length(aside) < 1e-9) aside = glm::cross(Vec3(0, 0, 1), from_direction);
  if (glm::length(aside) < 1e-9) aside = Vec3(1, 0, 0);
  const Vec3 direction = std::cos(along * angle) * from_direction + std::sin(along * angle) * glm::normalize(aside);
  View3D view;
  view.target = glm::mix(from.target, to.target, along);
  view.eye = view.target + from_length * std::pow(to_length / from_length, along) * direction;
  view.field_of_view = glm::mix(from.field_of_view, to.field_of_view, along);
  return view;
}

}  // namespace

Bounds bounds_of(const Scene& scene, const StaticScene& static_scene) {
  Bounds fluid = nothing();
  for (const Volume& volume : scene.fluid.volumes)
    std::visit([&](const auto& shape) { include(fluid, shape); }, volume.shape);
  Bounds walls = nothing();
  for (const glm::vec3& wall : static_scene.walls) include(walls, Vec3(wall));

  Bounds all = fluid;
  if (walls.min.x <= walls.max.x) {
    const Vec3 radius(0.5 * static_scene.particle_spacing);
    include(all, walls.min - radius);
    include(all, walls.max + radius);
  } else if (fluid.min.x <= fluid.max.x) {
    const Vec3 extent = fluid.max - fluid.min;
    const double larger = std::max({extent.x, extent.y, scene.dimension == 3 ? extent.z : 0.0});
    all.min -= Vec3(0.25 * larger);
    all.max += Vec3(0.25 * larger);
  } else {
    all = {Vec3(-0.5), Vec3(0.5)};  // an empty scene: any view
  }
  if (scene.dimension == 2) all.min.z = all.max.z = 0;
  return all;
}

CameraPath::CameraPath(const Scene& scene, const StaticScene& static_scene, const PixelBox& content)
    : keyframes_(scene.camera.keyframes), width_(scene.render.size[0]), height_(scene.render.size[1]) {
  std::stable_sort(keyframes_.begin(), keyframes_.end(),
                   [](const CameraKeyframe& a, const CameraKeyframe& b) { return a.at < b.at; });
  if (!keyframes_.empty()) return;
  if (std::holds_alternative<AutoView>(scene.camera.view)) {
    const Bounds bounds = bounds_of(scene, static_scene);
    fitted_ = scene.dimension == 2 ? fit_2d(bounds, content) : fit_3d(bounds, content);
  } else {
    fitted_ = projection_of(scene.camera.view, width_, height_);
  }
}

Projection CameraPath::at(double time) const {
  if (keyframes_.empty()) return fitted_;
  const auto next = std::upper_bound(keyframes_.begin(), keyframes_.end(), time,
                                     [](double t, const CameraKeyframe& keyframe) { return t < keyframe.at; });
  if (next == keyframes_.begin()) return projection_of(keyframes_.front().view, width_, height_);
  if (next == keyframes_.end()) return projection_of(keyframes_.back().view, width_, height_);
  const CameraKeyframe& from = *(next - 1);
  const double along = smoothstep((time - from.at) / (next->at - from.at));
  return projection_of(view_between(from.view, next->view, along), width_, height_);
}

View view_between(const View& from, const View& to, double along) {
  if (std::holds_alternative<View2D>(from) && std::holds_alternative<View2D>(to))
    return between(std::get<View2D>(from), std::get<View2D>(to), along);
  if (std::holds_alternative<View3D>(from) && std::holds_alternative<View3D>(to))
    return between(std::get<View3D>(from), std::get<View3D>(to), along);
  return along < 1 ? from : to;  // views of two kinds do not blend
}

}  // namespace weir
