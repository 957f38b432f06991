// Lit spheres, rasterised by several threads, each in strips of the picture of its own. Pixels depend neither on the
// order of spheres nor on other pixels, hence not on the number of threads.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "core/thread_pool.h"
#include "render/ball_groups.h"
#include "render/ball_pixels.h"
#include "render/colormap.h"
#include "render/particle_pixels.h"
#include "render/projection.h"
#include "render/visible_balls.h"

namespace weir {

struct BallStyle {
  double radius = 0;                  // m
  std::array<double, 2> range{0, 1};  // of the particles' quantity, for the colour map
};

class Balls final : public ParticlePixels {
 public:
  Balls(int width, int height, int threads);  // pixels

  // What is shown from now on. What is not a number, or around or behind the eye, is left out.
  void show(std::span<const glm::vec4> particles, const Projection& projection, const BallStyle& style,
            const Colormap& colors);

  void mark(Squares& squares) override;
  void take(const Squares& squares, double opacity, Texel* texels, const RowTaken& taken) override;

 private:
  struct Strip {
    BallPixels pixels;
    VisibleBalls balls;
  };

  int width_;
  int height_;
  int threads_;
  std::unique_ptr<ThreadPool> pool_;  // made with the first balls
  std::vector<BallGroup> groups_;
  std::vector<Strip> strips_;
};

}  // namespace weir
