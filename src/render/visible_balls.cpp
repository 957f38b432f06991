#include "render/visible_balls.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <tuple>

namespace weir {

namespace {

// Layers are a radius thick, counted from the eye; the last takes all the rest.
constexpr std::uint32_t layers = 1 << 15;

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

bool overlap(const PixelRange& a, const PixelRange& b) {
  return a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;
}

}  // namespace

void VisibleBalls::add_to(BallPixels& pixels, std::span<const glm::vec4> particles, std::span<const BallGroup> groups,
                          const BallView& view, const Colormap& colors) {
  layers_per_metre_ = 1 / view.radius;
  balls_.clear();
  next_.clear();
  layers_.assign(layers, none);
  sort(groups, pixels.all());
  for (std::uint32_t layer = 0; layer < layers; ++layer) {
    for (std::uint32_t k = begins_[layer]; k < begins_[layer + 1]; ++k) {
      const BallGroup& group = groups[sorted_[k]];
      if (pixels.hides(group.pixels, group.front)) continue;
      const std::size_t first = BallGroup::most * sorted_[k];
      project(particles.subspan(first, std::min(BallGroup::most, particles.size() - first)), view, pixels.all(),
              colors);
    }
    if (layers_[layer] != none) add_layer(pixels, layers_[layer]);
  }
}

void VisibleBalls::sort(std::span<const BallGroup> groups, const PixelRange& within) {
  begins_.assign(layers + 2, 0);
  std::size_t count = 0;
  for (const BallGroup& group : groups) {
    if (!overlap(group.pixels, within)) continue;
    ++begins_[layer_of(group.front) + 2];
    ++count;
  }
  for (std::size_t k = 2; k < begins_.size(); ++k) begins_[k] += begins_[k - 1];
  // Each beginning moves on to its end, which is the next one's beginning.
  sorted_.resize(count);
  for (std::uint32_t k = 0; k < groups.size(); ++k)
    if (overlap(groups[k].pixels, within)) sorted_[begins_[layer_of(groups[k].front) + 1]++] = k;
}

// At most the layer of any ball behind it.
std::uint32_t VisibleBalls::layer_of(float depth) const {
  return static_cast<std::uint32_t>(std::clamp(depth * layers_per_metre_, 0.0f, static_cast<float>(layers - 1)));
}

void VisibleBalls::project(std::span<const glm::vec4> particles, const BallView& view, const PixelRange& within,
                           const Colormap& colors) {
  const auto left = static_cast<float>(within.left);
  const auto right = static_cast<float>(within.right + 1);
  const auto top = static_cast<float>(within.top);
  const auto bottom = static_cast<float>(within.bottom + 1);
  visit_by_four(particles, [&](const std::array<Four, 4>& four) {
    const BallView::Seen seen = view.of(four[0], four[1], four[2]);
    const Four place = (four[3] - view.low) * view.steps_per_unit;
    const FourWhole is_seen = (seen.depth > view.radius) & (seen.column > left - seen.reach) &
                              (seen.column < right + seen.reach) & (seen.row > top - seen.reach) &
                              (seen.row < bottom + seen.reach) & (place == place);
    const FourWhole color = truncated(larger(smaller(place, all(255)), all(0)) + 0.5f);
    const FourWhole layer = truncated(smaller(seen.depth * layers_per_metre_, all(layers - 1)));
    FourWhole colors_of{};
    for (int k = 0; k < 4; ++k) colors_of[k] = static_cast<std::int32_t>(colors[color[k]]);
    const std::array<Four, 4> balls = transposed({seen.column, seen.row, seen.depth, std::bit_cast<Four>(colors_of)});
    for (int k = 0; k < 4; ++k) {
      if (is_seen[k] == 0) continue;
      next_.push_back(layers_[layer[k]]);
      layers_[layer[k]] = static_cast<std::uint32_t>(balls_.size());
      balls_.push_back(std::bit_cast<ScreenBall>(balls[k]));
    }
  });
}

void VisibleBalls::add_layer(BallPixels& pixels, std::uint32_t first) {
  in_layer_.clear();
  for (std::uint32_t k = first; k != none; k = next_[k]) {
    const ScreenBall& ball = balls_[k];
    if (!pixels.hides(pixels.pixels_of(ball), pixels.front_of(ball))) in_layer_.push_back(ball);
  }
  // In an order of their own, which decides between surfaces that are equally far.
  const auto order = [](const ScreenBall& ball) { return std::tuple(ball.depth, ball.x, ball.y, ball.color); };
  std::sort(in_layer_.begin(), in_layer_.end(),
            [&](const ScreenBall& a, const ScreenBall& b) { return order(a) < order(b); });
  for (const ScreenBall& ball : in_layer_) pixels.add(ball);
}

}  // namespace weir
