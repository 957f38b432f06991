#include "stills.h"

#include <algorithm>
#include <cmath>

namespace weir {

namespace {

constexpr int few = 4;  // frames

// All but walls and particles.
Still still_of(const char* name, int dimension, double spacing, const Box& fluid) {
  Still still;
  still.scene.name = name;
  still.scene.title = "Particles";
  still.scene.dimension = dimension;
  still.scene.render.overlay.clear();
  still.scene.duration = 2;
  still.scene.particle_spacing = still.static_scene.particle_spacing = spacing;
  still.scene.render.size = {picture_width, picture_height};
  still.scene.render.color.range = {{0, 6}};
  still.scene.output.movie = Movie{};
  still.scene.fluid.volumes = {{.shape = fluid}};
  return still;
}

}  // namespace

Still wave(std::int64_t particles) { return moving_wave(particles, few); }

Still moving_wave(std::int64_t particles, int frames) {
  const double dx = std::sqrt(3.6 * 1.8 * 0.23 / static_cast<double>(particles));
  Still still = still_of("wave", 2, dx, Box{Vec3(0), Vec3(3.6, 0.4, 0)});
  for (double x = -1.5 * dx; x < 3.6 + 2 * dx; x += dx)
    for (double y = -1.5 * dx; y < 1.8; y += dx)
      if (x < 0 || x > 3.6 || y < 0) still.static_scene.walls.emplace_back(x, y, 0);
  for (int k = 0; k < frames; ++k) {
    Frame frame;
    frame.index = k;
    frame.time = 0.5 + k / 60.0;
    constexpr int cells = 400;
    for (int row = 0; row < cells / 2; ++row)
      for (int column = 0; column < cells; ++column) {
        const double side = 3.6 / cells;
        for (auto j = std::lround(row * side / dx); j < std::lround((row + 1) * side / dx); ++j)
          for (auto i = std::lround(column * side / dx); i < std::lround((column + 1) * side / dx); ++i) {
            const double x = (static_cast<double>(i) + 0.5) * dx;
            const double y = (static_cast<double>(j) + 0.5) * dx;
            const double surface = 0.41 + 0.3 * std::sin(2 * x + 0.1 * k);
            if (y > surface) continue;
            const double wobble =
                0.2 * dx * std::sin(12.9898 * static_cast<double>(i) + 78.233 * static_cast<double>(j) + k);
            frame.particles.emplace_back(static_cast<float>(x + wobble), static_cast<float>(y - wobble + 0.3 * k * dx),
                                         0.0f, static_cast<float>(3 + 3 * std::sin(3 * x + 2 * y + 0.05 * k)));
          }
      }
    still.frames.push_back(std::move(frame));
  }
  return still;
}

Still column(std::int64_t particles) {
  const double dx = std::cbrt(0.6 * 0.6 * 0.75 / static_cast<double>(particles));
  Still still = still_of("column", 3, dx, Box{Vec3(0), Vec3(0.6, 0.6, 0.75)});
  const Vec3 inside(1.8, 0.6, 0.9);
  const auto outside = [&](const Vec3& at) {
    return at.x < 0 || at.y < 0 || at.z < 0 || at.x > inside.x || at.y > inside.y;
  };
  for (double x = -1.5 * dx; x < inside.x + 2 * dx; x += dx)
    for (double y = -1.5 * dx; y < inside.y + 2 * dx; y += dx)
      for (double z = -1.5 * dx; z < inside.z; z += dx)
        if (outside(Vec3(x, y, z))) still.static_scene.walls.emplace_back(x, y, z);
  const auto wide = std::lround(0.6 / dx);
  const auto high = std::lround(0.75 / dx);
  for (int k = 0; k < few; ++k) {
    Frame frame;
    frame.index = k;
    frame.time = 0.5 + k / 60.0;
    constexpr int tile = 16;
    const auto in_tile = [&](std::int64_t i0, std::int64_t j0, std::int64_t l0) {
      for (std::int64_t i = i0; i < std::min<std::int64_t>(i0 + tile, wide); ++i)
        for (std::int64_t j = j0; j < std::min<std::int64_t>(j0 + tile, wide); ++j)
          for (std::int64_t l = l0; l < std::min<std::int64_t>(l0 + tile, high); ++l) {
            const Vec3 cell(i, j, l);
            const auto wobble = [&](double seed) {
              return 0.2 * std::sin(glm::dot(cell, Vec3(12.9898, 78.233, 37.719)) + seed);
            };
            const Vec3 at = dx * (cell + 0.5 + Vec3(wobble(k), wobble(k + 2), wobble(k + 4)));
            frame.particles.emplace_back(glm::vec3(at),
                                         static_cast<float>(3 + 3 * std::sin(6 * at.x + 4 * at.z + 0.05 * k)));
          }
    };
    for (std::int64_t i = 0; i < wide; i += tile)
      for (std::int64_t j = 0; j < wide; j += tile)
        for (std::int64_t l = 0; l < high; l += tile) in_tile(i, j, l);
    still.frames.push_back(std::move(frame));
  }
  return still;
}

}  // namespace weir
