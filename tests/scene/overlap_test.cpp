// Volumes and walls against each other: the check says what a comparison of all particles says.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "scene/checker.h"
#include "scene/geometry.h"
#include "scene/paths.h"
#include "scene/point_grid.h"
#include "scene/sampling.h"

namespace weir {
namespace {

constexpr double dx = 0.1;
constexpr double too_near = 0.49 * dx;
constexpr double slack = 1e-6 * dx;

// ---- the same check by comparing all particles --------------------------------------------------------------------

bool holds(const Wall& wall, const Vec3& point, int dimension, bool solid) {
  if (const auto* tank = std::get_if<Tank>(&wall.shape)) {
    if (solid || !tank->open.empty()) return false;
    return inside(Box{tank->min - slack, tank->max + slack}, point, dimension);
  }
  if (const auto* block = std::get_if<Block>(&wall.shape)) {
    return solid && inside(Box{block->min, block->max}, point, dimension);
  }
  if (const auto* round = std::get_if<Round>(&wall.shape)) {
    return solid == (round->solid == Face::inside) && inside(Ball{round->center, round->radius}, point, dimension);
  }
  if (const auto* polygon = std::get_if<PolygonWall>(&wall.shape)) {
    return solid == (polygon->solid == Face::inside) && inside(Polygon{polygon->points}, point, dimension);
  }
  const auto& line = std::get<Polyline>(wall.shape);
  const bool solid_inside = (signed_area(line.points) > 0) == (line.solid == Flank::left);
  return line.closed && solid == solid_inside && inside(Polygon{line.points}, point, dimension);
}

bool closed_container(const Wall& wall) {
  if (!wall.holes.empty()) return false;
  if (const auto* tank = std::get_if<Tank>(&wall.shape)) return tank->open.empty();
  if (const auto* round = std::get_if<Round>(&wall.shape)) return round->solid == Face::outside;
  if (const auto* polygon = std::get_if<PolygonWall>(&wall.shape)) return polygon->solid == Face::outside;
  const auto* line = std::get_if<Polyline>(&wall.shape);
  return line != nullptr && line->closed && (signed_area(line->points) > 0) != (line->solid == Flank::left);
}

bool any_in(const std::vector<Vec3>& points, const Shape& shape, int dimension) {
  return std::any_of(points.begin(), points.end(), [&](const Vec3& point) { return inside(shape, point, dimension); });
}

bool overlap(const Shape& a, const std::vector<Vec3>& of_a, const Shape& b, const std::vector<Vec3>& of_b,
             int dimension) {
  if (apart(shape_bounds(a, dimension), shape_bounds(b, dimension), dimension, slack)) return false;
  const bool boxes = std::holds_alternative<Box>(a) && std::holds_alternative<Box>(b);
  return boxes || any_in(of_a, b, dimension) || any_in(of_b, a, dimension);
}

std::vector<std::string> mistakes_by_particles(const Scene& scene) {
  const int dimension = scene.dimension;
  std::vector<std::string> all;
  std::vector<std::vector<Vec3>> samples;
  PointGrid fluid(too_near);
  PointGrid walls(too_near);
  for (std::size_t w = 0; w < scene.walls.size(); ++w) {
    for (const Vec3& point : sample_wall(scene.walls[w], dimension, dx, wall_layers(scene, scene.walls[w]))) {
      walls.add(point, static_cast<std::int32_t>(w));
    }
  }
  for (std::size_t i = 0; i < scene.fluid.volumes.size(); ++i) {
    const Shape& shape = scene.fluid.volumes[i].shape;
    const std::string path = volume_path(scene, i);
    const std::vector<Vec3> points = sample_volume(shape, dimension, dx);
    std::vector<bool> met(i);
    for (std::size_t other = 0; other < i; ++other) {
      met[other] = overlap(shape, points, scene.fluid.volumes[other].shape, samples[other], dimension);
    }
    std::vector<bool> in_wall(scene.walls.size());
    std::size_t outside = 0;
    Vec3 first(0);
    for (const Vec3& point : points) {
      fluid.any_near(point, too_near, [&](std::int32_t other, const Vec3&) {
        met[static_cast<std::size_t>(other)] = true;
        return false;
      });
      walls.any_near(point, too_near, [&](std::int32_t wall, const Vec3&) {
        in_wall[static_cast<std::size_t>(wall)] = true;
        return false;
      });
      bool held = false;
      for (std::size_t w = 0; w < scene.walls.size(); ++w) {
        const Wall& wall = scene.walls[w];
        held = held || (closed_container(wall) && holds(wall, point, dimension, false));
        if (!holds(wall, point, dimension, true)) continue;
        const bool in_hole = std::any_of(wall.holes.begin(), wall.holes.end(),
                                         [&](const Shape& hole) { return inside(hole, point, dimension); });
        if (!in_hole) in_wall[w] = true;
      }
      if (!held && outside++ == 0) first = point;
    }
    samples.push_back(points);
    const auto number = std::count(met.begin(), met.end(), true);
    if (number > 0) {
      const auto lowest = static_cast<std::size_t>(std::find(met.begin(), met.end(), true) - met.begin());
      all.push_back(fmt::format("{} overlaps {}{}", path, volume_path(scene, lowest),
                                number > 1 ? fmt::format(" and {} more", number - 1) : ""));
    } else {
      for (const Vec3& point : points) fluid.add(point, static_cast<std::int32_t>(i));
    }
    for (std::size_t w = 0; w < scene.walls.size(); ++w) {
      if (in_wall[w]) all.push_back(fmt::format("{} reaches into {}", path, wall_path(scene, w)));
    }
    if (outside > 0 && std::any_of(scene.walls.begin(), scene.walls.end(), closed_container)) {
      all.push_back(fmt::format("{} lies outside the closed walls: {} of {} particles, such as at {}", path, outside,
                                points.size(), point_text(first, dimension)));
    }
  }
  return all;
}

// ---- random scenes ------------------------------------------------------------------------------------------------

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  bool one_in(unsigned n) { return random_() % n == 0; }
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  // Often a whole number of half or full spacings, so that shapes share faces and lattices.
  double between(double low, double high) {
    const double value = low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
    const int kind = below(4);
    return kind == 0 ? std::round(value / dx) * dx : kind == 1 ? std::round(value / (dx / 2)) * (dx / 2) : value;
  }
  Vec3 point(int dimension, double low, double high) {
    const double x = between(low, high);
    const double y = between(low, high);
    return {x, y, dimension == 3 ? between(low, high) : 0};
  }

