// How metres become pixels.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "core/types.h"
#include "scene/scene.h"

namespace weir {

// Pixel coordinates run from the picture's top left corner to the right and down; pixel (i, j) covers [i, i+1] x [j,
// j+1].
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
  double focal = 1;         // pixels per metre; in perspective at one metre of depth
  glm::dvec2 principal{0};  // the pixel in which the line of sight ends
  double focus_depth = 1;   // m, where the scale bar is true; unused in 2D
  bool operator==(const Projection&) const = default;

  double depth(const Vec3& point) const { return glm::dot(forward, point - eye); }
  // Pixels per metre at that point.
  double scale(const Vec3& point) const { return perspective ? focal / depth(point) : focal; }
  glm::dvec2 pixel(const Vec3& point) const;
  double pixels_per_metre() const { return perspective ? focal / focus_depth : focal; }
};

// A view that a scene states: its centre is the picture's centre. Never AutoView.
Projection projection_of(const View& view, int width, int height);

// All of `bounds`, as large as fits into `content`, and centred there.
Projection fit_2d(const Bounds& bounds, const PixelBox& content);
// Seen from the front, a little from the left and above.
Projection fit_3d(const Bounds& bounds, const PixelBox& content);

}  // namespace weir
