#include "render/balls.h"

#include <algorithm>

namespace weir {

namespace {

// Whole areas of BallPixels; many enough that threads end together, wide enough that few balls lie in two.
constexpr int strip_width = widest_area;  // pixels
static_assert(strip_width % square_width == 0);

constexpr std::size_t groups_at_once = 64;

}  // namespace

Balls::Balls(int width, int height, int threads) : width_(width), height_(height), threads_(threads) {
  for (int left = 0; left < width; left += strip_width)
    strips_.push_back({BallPixels({left, 0, std::min(left + strip_width, width) - 1, height - 1}), {}});
}

void Balls::show(std::span<const glm::vec4> particles, const Projection& projection, const BallStyle& style,
                 const Colormap& colors) {
  if (!pool_) pool_ = std::make_unique<ThreadPool>(threads_);
  const BallView view(projection, style.radius, style.range);
  groups_.resize((particles.size() + BallGroup::most - 1) / BallGroup::most);
  pool_->for_each((groups_.size() + groups_at_once - 1) / groups_at_once, [&](std::size_t part) {
    for (std::size_t k = groups_at_once * part; k < std::min(groups_at_once * (part + 1), groups_.size()); ++k) {
      const std::size_t first = BallGroup::most * k;
      groups_[k] = group_of(particles.subspan(first, std::min(BallGroup::most, particles.size() - first)), view, width_,
                            height_);
    }
  });
  const double typical_reach = projection.pixels_per_metre() * style.radius;
  pool_->for_each(strips_.size(), [&](std::size_t k) {
    strips_[k].pixels.begin(style.radius, projection.focal, typical_reach);
    strips_[k].balls.add_to(strips_[k].pixels, particles, groups_, view, colors);
  });
}

void Balls::mark(Squares& squares) {
  for (const Strip& strip : strips_) strip.pixels.mark(squares);
}

void Balls::take(const Squares& squares, double opacity, Texel* texels, const RowTaken& taken) {
  pool_->for_each(strips_.size(), [&](std::size_t k) { strips_[k].pixels.take(squares, opacity, texels); });
  pool_->for_each(static_cast<std::size_t>(squares.rows()), [&](std::size_t row) { taken(static_cast<int>(row)); });
}

}  // namespace weir
