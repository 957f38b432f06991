// Volumes and walls, each by itself, and their number of particles.
#include <algorithm>
#include <cmath>

#include "scene/checker.h"
#include "scene/geometry.h"
#include "scene/memory.h"
#include "scene/paths.h"
#include "scene/span.h"

namespace weir {

namespace {

// Coordinates up to this many spacings are exact in double precision to a millionth of the spacing.
constexpr double max_spacings = 1e-6 * 4503599627370496.0;  // 1e-6 2^52
// Fluid and walls may span 2^20 of the solver's tiles, of 16 spacings each.
constexpr double max_span = 1048576.0 * 16;
// Keeps the comparison of all pairs of edges, and of every wall particle with every edge, short.
constexpr std::size_t max_points = 10000;
// Keeps the comparison of all pairs of volumes short.
constexpr std::size_t max_shapes = 10000;
// Particle indices are 32 bits wide.
constexpr double max_particles = 2147483647.0;

constexpr std::string_view axes = "xyz";

void check_reach(Checker& checker, const Vec3& point, double radius, const std::string& path) {
  if (!checker.usable(path, "particles.spacing")) return;
  const double dx = checker.scene.particle_spacing;
  const double reach = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)}) + radius;
  if (reach <= max_spacings * dx) return;
  checker.add(path, fmt::format("reaches {:.6g} m from the origin; at a spacing of {} m, positions are exact to a "
                                "millionth of it only up to {:.3g} m",
                                reach, number_text(dx), max_spacings * dx));
}

class ShapeRules {
 public:
  ShapeRules(Checker& checker, std::string path) : checker_(checker), path_(std::move(path)) {}

  void operator()(const Box& box) { corners(box.min, box.max); }
  void operator()(const Ball& ball) { within_reach(ball.center, ball.radius); }
  void operator()(const Polygon& polygon) {
    if (flat_only() && few(polygon.points)) simple(polygon.points);
  }
  void operator()(const Tank& tank) {
    corners(tank.min, tank.max);
    for (const Side side : tank.open) {
      if (checker_.scene.dimension == 2 && (side == Side::front || side == Side::back)) {
        checker_.add(path_ + ".open", "names front or back; a 2D tank has left, right, bottom and top");
      }
    }
    thick_enough(tank.min, tank.max);
  }
  void operator()(const Block& block) { corners(block.min, block.max); }
  void operator()(const Polyline& line) {
    if (flat_only() && few(line.points) && distinct(line.points, line.closed) && line.closed) simple(line.points);
  }
  void operator()(const PolygonWall& polygon) {
    if (flat_only() && few(polygon.points) && distinct(polygon.points, true)) simple(polygon.points);
  }
  void operator()(const Round& round) { within_reach(round.center, round.radius); }

  // At least one particle along each axis.
  void thick_enough(const Vec3& min, const Vec3& max) {
    if (!checker_.usable(path_, "particles.spacing")) return;
    for (int axis = 0; axis < checker_.scene.dimension; ++axis) {
      const double size = max[axis] - min[axis];
      if (size < checker_.scene.particle_spacing * (1 - 1e-6)) {
        return checker_.add(path_, fmt::format("is smaller than a particle along {}: {:.6g} m at a spacing of {} m",
                                               axes[static_cast<std::size_t>(axis)], size,
                                               number_text(checker_.scene.particle_spacing)));
      }
    }
  }

 private:
  bool flat_only() {
    if (checker_.scene.dimension == 2) return true;
    checker_.add(path_, "is a shape of 2D scenes");
    return false;
  }
  bool few(const std::vector<Vec3>& points) {
    for (const Vec3& point : points) within_reach(point, 0);
    if (points.size() > max_points) {
      checker_.add(path_ + ".points", fmt::format("has {} points; at most {} are read", points.size(), max_points));
    }
    return checker_.usable(path_);
  }
  void corners(const Vec3& min, const Vec3& max) {
    within_reach(min, 0);
    within_reach(max, 0);
    for (int axis = 0; axis < checker_.scene.dimension; ++axis) {
      if (min[axis] < max[axis]) continue;
      return checker_.add(path_ + ".max", fmt::format("must lie above min along {}: min is {}, max is {}",
                                                      axes[static_cast<std::size_t>(axis)], number_text(min[axis]),
                                                      number_text(max[axis])));
    }
  }
  // Too near for particles to resolve; a segment between such points has no computable direction.
  bool coincide(const Vec3& a, const Vec3& b) const {
    const double spacing = checker_.usable("particles.spacing") ? checker_.scene.particle_spacing : 0;
    return glm::length(a - b) <= 1e-6 * spacing;
  }
  // Whether each piece between the points has a direction.
  bool distinct(const std::vector<Vec3>& points, bool closed) {
    const std::size_t n = points.size();
    for (std::size_t i = 1; i < n; ++i) {
      if (!coincide(points[i], points[i - 1])) continue;
      checker_.add(fmt::format("{}.points.{}", path_, i), "repeats the point before it");
      return false;
    }
    if (!closed) return true;
    if (corners_of(points) < 3) {
      checker_.add(path_ + ".points", "needs at least 3 points to close");
      return false;
    }
    // A repeated first point also closes the line; a point close to it makes a segment without direction.
    if (points[n - 1] == points[0] || !coincide(points[n - 1], points[0])) return true;
    checker_.add(fmt::format("{}.points.{}", path_, n - 1), "repeats the first point");
    return false;
  }
  // Of a ring, whose last point may be the first again.
  static std::size_t corners_of(const std::vector<Vec3>& points) {
    return points.size() > 1 && points.front() == points.back() ? points.size() - 1 : points.size();
  }
  void within_reach(const Vec3& point, double radius) { check_reach(checker_, point, radius, path_); }
  void simple(const std::vector<Vec3>& points) {
    const std::size_t n = corners_of(points);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 2; j < n; ++j) {
        if (i == 0 && j == n - 1) continue;  // neighbours around the end
        if (segments_cross(points[i], points[i + 1], points[j], points[(j + 1) % n])) {
          return checker_.add(path_ + ".points",
                              fmt::format("makes edges that cross: those from points {} and {}", i, j));
        }
      }
    }
    if (std::abs(signed_area(points)) == 0) checker_.add(path_ + ".points", "lie on one line and enclose nothing");
  }

  Checker& checker_;
  std::string path_;
};

