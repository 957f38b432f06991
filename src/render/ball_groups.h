// Groups of a few dozen consecutive particles, drawn as spheres: bounds of the pixels and of the depths of each group.
//
// The order of the solver keeps neighbours in space close in memory, so a group fills a small box. In any other order
// boxes are large, which costs time and changes no pixel.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "render/ball_pixels.h"
#include "render/four.h"
#include "render/projection.h"

namespace weir {

// How particles become balls, several at once.
struct BallView {
  BallView(const Projection& projection, double ball_radius, const std::array<double, 2>& range);

  glm::vec3 eye;
  glm::vec3 right;
  glm::vec3 up;
  glm::vec3 forward;
  glm::vec2 principal;
  float focal;   // pixels per metre at one metre of depth
  float radius;  // m
  float low;     // end of the range
  float steps_per_unit;

  struct Seen {
    Four column;  // pixels
    Four row;
    Four depth;  // m
    Four reach;  // pixels
  };
  Seen of(Four x, Four y, Four z) const {
    x -= eye.x;
    y -= eye.y;
    z -= eye.z;
    const auto along = [&](const glm::vec3& axis) { return axis.x * x + axis.y * y + axis.z * z; };
    const Four depth = along(forward);
    const Four scale = focal / depth;
    return {principal.x + scale * along(right), principal.y - scale * along(up), depth,
            larger(scale * radius, all(least_ball))};
  }
};

struct BallGroup {
  static constexpr std::size_t most = 64;  // particles

  float front = 0;  // m, no ball is nearer
  PixelRange pixels;
};

// Of at most so many particles, in a picture of so many pixels.
BallGroup group_of(std::span<const glm::vec4> particles, const BallView& view, int width, int height);

}  // namespace weir
