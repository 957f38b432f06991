#include "render/ball_groups.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace weir {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

float least(Four of) { return std::min({of[0], of[1], of[2], of[3]}); }
float most(Four of) { return std::max({of[0], of[1], of[2], of[3]}); }

}  // namespace

BallView::BallView(const Projection& projection, double ball_radius, const std::array<double, 2>& range)
    : eye(projection.eye),
      right(projection.right),
      up(projection.up),
      forward(projection.forward),
      principal(projection.principal),
      focal(static_cast<float>(projection.focal)),
      radius(static_cast<float>(ball_radius)),
      low(static_cast<float>(range[0])),
      steps_per_unit(static_cast<float>(255 / (range[1] - range[0]))) {}

// Bounds are a little wider than rounding needs.
BallGroup group_of(std::span<const glm::vec4> particles, const BallView& view, int width, int height) {
  Four low = all(infinity);
  Four high = -low;
  for (const glm::vec4& particle : particles) {
    Four at;
    std::memcpy(&at, &particle, sizeof(at));
    low = smaller(at, low);  // what is not a number is not smaller
    high = larger(at, high);
  }
  // The eight corners; between them everything is seen between where they are seen.
  const Four y{low[1], high[1], low[1], high[1]};
  const Four z{low[2], low[2], high[2], high[2]};
  const BallView::Seen a = view.of(all(low[0]), y, z);
  const BallView::Seen b = view.of(all(high[0]), y, z);
  const float front = least(smaller(a.depth, b.depth)) - 1.0001f * view.radius;
  BallGroup group{0, {0, 0, width - 1, height - 1}};
  // Near the eye, or with something that is not finite, they may be seen anywhere.
  const float finite = std::numeric_limits<float>::max();
  if (!(front > view.radius && most(larger(a.depth, b.depth)) <= finite)) {
    group.front = -infinity;
    return group;
  }
  group.front = front * 0.9999f;
  const float reach = most(larger(a.reach, b.reach)) + 1;
  const auto pixel = [](float at, int size) {
    return static_cast<int>(std::clamp(at, 0.0f, static_cast<float>(size - 1)));
  };
  group.pixels = {
      pixel(least(smaller(a.column, b.column)) - reach, width), pixel(least(smaller(a.row, b.row)) - reach, height),
      pixel(most(larger(a.column, b.column)) + reach, width), pixel(most(larger(a.row, b.row)) + reach, height)};
  return group;
}

}  // namespace weir
