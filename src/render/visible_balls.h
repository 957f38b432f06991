// Spheres in order of depth, with occlusion culling: a body of fluid shows little more than its outermost layer. Groups
// whose pixels are all covered by nearer spheres are not projected.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "render/ball_groups.h"
#include "render/ball_pixels.h"
#include "render/colormap.h"

namespace weir {

class VisibleBalls {
 public:
  // Adds balls at these particles to `pixels`, which have begun with that view; `groups` are theirs, BallGroup::most in
  // each. What is not a number, off those pixels or around or behind the eye is left out.
  void add_to(BallPixels& pixels, std::span<const glm::vec4> particles, std::span<const BallGroup> groups,
              const BallView& view, const Colormap& colors);

 private:
  void sort(std::span<const BallGroup> groups, const PixelRange& within);
  void project(std::span<const glm::vec4> particles, const BallView& view, const PixelRange& within,
               const Colormap& colors);
  void add_layer(BallPixels& pixels, std::uint32_t first);
  std::uint32_t layer_of(float depth) const;

  float layers_per_metre_ = 0;
  std::vector<std::uint32_t> begins_;  // of each layer in sorted_
  std::vector<std::uint32_t> sorted_;  // groups, by the layer of their front
  std::vector<ScreenBall> balls_;      // those projected
  std::vector<std::uint32_t> next_;    // for each another one of its layer
  std::vector<std::uint32_t> layers_;  // for each a ball of it
  std::vector<ScreenBall> in_layer_;
};

}  // namespace weir
