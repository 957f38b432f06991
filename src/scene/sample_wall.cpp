// Particles of one wall: layers of spacing dx behind its faces.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/cells.h"
#include "scene/geometry.h"
#include "scene/sample_polyline.h"
#include "scene/sampling.h"
#include "scene/tank_sides.h"

namespace weir {

namespace {

// Centres along one axis, and for each how many layers deep it lies behind the nearer face: 0 is the first layer.
struct GridAxis {
  std::vector<double> centers;
  std::vector<std::int64_t> depths;
};

// A face's cells are stretched a little, so that both ends of it are met exactly.
void add_even(GridAxis& axis, double from, double to, std::int64_t n, std::int64_t depth) {
  for (std::int64_t i = 0; i < n; ++i) {
    axis.centers.push_back(from + (static_cast<double>(i) + 0.5) * (to - from) / static_cast<double>(n));
    axis.depths.push_back(depth);
  }
}

// Outwards: the inside has depth -1.
GridAxis tank_axis(double min, double max, double dx, int layers, bool low_open, bool high_open) {
  GridAxis axis;
  for (std::int64_t k = low_open ? 0 : layers; k-- > 0;) {
    axis.centers.push_back(min - (static_cast<double>(k) + 0.5) * dx);
    axis.depths.push_back(k);
  }
  add_even(axis, min, max, cells(max - min, dx), -1);
  for (std::int64_t k = 0; k < (high_open ? 0 : layers); ++k) {
    axis.centers.push_back(max + (static_cast<double>(k) + 0.5) * dx);
    axis.depths.push_back(k);
  }
  return axis;
}

// Inwards: the layers are exact, the inside is stretched; a thin block is stretched as a whole.
GridAxis block_axis(double min, double max, double dx, int layers) {
  const double thick = static_cast<double>(layers) * dx;
  GridAxis axis;
  if (max - min < 2 * thick + dx) {
    const std::int64_t n = cells(max - min, dx);
    add_even(axis, min, max, n, 0);
    for (std::int64_t i = 0; i < n; ++i) axis.depths[static_cast<std::size_t>(i)] = std::min(i, n - 1 - i);
    return axis;
  }
  for (std::int64_t k = 0; k < layers; ++k) {
    axis.centers.push_back(min + (static_cast<double>(k) + 0.5) * dx);
    axis.depths.push_back(k);
  }
  add_even(axis, min + thick, max - thick, cells(max - min - 2 * thick, dx), layers);
  for (std::int64_t k = layers; k-- > 0;) {
    axis.centers.push_back(max - (static_cast<double>(k) + 0.5) * dx);
    axis.depths.push_back(k);
  }
  return axis;
}

// A grid of centres, and how deep a particle of the wall lies along at least one axis.
struct Grid {
  std::array<GridAxis, 3> axes;
  std::int64_t first_depth;
  std::int64_t last_depth;
  bool in_wall(std::int64_t depth) const { return first_depth <= depth && depth <= last_depth; }
};

// All centres of the grid that are in the wall along at least one axis. A row inside along the other two is not walked
// through: of a large block only the skin is looked at.
void add_grid(std::vector<Vec3>& points, const Grid& grid) {
  const auto& axes = grid.axes;
  std::vector<std::size_t> all;
  std::vector<std::size_t> skin;
  for (std::size_t x = 0; x < axes[0].centers.size(); ++x) {
    all.push_back(x);
    if (grid.in_wall(axes[0].depths[x])) skin.push_back(x);
  }
  for (std::size_t z = 0; z < axes[2].centers.size(); ++z) {
    for (std::size_t y = 0; y < axes[1].centers.size(); ++y) {
      const bool whole_row = grid.in_wall(axes[1].depths[y]) || grid.in_wall(axes[2].depths[z]);
      for (const std::size_t x : whole_row ? all : skin) {
        points.emplace_back(axes[0].centers[x], axes[1].centers[y], axes[2].centers[z]);
      }
    }
  }
}

Grid grid_of(const Tank& tank, int dimension, double dx, int layers) {
  Grid grid{{GridAxis{{0}, {-1}}, GridAxis{{0}, {-1}}, GridAxis{{0}, {-1}}}, 0, layers};
  for (int axis = 0; axis < dimension; ++axis) {
    const auto [low, high] = tank_sides(axis, dimension);
    grid.axes[static_cast<std::size_t>(axis)] =
        tank_axis(tank.min[axis], tank.max[axis], dx, layers, is_open(tank, low), is_open(tank, high));
  }
  return grid;
}

Grid grid_of(const Block& block, int dimension, double dx, int layers) {
  Grid grid{{GridAxis{{0}, {layers}}, GridAxis{{0}, {layers}}, GridAxis{{0}, {layers}}}, 0, layers - 1};
  for (int axis = 0; axis < dimension; ++axis) {
    grid.axes[static_cast<std::size_t>(axis)] = block_axis(block.min[axis], block.max[axis], dx, layers);
  }
  return grid;
}

// How many points on a circle of this radius lie about dx apart, and never nearer than 0.75 dx: below that, a coarse
// circle takes one point less.
std::int64_t ring_count(double radius, double dx) {
  std::int64_t n = cells(2 * std::numbers::pi * radius, dx);
  while (n > 1 && 2 * radius * std::sin(std::numbers::pi / static_cast<double>(n)) < 0.75 * dx) --n;
  return n;
}

void add_ring(std::vector<Vec3>& points, const Vec3& center, double radius, double dx) {
  const std::int64_t n = ring_count(radius, dx);
  for (std::int64_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    points.push_back(n == 1 ? center : center + radius * Vec3(std::cos(angle), std::sin(angle), 0));
  }
}

// Rings of latitude, half a step from the poles.
void add_sphere(std::vector<Vec3>& points, const Vec3& center, double radius, double dx) {
  std::int64_t m = cells(std::numbers::pi * radius, dx);
  while (m > 1 && 2 * radius * std::sin(0.5 * std::numbers::pi / static_cast<double>(m)) < 0.75 * dx) --m;
  for (std::int64_t i = 0; i < m; ++i) {
    const double latitude = std::numbers::pi * ((static_cast<double>(i) + 0.5) / static_cast<double>(m) - 0.5);
    add_ring(points, center + Vec3(0, 0, radius * std::sin(latitude)), radius * std::cos(latitude), dx);
  }
}

// All of a wall, without regard to its holes.
template <class Cuboid>
std::vector<Vec3> solid(const Cuboid& cuboid, int dimension, double dx, int layers) {
  std::vector<Vec3> points;
  add_grid(points, grid_of(cuboid, dimension, dx, layers));
  return points;
}
std::vector<Vec3> solid(const Polyline& line, int, double dx, int layers) { return sample_polyline(line, dx, layers); }
std::vector<Vec3> solid(const PolygonWall& polygon, int, double dx, int layers) {
  return sample_polyline(outline_of(polygon), dx, layers);
}
std::vector<Vec3> solid(const Round& round, int dimension, double dx, int layers) {
  std::vector<Vec3> points;
  const double sense = round.solid == Face::inside ? -1 : 1;
  for (int k = 0; k < layers; ++k) {
    const double radius = round.radius + sense * (k + 0.5) * dx;
    if (radius < 0) break;
    if (dimension == 2) {
      add_ring(points, round.center, radius, dx);
    } else {
      add_sphere(points, round.center, radius, dx);
    }
  }
  return points;
}

}  // namespace

std::vector<Vec3> sample_wall(const Wall& wall, int dimension, double dx, int layers) {
  std::vector<Vec3> points =
      std::visit([&](const auto& each) { return solid(each, dimension, dx, layers); }, wall.shape);
  std::erase_if(points, [&](const Vec3& point) {
    return std::any_of(wall.holes.begin(), wall.holes.end(),
                       [&](const Shape& hole) { return inside(hole, point, dimension); });
  });
  return points;
}

}  // namespace weir
