// Which pictures a scene asks for.
#include <algorithm>
#include <cmath>

#include "scene/scene.h"

namespace weir {

std::int64_t last_frame(const Scene& scene) {
  const double frames = scene.duration * scene.render.fps;
  const double nearest = std::round(frames);
  // 0.7 s at 10 frames per second are 7 frames although the product in binary is a little less.
  const bool whole = std::abs(frames - nearest) <= 1e-9 * std::max(1.0, frames);
  return static_cast<std::int64_t>(whole ? nearest : std::floor(frames));
}

bool draws(const Scene& scene) {
  return scene.output.movie.has_value() || scene.output.frames || !scene.output.stills.empty();
}

}  // namespace weir