void check_volume(Checker& checker, const Volume& volume, const std::string& path) {
  ShapeRules rules(checker, path);
  std::visit(rules, volume.shape);
  if (!checker.usable(path, "particles.spacing")) return;
  const double dx = checker.scene.particle_spacing;
  if (const auto* box = std::get_if<Box>(&volume.shape)) return rules.thick_enough(box->min, box->max);
  if (measure(volume.shape, checker.scene.dimension) < 0.5 * std::pow(dx, checker.scene.dimension)) {
    checker.add(path, fmt::format("is smaller than a particle at a spacing of {} m", number_text(dx)));
  }
}

void check_wall(Checker& checker, const Wall& wall, const std::string& path) {
  std::visit(ShapeRules(checker, path), wall.shape);
  for (std::size_t i = 0; i < wall.holes.size(); ++i) {
    std::visit(
        ShapeRules(checker, shape_path(fmt::format("{}.holes.{}", path, i), wall.holes[i], checker.scene.dimension)),
        wall.holes[i]);
  }
}

void check_number(Checker& checker) {
  const Scene& scene = checker.scene;
  double count = 0;
  for (std::size_t i = 0; i < scene.fluid.volumes.size(); ++i) {
    if (checker.usable(volume_path(i))) count += expected_particles(scene, scene.fluid.volumes[i]);
  }
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    if (checker.usable(wall_path(i))) count += expected_particles(scene, scene.walls[i]);
  }
  const double memory = count * bytes_per_particle(scene);
  const double limit = std::min(available_memory(), max_particles * bytes_per_particle(scene));
  if (memory <= limit) return;
  const double spacing = scene.particle_spacing * std::pow(memory / limit, 1.0 / scene.dimension);
  const std::string way_out =
      std::isfinite(spacing) ? fmt::format("choose at least {:.2g} m", 1.1 * spacing) : "choose more";
  if (count > max_particles) {
    checker.add("particles.spacing", fmt::format("of {} m makes about {:.2g} particles, more than can be counted; {}",
                                                 number_text(scene.particle_spacing), count, way_out));
  } else {
    checker.add("particles.spacing",
                fmt::format("of {} m makes about {:.2g} particles, which need {:.2g} GB; {:.2g} GB are free; {}",
                            number_text(scene.particle_spacing), count, memory / 1e9, limit / 1e9, way_out));
  }
}

void check_span(Checker& checker) {
  const Scene& scene = checker.scene;
  if (!checker.usable("fluid.volumes", "walls", "domain", "particles.spacing")) return;
  const Bounds span = scene.domain ? around(scene_span(scene), *scene.domain) : scene_span(scene);
  for (int axis = 0; axis < scene.dimension; ++axis) {
    const double length = span.max[axis] - span.min[axis];
    if (!(length > max_span * scene.particle_spacing)) continue;
    return checker.add("particles.spacing",
                       fmt::format("of {} m: fluid and walls span {:.6g} m along {}, more than {:.0f} spacings; choose "
                                   "at least {:.2g} m",
                                   number_text(scene.particle_spacing), length, axes[static_cast<std::size_t>(axis)],
                                   max_span, 1.1 * length / max_span));
  }
}

template <class T>
bool few_enough(Checker& checker, const std::vector<T>& shapes, const std::string& path) {
  if (shapes.size() <= max_shapes) return true;
  checker.add(path, fmt::format("holds {} shapes; at most {} are read", shapes.size(), max_shapes));
  return false;
}

}  // namespace

void check_geometry(Checker& checker) {
  const Scene& scene = checker.scene;
  if (!few_enough(checker, scene.fluid.volumes, "fluid.volumes")) return;
  if (!few_enough(checker, scene.walls, "walls")) return;
  for (std::size_t i = 0; i < scene.fluid.volumes.size(); ++i) {
    if (checker.usable(volume_path(i))) check_volume(checker, scene.fluid.volumes[i], volume_path(scene, i));
  }
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    if (checker.usable(wall_path(i))) check_wall(checker, scene.walls[i], wall_path(scene, i));
  }
  if (scene.domain) {
    check_reach(checker, scene.domain->min, 0, "domain");
    check_reach(checker, scene.domain->max, 0, "domain");
  }
  if (checker.usable("particles.spacing", "solver.kernel")) check_number(checker);
  check_span(checker);
}

}  // namespace weir