 private:
  std::mt19937 random_;
};

std::vector<Vec3> star(Dice& dice, const Vec3& center, double size) {
  std::vector<Vec3> points;
  const int n = 3 + dice.below(6);
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * i / n;
    points.push_back(center + size * dice.between(0.3, 1) * Vec3(std::cos(angle), std::sin(angle), 0));
  }
  if (dice.one_in(2)) std::reverse(points.begin(), points.end());
  return points;
}

Box box(Dice& dice, int dimension, double least, double most) {
  const Vec3 min = dice.point(dimension, -1, 1);
  return {min, min + dice.point(dimension, least, most)};
}

Shape shape(Dice& dice, int dimension) {
  const int kind = dice.below(dimension == 2 ? 3 : 2);
  if (kind == 0) return box(dice, dimension, 0.1, 1.2);
  const Vec3 center = dice.point(dimension, -1, 1);
  if (kind == 1) return Ball{center, dice.between(0.1, 0.8)};
  return Polygon{star(dice, center, dice.between(0.3, 1))};
}

WallShape wall_shape(Dice& dice, int dimension) {
  switch (dice.below(dimension == 2 ? 6 : 4)) {
    case 0: {
      const Box inner = box(dice, dimension, 0.2, 1.5);
      return Tank{inner.min, inner.max, dice.one_in(2) ? std::vector<Side>{Side::top} : std::vector<Side>{}};
    }
    case 1: {
      const Box around{Vec3(-1, -1, dimension == 3 ? -1 : 0), Vec3(2, 2, dimension == 3 ? 2 : 0)};
      return Tank{around.min, around.max, dice.one_in(2) ? std::vector<Side>{Side::left} : std::vector<Side>{}};
    }
    case 2: {
      const Box solid = box(dice, dimension, 0.03, 1);
      return Block{solid.min, solid.max};
    }
    case 3:
      return Round{dice.point(dimension, -1, 1), dice.between(0.1, 2), dice.one_in(2) ? Face::inside : Face::outside};
    case 4:
      return PolygonWall{star(dice, dice.point(dimension, -1, 1), dice.between(0.5, 2)),
                         dice.one_in(2) ? Face::inside : Face::outside};
    default:
      return Polyline{star(dice, dice.point(dimension, -1, 1), dice.between(0.5, 2)), dice.one_in(2),
                      dice.one_in(2) ? Flank::left : Flank::right};
  }
}

Scene random_scene(unsigned seed, int dimension) {
  Dice dice(seed);
  Scene scene;
  scene.name = "scene";
  scene.dimension = dimension;
  scene.duration = 1;
  scene.particle_spacing = dx;
  for (int i = 1 + dice.below(4); i > 0; --i) scene.fluid.volumes.push_back({shape(dice, dimension), Vec3(0), Vec3(0)});
  for (int i = dice.below(4); i > 0; --i) {
    Wall wall{wall_shape(dice, dimension), dice.below(4), {}};
    if (dice.one_in(4)) wall.holes.push_back(shape(dice, dimension));
    if (dice.one_in(8)) wall.holes.push_back(shape(dice, dimension));
    scene.walls.push_back(std::move(wall));
  }
  return scene;
}

// Whether each shape by itself is valid; else overlaps are not checked.
bool usable(const std::vector<Violation>& violations) {
  return std::none_of(violations.begin(), violations.end(), [](const Violation& violation) {
    const std::string& text = violation.message;
    return !text.starts_with("overlaps") && !text.starts_with("reaches into") &&
           !text.starts_with("lies outside the closed walls");
  });
}

void compare(int dimension, unsigned scenes) {
  std::size_t compared = 0;
  std::size_t wrong = 0;
  for (unsigned seed = 0; seed < scenes; ++seed) {
    const Scene scene = random_scene(seed, dimension);
    const std::vector<Violation> violations = check(scene);
    if (!usable(violations)) continue;
    std::vector<std::string> said;
    for (const Violation& violation : violations) said.push_back(violation.path + " " + violation.message);
    EXPECT_EQ(said, mistakes_by_particles(scene)) << "seed " << seed;
    ++compared;
    if (!said.empty()) ++wrong;
  }
  EXPECT_GT(compared, scenes / 2);
  EXPECT_GT(wrong, compared / 4);
  EXPECT_LT(wrong, compared);
}

TEST(Overlap, CheckAgreesWithAllParticlesCompared) { compare(2, 2000); }
TEST(Overlap, CheckAgreesWithAllParticlesComparedIn3D) { compare(3, 200); }

}  // namespace
}  // namespace weir
