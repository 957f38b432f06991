// Projection of points, m, to pixels.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/types.h"
#include "scene/scene.h"

namespace weir {

// Pixel coordinates start at the picture's top left corner; pixel (i, j) covers [i, i+1] x [j, j+1].
struct PixelBox {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;
  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

struct Projection {
  Vec3 eye{0};  // 2D: the point at `principal`
  Vec3 right{1, 0, 0};
  Vec3 up{0, 1, 0};
  Vec3 forward{0, 0, -1};
  bool perspective = false;
  double focal = 1;         // pixels per metre; in perspective at a depth of one metre
  glm::dvec2 principal{0};  // principal point, pixels
  double focus_depth = 1;   // m, depth at which the scale bar holds; unused in 2D
  bool operator==(const Projection&) const = default;

  double depth(const Vec3& point) const { return glm::dot(forward, point - eye); }
  // Pixels per metre at that point.
  double scale(const Vec3& point) const { return perspective ? focal / depth(point) : focal; }
  glm::dvec2 pixel(const Vec3& point) const;
  double pixels_per_metre() const { return perspective ? focal / focus_depth : focal; }
};

// The projection of a view of the scene, centred in the picture; not for AutoView.
Projection projection_of(const View& view, int width, int height);

// Fits `bounds` into `content`, centred.
Projection fit_2d(const Bounds& bounds, const PixelBox& content);
// The same in 3D, from the front, slightly left and above.
Projection fit_3d(const Bounds& bounds, const PixelBox& content);

}  // namespace weir
