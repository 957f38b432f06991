// Where the camera is at a time.
#pragma once

#include "frame/frame.h"
#include "render/projection.h"
#include "scene/scene.h"

namespace weir {

// What an automatic view shows: walls with their particles' size, and the fluid at the start. Without walls there is no
// telling where the fluid goes; then a quarter of its larger extent is added on every side.
Bounds bounds_of(const Scene& scene, const StaticScene& static_scene);

class CameraPath {
 public:
  // `content` is the part of the picture that the overlay leaves to the scene; only an automatic view heeds it.
  CameraPath(const Scene& scene, const StaticScene& static_scene, const PixelBox& content);

  Projection at(double time) const;  // run time, s
  bool moves() const { return keyframes_.size() > 1; }

 private:
  Projection fitted_;
  std::vector<CameraKeyframe> keyframes_;
  int width_;
  int height_;
};

// Between two views of one kind, `along` in [0, 1]: the picture's width changes geometrically, and the centre such that
// the point that both pictures show at the same place stays there.
View view_between(const View& from, const View& to, double along);

}  // namespace weir
