// Particles of one wall: layers of spacing dx behind its faces.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/geometry.h"
#include "scene/sample_polyline.h"
#include "scene/sampling.h"
#include "scene/tank_sides.h"

namespace weir {

namespace {

std::int64_t cells(double length, double dx) { return std::max<std::int64_t>(1, std::llround(length / dx)); }

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

void clip(GridAxis& axis, double min, double max) {
  GridAxis kept;
  for (std::size_t i = 0; i < axis.centers.size(); ++i) {
    if (axis.centers[i] < min || axis.centers[i] > max) continue;
    kept.centers.push_back(axis.centers[i]);
    kept.depths.push_back(axis.depths[i]);
  }
  axis = std::move(kept);
}

// All centres of the grid that are in the wall along at least one axis. A row inside along the other two is not walked
// through: of a large block only the skin is looked at.
void visit_grid(Grid grid, const Bounds& region, const VisitPoint& visit) {
  auto& axes = grid.axes;
  for (int axis = 0; axis < 3; ++axis) {
    clip(axes[static_cast<std::size_t>(axis)], region.min[axis], region.max[axis]);
  }
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
        visit(Vec3(axes[0].centers[x], axes[1].centers[y], axes[2].centers[z]));
      }
    }
  }
}

std::int64_t count_grid(const Grid& grid) {
  std::int64_t all = 1;
  std::int64_t core = 1;
  for (const GridAxis& axis : grid.axes) {
    all *= static_cast<std::int64_t>(axis.depths.size());
    core *= std::count_if(axis.depths.begin(), axis.depths.end(), [&](auto depth) { return !grid.in_wall(depth); });
  }
  return all - core;
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

void visit_ring(const Vec3& center, double radius, double dx, const Bounds& region, const VisitPoint& visit) {
  if (center.z < region.min.z || center.z > region.max.z) return;
  const std::int64_t n = ring_count(radius, dx);
  for (std::int64_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
    const Vec3 point = n == 1 ? center : center + radius * Vec3(std::cos(angle), std::sin(angle), 0);
    if (contains(region, point)) visit(point);
  }
}

// Calls visit(centre, radius) for each ring: one a layer in 2D; in 3D rings of latitude, half a step from the poles.
template <class Visit>
void for_rings(const Round& round, int dimension, double dx, int layers, Visit visit) {
  const double sense = round.solid == Face::inside ? -1 : 1;
  for (int k = 0; k < layers; ++k) {
    const double radius = round.radius + sense * (k + 0.5) * dx;
    if (radius < 0) break;
    if (dimension == 2) {
      visit(round.center, radius);
      continue;
    }
    std::int64_t m = cells(std::numbers::pi * radius, dx);
    while (m > 1 && 2 * radius * std::sin(0.5 * std::numbers::pi / static_cast<double>(m)) < 0.75 * dx) --m;
    for (std::int64_t i = 0; i < m; ++i) {
      const double latitude = std::numbers::pi * ((static_cast<double>(i) + 0.5) / static_cast<double>(m) - 0.5);
      visit(round.center + Vec3(0, 0, radius * std::sin(latitude)), radius * std::cos(latitude));
    }
  }
}

// A wall without regard to its holes: its particles in a region, and their number.
class Solid {
 public:
  Solid(int dimension, double dx, int layers) : dimension_(dimension), dx_(dx), layers_(layers) {}

  template <class Cuboid>
  void visit(const Cuboid& cuboid, const Bounds& region, const VisitPoint& visit) const {
    visit_grid(grid_of(cuboid, dimension_, dx_, layers_), region, visit);
  }
  void visit(const Polyline& line, const Bounds& region, const VisitPoint& visit) const {
    for (const Vec3& point : sample_polyline(line, dx_, layers_)) {
      if (contains(region, point)) visit(point);
    }
  }
  void visit(const Round& round, const Bounds& region, const VisitPoint& visit) const {
    for_rings(round, dimension_, dx_, layers_,
              [&](const Vec3& center, double radius) { visit_ring(center, radius, dx_, region, visit); });
  }

  template <class Cuboid>
  std::int64_t count(const Cuboid& cuboid) const {
    return count_grid(grid_of(cuboid, dimension_, dx_, layers_));
  }
  std::int64_t count(const Polyline& line) const {
    return static_cast<std::int64_t>(sample_polyline(line, dx_, layers_).size());
  }
  std::int64_t count(const Round& round) const {
    std::int64_t sum = 0;
    for_rings(round, dimension_, dx_, layers_, [&](const Vec3&, double radius) { sum += ring_count(radius, dx_); });
    return sum;
  }

 private:
  int dimension_;
  double dx_;
  int layers_;
};

bool in_hole(const Wall& wall, const Vec3& point, int dimension) {
  return std::any_of(wall.holes.begin(), wall.holes.end(),
                     [&](const Shape& hole) { return inside(hole, point, dimension); });
}

// A shape of 2D is flat; what is asked of it in space must not miss it for its lack of depth.
Bounds hole_bounds(const Wall& wall, int dimension) {
  Bounds all = empty_bounds;
  for (const Shape& hole : wall.holes) all = around(all, shape_bounds(hole, dimension));
  if (dimension == 2) {
    all.min.z = everywhere.min.z;
    all.max.z = everywhere.max.z;
  }
  return all;
}

}  // namespace

void visit_wall(const Wall& wall, int dimension, double dx, int layers, const Bounds& region, const VisitPoint& visit) {
  const auto outside_holes = [&](const Vec3& point) {
    if (!in_hole(wall, point, dimension)) visit(point);
  };
  const Solid solid(dimension, dx, layers);
  std::visit([&](const auto& each) { solid.visit(each, region, outside_holes); }, wall.shape);
}

std::int64_t count_wall(const Wall& wall, int dimension, double dx, int layers) {
  const Solid solid(dimension, dx, layers);
  return std::visit(
      [&](const auto& each) {
        std::int64_t count = solid.count(each);
        if (wall.holes.empty()) return count;
        solid.visit(each, hole_bounds(wall, dimension), [&](const Vec3& point) {
          if (in_hole(wall, point, dimension)) --count;
        });
        return count;
      },
      wall.shape);
}

std::vector<Vec3> sample_wall(const Wall& wall, int dimension, double dx, int layers) {
  std::vector<Vec3> points;
  visit_wall(wall, dimension, dx, layers, everywhere, [&](const Vec3& point) { points.push_back(point); });
  return points;
}

}  // namespace weir
