#include "scene/origin.h"

#include <cmath>

#include "scene/geometry.h"
#include "scene/span.h"

namespace weir {

namespace {

// Moves positions by -origin.
class Mover {
 public:
  explicit Mover(const Vec3& origin) : origin_(origin) {}

  void operator()(Box& box) const { corners(box); }
  void operator()(Ball& ball) const { ball.center -= origin_; }
  void operator()(Polygon& polygon) const { points(polygon.points); }
  void operator()(Tank& tank) const { corners(tank); }
  void operator()(Block& block) const { corners(block); }
  void operator()(Polyline& line) const { points(line.points); }
  void operator()(Round& round) const { round.center -= origin_; }
  void operator()(PolygonWall& polygon) const { points(polygon.points); }
  void operator()(Bounds& box) const { corners(box); }
  void operator()(AutoView&) const {}
  void operator()(View2D& view) const { view.center -= origin_; }
  void operator()(View3D& view) const {
    view.eye -= origin_;
    view.target -= origin_;
  }
  void operator()(TaylorGreen& flow) const {
    // Whole wave lengths are taken off exactly: the phase keeps its digits.
    for (int axis = 0; axis < 3; ++axis) {
      double& phase = flow.phase_origin[axis];
      phase = std::fmod(phase - origin_[axis], flow.wave_length);
      if (phase < 0) phase += flow.wave_length;
    }
  }
  void operator()(Volume& volume) const {
    std::visit(*this, volume.shape);
    if (volume.flow.taylor_green) (*this)(*volume.flow.taylor_green);
  }
  void operator()(Wall& wall) const {
    std::visit(*this, wall.shape);
    for (Shape& hole : wall.holes) std::visit(*this, hole);
  }

 private:
  template <class Cuboid>
  void corners(Cuboid& cuboid) const {
    cuboid.min -= origin_;
    cuboid.max -= origin_;
  }
  void points(std::vector<Vec3>& all) const {
    for (Vec3& point : all) point -= origin_;
  }

  Vec3 origin_;
};

}  // namespace

Vec3 scene_origin(const Scene& scene) {
  Bounds span = scene_span(scene);
  if (scene.domain) span = around(span, *scene.domain);
  Vec3 corner(0);
  double length = 0;
  double farthest = 0;
  for (int axis = 0; axis < scene.dimension; ++axis) {
    if (!std::isfinite(span.min[axis])) continue;
    corner[axis] = span.min[axis];
    farthest = std::max(farthest, std::abs(corner[axis]));
    length = std::max(length, span.max[axis] - span.min[axis]);
  }
  return farthest <= length ? Vec3(0) : corner;
}

Scene relative_to(const Scene& scene, const Vec3& origin) {
  Scene moved = scene;
  const Mover mover(origin);
  for (Volume& volume : moved.fluid.volumes) mover(volume);
  for (Wall& wall : moved.walls) mover(wall);
  if (moved.domain) mover(*moved.domain);
  std::visit(mover, moved.camera.view);
  for (CameraKeyframe& keyframe : moved.camera.keyframes) std::visit(mover, keyframe.view);
  return moved;
}

}  // namespace weir
