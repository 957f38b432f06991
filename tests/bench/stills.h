// Particles to draw with no solver behind them, at 1080p, coloured by a smooth quantity and in the order of cells as the solver
// hands them over.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "scene/scene.h"

namespace weir {

constexpr int picture_width = 1920;
constexpr int picture_height = 1080;

struct Still {
  Scene scene;
  StaticScene static_scene;
  std::vector<Frame> frames;  // of which each differs from the next
};

using Make = Still(std::int64_t particles);

// 2D: a column collapsed to a wave in a tank of 3.6 m x 1.8 m, an eighth of it full; 4 frames.
Still wave(std::int64_t particles);
// 3D: a column of 0.6 m x 0.6 m x 0.75 m in a tank thrice as long, all off its lattice by up to a fifth of the spacing.
Still column(std::int64_t particles);

Still moving_wave(std::int64_t particles, int frames);

}  // namespace weir
