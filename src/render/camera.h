// The path of the camera over time.
#pragma once

#include "frame/frame.h"
#include "render/projection.h"
#include "scene/scene.h"

namespace weir {

// Bounds of the automatic view: walls, including the size of their particles, and the fluid at the start. Without walls
// the motion of the fluid is unknown: a quarter of its larger extent is added on every side.
Bounds bounds_of(const Scene& scene, const StaticScene& static_scene);

class CameraPath {
 public:
  // `content` is the part of the picture without overlay, into which an automatic view is fitted.
  CameraPath(const Scene& scene, const StaticScene& static_scene, const PixelBox& content);

  Projection at(double time) const;  // run time, s
  bool moves() const { return keyframes_.size() > 1; }

 private:
  Projection fitted_;
  std::vector<CameraKeyframe> keyframes_;
  int width_;
  int height_;
};

// Interpolates two views of one kind, `along` in [0, 1]: the width changes geometrically, and the centre such that the
// fixed point of both pictures stays fixed.
View view_between(const View& from, const View& to, double along);

}  // namespace weir
