// Particles of one wall: layers of spacing dx behind its faces.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/geometry.h"
#include "scene/sample_polyline.h"
#include "scene/sampling.h"

namespace weir {

namespace {

std::int64_t cells(double length, double dx) { return std::max<std::int64_t>(1, std::llround(length / dx)); }

// Centres along one axis, and for each how many layers deep it lies behind the nearer face: 0 is the first layer.
struct Axis {
  std::vector<double> centers;
  std::vector<std::int64_t> depths;
};

// A face's cells are stretched a little, so that both ends of it are met exactly.
void add_even(Axis& axis, double from, double to, std::int64_t n, std::int64_t depth) {
  for (std::int64_t i = 0; i < n; ++i) {
    axis.centers.push_back(from + (static_cast<double>(i) + 0.5) * (to - from) / static_cast<double>(n));
    axis.depths.push_back(depth);
  }
}

// Outwards: the inside has depth -1.
Axis tank_axis(double min, double max, double dx, int layers, bool low_open, bool high_open) {
  Axis axis;
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
Axis block_axis(double min, double max, double dx, int layers) {
  const double thick = static_cast<double>(layers) * dx;
  Axis axis;
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

// All centres of the grid that are in the wall along at least one axis. A row inside along the other two is not walked
// through: of a large block only the skin is looked at.
template <class InWall>
std::vector<Vec3> product(const std::array<Axis, 3>& axes, InWall in_wall) {
  std::vector<std::size_t> all;
  std::vector<std::size_t> skin;
  for (std::size_t x = 0; x < axes[0].centers.size(); ++x) {
    all.push_back(x);
    if (in_wall(axes[0].depths[x])) skin.push_back(x);
  }
  std::vector<Vec3> points;
  for (std::size_t z = 0; z < axes[2].centers.size(); ++z) {
    for (std::size_t y = 0; y < axes[1].centers.size(); ++y) {
      const bool whole_row = in_wall(axes[1].depths[y]) || in_wall(axes[2].depths[z]);
      for (const std::size_t x : whole_row ? all : skin) {
        points.emplace_back(axes[0].centers[x], axes[1].centers[y], axes[2].centers[z]);
      }
    }
  }
  return points;
}

// The sides at the low and the high end of an axis.
std::array<Side, 2> sides(int axis, int dimension) {
  if (axis == 0) return {Side::left, Side::right};
  if (axis == dimension - 1) return {Side::bottom, Side::top};
  return {Side::front, Side::back};
}

std::vector<Vec3> sample_shape(const Tank& tank, int dimension, double dx, int layers) {
  std::array<Axis, 3> axes{Axis{{0}, {-1}}, Axis{{0}, {-1}}, Axis{{0}, {-1}}};
  for (int axis = 0; axis < dimension; ++axis) {
    const auto [low, high] = sides(axis, dimension);
    const auto open = [&](Side side) { return std::find(tank.open.begin(), tank.open.end(), side) != tank.open.end(); };
    axes[static_cast<std::size_t>(axis)] = tank_axis(tank.min[axis], tank.max[axis], dx, layers, open(low), open(high));
  }
  return product(axes, [](std::int64_t depth) { return depth >= 0; });
}

std::vector<Vec3> sample_shape(const Block& block, int dimension, double dx, int layers) {
  std::array<Axis, 3> axes{Axis{{0}, {layers}}, Axis{{0}, {layers}}, Axis{{0}, {layers}}};
  for (int axis = 0; axis < dimension; ++axis) {
    axes[static_cast<std::size_t>(axis)] = block_axis(block.min[axis], block.max[axis], dx, layers);
  }
  return product(axes, [&](std::int64_t depth) { return depth < layers; });
}

std::vector<Vec3> sample_shape(const Polyline& line, int, double dx, int layers) {
  return sample_polyline(line, dx, layers);
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
  if (n == 1) {
    points.push_back(center);
    return;
  }
  for (std::int64_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    points.push_back(center + radius * Vec3(std::cos(angle), std::sin(angle), 0));
  }
}

// Rings of latitude, half a step from the poles.
void add_shell(std::vector<Vec3>& points, const Vec3& center, double radius, double dx) {
  std::int64_t m = cells(std::numbers::pi * radius, dx);
  while (m > 1 && 2 * radius * std::sin(0.5 * std::numbers::pi / static_cast<double>(m)) < 0.75 * dx) --m;
  for (std::int64_t i = 0; i < m; ++i) {
    const double latitude = std::numbers::pi * ((static_cast<double>(i) + 0.5) / static_cast<double>(m) - 0.5);
    const Vec3 ring_center = center + Vec3(0, 0, radius * std::sin(latitude));
    add_ring(points, ring_center, radius * std::cos(latitude), dx);
  }
}

std::vector<Vec3> sample_shape(const Round& round, int dimension, double dx, int layers) {
  std::vector<Vec3> points;
  const double sense = round.solid == Face::inside ? -1 : 1;
  for (int k = 0; k < layers; ++k) {
    const double radius = round.radius + sense * (k + 0.5) * dx;
    if (radius < 0) break;
    if (dimension == 2) {
      add_ring(points, round.center, radius, dx);
    } else {
      add_shell(points, round.center, radius, dx);
    }
  }
  return points;
}

}  // namespace

std::vector<Vec3> sample_wall(const Wall& wall, int dimension, double dx, int layers) {
  std::vector<Vec3> points =
      std::visit([&](const auto& each) { return sample_shape(each, dimension, dx, layers); }, wall.shape);
  std::erase_if(points, [&](const Vec3& point) {
    return std::any_of(wall.holes.begin(), wall.holes.end(),
                       [&](const Shape& hole) { return inside(hole, point, dimension); });
  });
  return points;
}

}  // namespace weir
