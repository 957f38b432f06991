// Numbers and positions of particles against closed formulas; spacings for all walls that shipped scenes are made of.
#include "scene/sampling.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "scene/geometry.h"
#include "scene/point_grid.h"

namespace weir {
namespace {

constexpr double dx = 0.1;

Scene scene_with(std::vector<Wall> walls, int dimension = 2) {
  Scene scene;
  scene.dimension = dimension;
  scene.duration = 1;
  scene.particle_spacing = dx;
  scene.walls = std::move(walls);
  return scene;
}

// Least distance of two of the points, in dx; at most 2.
double least_distance(const std::vector<Vec3>& points) {
  PointGrid grid(2 * dx);
  double least = 2 * dx;
  for (const Vec3& point : points) {
    grid.any_near(point, least, [&](std::int32_t, const Vec3& other) {
      least = std::min(least, glm::length(point - other));
      return false;
    });
    grid.add(point, 0);
  }
  return least / dx;
}

double distance_to_nearest(const std::vector<Vec3>& points, const Vec3& from) {
  double least = 1e300;
  for (const Vec3& point : points) least = std::min(least, glm::length(point - from));
  return least;
}

// The widest hole in the first layer behind a face: the largest distance, in dx, from a point on the layer's middle
// line to the nearest wall particle. Particles `gap` apart on the line leave gap / 2.
double widest_gap(const std::vector<Vec3>& walls, const Vec3& from, const Vec3& to) {
  double widest = 0;
  const int steps = std::max(1, static_cast<int>(50 * glm::length(to - from) / dx));
  for (int i = 0; i <= steps; ++i) {
    widest = std::max(widest, distance_to_nearest(walls, from + (to - from) * (double(i) / steps)));
  }
  return 2 * widest / dx;
}

std::vector<Vec3> sorted(std::vector<Vec3> points) {
  for (Vec3& point : points) point = glm::round(point * 1e9) / 1e9 + 0.0;
  std::sort(points.begin(), points.end(),
            [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
  return points;
}

TEST(Sampling, PutsBoxesOnTheLatticeHalfASpacingInside) {
  const std::vector<Vec3> flat = sample_volume(Box{{1, 2, 0}, {1.4, 2.3, 0}}, 2, dx);
  ASSERT_EQ(flat.size(), 12U);
  EXPECT_NEAR(glm::length(flat.front() - Vec3(1.05, 2.05, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::length(flat[1] - Vec3(1.15, 2.05, 0)), 0, 1e-12);
  EXPECT_NEAR(glm::length(flat.back() - Vec3(1.35, 2.25, 0)), 0, 1e-12);
  EXPECT_EQ(sample_volume(Box{{0, 0, 0}, {1.5, 1.5, 1.5}}, 3, dx).size(), 15U * 15U * 15U);
}

TEST(Sampling, RoundsSizesToWholeParticles) {
  EXPECT_EQ(sample_volume(Box{{0, 0, 0}, {0.44, 0.26, 0}}, 2, dx).size(), 4U * 3U);
}

TEST(Sampling, KeepsDiscsAndBallsSymmetricAndTheirMass) {
  for (const double radius : {0.05, 0.2, 0.313, 0.5, 1.0}) {
    for (const int dimension : {2, 3}) {
      const Vec3 center(0.3, -0.2, dimension == 3 ? 0.7 : 0);
      const std::vector<Vec3> points = sample_volume(Ball{center, radius}, dimension, dx);
      std::vector<Vec3> mirrored;
      for (const Vec3& point : points) {
        EXPECT_LT(glm::length(point - center), radius);
        mirrored.push_back(2.0 * center - point);
      }
      EXPECT_EQ(sorted(points), sorted(mirrored)) << radius;
      EXPECT_GT(least_distance(points), 1 - 1e-9);
      // The lattice count differs from the volume by less than one cell for each two cells of the surface.
      const double cells = measure(Ball{center, radius}, dimension) / std::pow(dx, dimension);
      const double surface =
          dimension == 2 ? 2 * std::numbers::pi * radius / dx : 4 * std::numbers::pi * radius * radius / (dx * dx);
      EXPECT_LT(std::abs(static_cast<double>(points.size()) - cells), 0.5 * surface + 1) << radius;
    }
  }
}

TEST(Sampling, FillsPolygonsByCellCentres) {
  // A right triangle of n cells: rows of n - 1, n - 2, ... whole cells below the diagonal; those on it are outside.
  const std::vector<Vec3> triangle = sample_volume(Polygon{{{0, 0, 0}, {1.001, 0, 0}, {0, 1.001, 0}}}, 2, dx);
  EXPECT_EQ(triangle.size(), 55U);  // centres (i + j + 1) dx <= 10 dx: 10 + 9 + ... + 1
  // The same square as a box, in either sense of rotation.
  const std::vector<Vec3> box = sorted(sample_volume(Box{{0.2, 0.1, 0}, {0.8, 0.5, 0}}, 2, dx));
  const std::vector<Vec3> corners{{0.2, 0.1, 0}, {0.8, 0.1, 0}, {0.8, 0.5, 0}, {0.2, 0.5, 0}};
  EXPECT_EQ(sorted(sample_volume(Polygon{corners}, 2, dx)), box);
  EXPECT_EQ(sorted(sample_volume(Polygon{{corners.rbegin(), corners.rend()}}, 2, dx)), box);
}

TEST(Sampling, AgreesWithTheInsideTestOnConcavePolygons) {
  const Polygon star{
      {{0, 0, 0}, {1, 0.413, 0}, {2, 0, 0}, {1.507, 1, 0}, {2.1, 2.03, 0}, {1, 1.4, 0}, {0.1, 2, 0}, {0.613, 1, 0}}};
  std::vector<Vec3> expected;
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 30; ++x) {
      const Vec3 point((x + 0.5) * dx, (y + 0.5) * dx, 0);
      if (inside_polygon(star.points, point)) expected.push_back(point);
    }
  }
  EXPECT_GT(expected.size(), 100U);
  EXPECT_EQ(sorted(sample_volume(star, 2, dx)), sorted(expected));
}

TEST(Sampling, TurnsVolumesAboutTheirCentre) {
  Scene scene = scene_with({});
  scene.fluid.volumes.push_back({Box{{0, 0, 0}, {1, 0.6, 0}}, {2, 3, 0}, {0, 0, 5}});
  const Sampling sampling = sample(scene);
  Vec3 momentum(0);
  for (std::size_t i = 0; i < sampling.fluid_positions.size(); ++i) {
    const Vec3 r = sampling.fluid_positions[i] - Vec3(0.5, 0.3, 0);
    EXPECT_NEAR(glm::length(sampling.fluid_velocities[i] - Vec3(2 - 5 * r.y, 3 + 5 * r.x, 0)), 0, 1e-12);
    momentum += sampling.fluid_velocities[i] - Vec3(2, 3, 0);
  }
  EXPECT_NEAR(glm::length(momentum), 0, 1e-10);
}

TEST(Sampling, GrowsTankLayersOutwardsWithFullCorners) {
  // (nx + 2 L) (ny + 2 L) - nx ny
  const Tank tank{{0, 0, 0}, {1.2, 0.5, 0}, {}};
  for (const int layers : {1, 2, 3}) {
    const std::vector<Vec3> points = sample_wall({tank, layers, {}}, 2, dx, layers);
    EXPECT_EQ(points.size(), static_cast<std::size_t>((12 + 2 * layers) * (5 + 2 * layers) - 60));
    EXPECT_NEAR(distance_to_nearest(points, {-0.05, -0.05, 0}), 0, 1e-12);
    EXPECT_NEAR(distance_to_nearest(points, {1.25, 0.25, 0}), 0, 1e-12);
    EXPECT_GT(least_distance(points), 1 - 1e-9);
  }
  EXPECT_EQ(sample_wall({Tank{{0, 0, 0}, {1, 1, 1}, {}}, 2, {}}, 3, dx, 2).size(), 14U * 14U * 14U - 1000U);
}

TEST(Sampling, LeavesOpenSidesFlushWithTheirNeighbours) {
  const std::vector<Vec3> points = sample_wall({Tank{{0, 0, 0}, {1, 0.5, 0}, {Side::top}}, 2, {}}, 2, dx, 2);
  EXPECT_EQ(points.size(), 14U * 7U - 50U);  // (nx + 2 L) (ny + L) - nx ny
  EXPECT_NEAR(bounds(points).max.y, 0.45, 1e-12);
  // 3D: front and back are -y and +y, bottom and top -z and +z.
  const std::vector<Vec3> box = sample_wall({Tank{{0, 0, 0}, {1, 1, 1}, {Side::front, Side::top}}, 2, {}}, 3, dx, 2);
  EXPECT_NEAR(bounds(box).min.y, 0.05, 1e-12);
  EXPECT_NEAR(bounds(box).max.y, 1.15, 1e-12);
  EXPECT_NEAR(bounds(box).min.z, -0.15, 1e-12);
  EXPECT_NEAR(bounds(box).max.z, 0.95, 1e-12);
}

TEST(Sampling, ReachesBothFacesOfTanksOfAnySize) {
  for (const double size : {0.1, 0.149, 0.151, 0.33, 1.04, 1.06}) {
    const std::vector<Vec3> points = sample_wall({Tank{{0, 0, 0}, {size, size, 0}, {}}, 1, {}}, 2, dx, 1);
    EXPECT_NEAR(bounds(points).min.x, -0.05, 1e-12);
    EXPECT_NEAR(bounds(points).max.x, size + 0.05, 1e-12);
    EXPECT_GT(least_distance(points), 0.75 - 1e-9) << size;
    EXPECT_LT(widest_gap(points, {-0.05, -0.05, 0}, {size + 0.05, -0.05, 0}), 1.5) << size;
  }
}

TEST(Sampling, GrowsBlockLayersInwards) {
  const auto count = [](double size, int layers) {
    return sample_wall({Block{{0, 0, 0}, {size, size, 0}}, layers, {}}, 2, dx, layers).size();
  };
  EXPECT_EQ(count(1, 2), 100U - 36U);
  EXPECT_EQ(count(0.3, 2), 9U);  // full
  const std::vector<Vec3> points = sample_wall({Block{{0, 0, 0}, {1.03, 0.77, 0}}, 2, {}}, 2, dx, 2);
  EXPECT_NEAR(bounds(points).min.x, 0.05, 1e-12);
  EXPECT_NEAR(bounds(points).max.x, 0.98, 1e-12);
  EXPECT_NEAR(bounds(points).max.y, 0.72, 1e-12);
  EXPECT_GT(least_distance(points), 0.75 - 1e-9);
}

TEST(Sampling, GivesAClosedLineTheLayersOfATank) {
  const std::vector<Vec3> closed{{0, 0, 0}, {1.2, 0, 0}, {1.2, 0.5, 0}, {0, 0.5, 0}};
  const std::vector<Vec3> tank = sorted(sample_wall({Tank{{0, 0, 0}, {1.2, 0.5, 0}, {}}, 3, {}}, 2, dx, 3));
  EXPECT_EQ(sorted(sample_wall({Polyline{closed, true, Flank::right}, 3, {}}, 2, dx, 3)), tank);
  const std::vector<Vec3> reversed(closed.rbegin(), closed.rend());
  EXPECT_EQ(sorted(sample_wall({Polyline{reversed, true, Flank::left}, 3, {}}, 2, dx, 3)), tank);
  const std::vector<Vec3> open{{0, 0.5, 0}, {0, 0, 0}, {1.2, 0, 0}, {1.2, 0.5, 0}};
  EXPECT_EQ(sorted(sample_wall({Polyline{open, false, Flank::right}, 2, {}}, 2, dx, 2)),
            sorted(sample_wall({Tank{{0, 0, 0}, {1.2, 0.5, 0}, {Side::top}}, 2, {}}, 2, dx, 2)));
  // Solid inside: a block.
  EXPECT_EQ(sorted(sample_wall({Polyline{closed, true, Flank::left}, 2, {}}, 2, dx, 2)),
            sorted(sample_wall({Block{{0, 0, 0}, {1.2, 0.5, 0}}, 2, {}}, 2, dx, 2)));
}

TEST(Sampling, GivesAPolygonTheLayersOfATankOrABlock) {
  const std::vector<Vec3> square{{0, 0, 0}, {1.2, 0, 0}, {1.2, 0.5, 0}, {0, 0.5, 0}};
  const std::vector<Vec3> reversed(square.rbegin(), square.rend());
  std::vector<Vec3> ring = square;
  ring.push_back(square.front());
  const std::vector<Vec3> tank = sorted(sample_wall({Tank{{0, 0, 0}, {1.2, 0.5, 0}, {}}, 3, {}}, 2, dx, 3));
  const std::vector<Vec3> block = sorted(sample_wall({Block{{0, 0, 0}, {1.2, 0.5, 0}}, 2, {}}, 2, dx, 2));
  for (const std::vector<Vec3>& points : {square, reversed, ring}) {
    EXPECT_EQ(sorted(sample_wall({PolygonWall{points, Face::outside}, 3, {}}, 2, dx, 3)), tank);
    EXPECT_EQ(sorted(sample_wall({PolygonWall{points, Face::inside}, 2, {}}, 2, dx, 2)), block);
  }
}

TEST(Sampling, FillsAPolygonThinnerThanItsLayersOnce) {
  for (const double width : {0.1, 0.2, 0.3, 0.4, 0.5}) {
    const std::vector<Vec3> points{{0, 0, 0}, {width, 0, 0}, {width, 1, 0}, {0, 1, 0}};
    const std::vector<Vec3> all = sample_wall({PolygonWall{points, Face::inside}, 8, {}}, 2, dx, 8);
    EXPECT_EQ(all.size(), static_cast<std::size_t>(std::llround(width / dx)) * 10) << width;
    EXPECT_GE(least_distance(all), 1 - 1e-9) << width;
  }
  for (double width = 0.1; width < 0.6; width += 0.01) {
    const std::vector<Vec3> points{{0, 0, 0}, {2, 0, 0}, {2, width, 0}, {0, width, 0}};
    const std::vector<Vec3> all = sample_wall({PolygonWall{points, Face::inside}, 8, {}}, 2, dx, 8);
    EXPECT_GE(least_distance(all), wall_merge_distance) << width;
    for (const Vec3& point : all) EXPECT_TRUE(inside_polygon(points, point)) << width;
  }
  EXPECT_TRUE(sample_wall({PolygonWall{{{0, 0, 0}, {2, 0, 0}, {2, 0.09, 0}}, Face::inside}, 8, {}}, 2, dx, 8).empty());
}

// All particles lie half a spacing or more behind the outline, on its solid side, and no gap opens along it.
TEST(Sampling, FollowsAPolygonWithCornersOfBothSenses) {
  const std::vector<Vec3> arrow{{0, 0, 0}, {2, 0.4, 0}, {3, 2.5, 0}, {1.4, 1.5, 0}, {-0.5, 2, 0}};
  for (const Face solid : {Face::inside, Face::outside}) {
    const std::vector<Vec3> points = sample_wall({PolygonWall{arrow, solid}, 3, {}}, 2, dx, 3);
    EXPECT_GE(least_distance(points), wall_merge_distance);
    for (const Vec3& point : points) {
      EXPECT_EQ(inside_polygon(arrow, point), solid == Face::inside);
      double distance = 1e9;
      for (std::size_t i = 0; i < arrow.size(); ++i) {
        distance = std::min(distance, distance_to_segment(point, arrow[i], arrow[(i + 1) % arrow.size()]));
      }
      EXPECT_GE(distance, 0.5 * dx - 1e-6);
    }
    for (std::size_t i = 0; i < arrow.size(); ++i) {
      for (int k = 20; k <= 80; ++k) {  // within a sharp corner no particle fits
        const Vec3 on_edge = arrow[i] + 0.01 * k * (arrow[(i + 1) % arrow.size()] - arrow[i]);
        EXPECT_LE(distance_to_nearest(points, on_edge), std::hypot(0.75, 0.5) * dx) << i << " at " << k;
      }
    }
  }
}

TEST(Sampling, FollowsCornersOfAnyAngleWithoutGapsOrCrowding) {
  for (int degrees = -170; degrees <= 170; degrees += 10) {
    const double turn = degrees * std::numbers::pi / 180;
    const Polyline line{
        {{0, 0, 0}, {1.5, 0, 0}, {1.5 + 1.5 * std::cos(turn), 1.5 * std::sin(turn), 0}}, false, Flank::right};
    const std::vector<Vec3> points = sample_wall({line, 3, {}}, 2, dx, 3);
    EXPECT_GE(least_distance(points), wall_merge_distance) << degrees;
    // Nothing nearer to the line than half a spacing, whatever the corner: the fluid's side stays free.
    for (const Vec3& point : points) {
      const double distance = std::min(distance_to_segment(point, line.points[0], line.points[1]),
                                       distance_to_segment(point, line.points[1], line.points[2]));
      EXPECT_GT(distance, 0.5 * dx - 1e-6) << degrees;
    }
    // Seen from the line: the nearest wall particle is never further than half a gap of 1.5 dx and half a layer. A
    // corner that is sharper than a right angle inwards is narrower than a particle at its tip.
    const double reach = std::hypot(0.75, 0.5) * dx;
    for (int k = 0; k <= 150; ++k) {
      if (degrees < -90 && k > 100) break;
      EXPECT_LE(distance_to_nearest(points, {0.01 * k, 0, 0}), reach) << degrees << " at " << 0.01 * k;
    }
  }
}

TEST(Sampling, KeepsApartTheParticlesOfALineOfManyCorners) {
  Polyline line;
  for (int i = 0; i < 500; ++i) line.points.emplace_back(0.001 * i, 0.01 * (i % 2), 0);
  const std::vector<Vec3> points = sample_wall({line, 100, {}}, 2, dx, 100);
  EXPECT_GE(least_distance(points), wall_merge_distance);
}

TEST(Sampling, PutsRoundWallsOnRings) {
  for (const double radius : {0.05, 0.12, 0.3, 0.55, 1.0, 3.0}) {
    for (const Face solid : {Face::inside, Face::outside}) {
      const std::vector<Vec3> points = sample_wall({Round{{1, 2, 0}, radius, solid}, 2, {}}, 2, dx, 2);
      for (const Vec3& point : points) {
        const double depth = (glm::length(point - Vec3(1, 2, 0)) - radius) * (solid == Face::inside ? -1 : 1);
        EXPECT_GT(depth, 0.5 * dx - 1e-9);
      }
      EXPECT_GE(least_distance(points), wall_merge_distance) << radius;
      const double first = radius + (solid == Face::inside ? -0.5 : 0.5) * dx;
      for (int i = 0; i < 720 && first > 0.5 * dx; ++i) {
        const double angle = i * std::numbers::pi / 360;
        EXPECT_LE(2 * distance_to_nearest(points, Vec3(1, 2, 0) + first * Vec3(std::cos(angle), std::sin(angle), 0)),
                  1.5 * dx)
            << radius;
      }
    }
  }
  // A ring's count is its length in dx.
  const std::vector<Vec3> ring = sample_wall({Round{{0, 0, 0}, 3, Face::outside}, 1, {}}, 2, dx, 1);
  EXPECT_EQ(ring.size(), static_cast<std::size_t>(std::llround(2 * std::numbers::pi * 3.05 / dx)));
}

TEST(Sampling, PutsBallsOnShells) {
  for (const double radius : {0.05, 0.12, 0.3, 1.0}) {
    const std::vector<Vec3> points = sample_wall({Round{{1, 2, 3}, radius, Face::outside}, 2, {}}, 3, dx, 2);
    EXPECT_GE(least_distance(points), wall_merge_distance) << radius;
    const double shell = radius + 0.5 * dx;
    std::size_t first_layer = 0;
    for (const Vec3& point : points) {
      const double from_center = glm::length(point - Vec3(1, 2, 3));
      EXPECT_GT(from_center, shell - 1e-9);
      if (from_center < shell + 1e-6) ++first_layer;
    }
    const double cells = 4 * std::numbers::pi * shell * shell / (dx * dx);
    EXPECT_NEAR(static_cast<double>(first_layer), cells, 0.15 * cells + 2) << radius;
    for (int i = 0; i < 500; ++i) {  // a spiral of points over the shell
      const double z = -1 + 2 * (i + 0.5) / 500;
      const double angle = 2.399963 * i;
      const double r = std::sqrt(1 - z * z);
      EXPECT_LE(distance_to_nearest(points, Vec3(1, 2, 3) + shell * Vec3(r * std::cos(angle), r * std::sin(angle), z)),
                1.1 * dx)
          << radius;
    }
  }
}

TEST(Sampling, LeavesHolesOut) {
  const Wall wall{Tank{{0, 0, 0}, {1, 1, 0}, {}}, 2, {Box{{-0.3, 0.4, 0}, {0, 0.6, 0}}}};
  EXPECT_EQ(sample_wall(wall, 2, dx, 2).size(), 14U * 14U - 100U - 4U);
}

TEST(Sampling, FillsTheSupportByDefault) {
  Scene scene = scene_with({{Tank{{0, 0, 0}, {1, 1, 0}, {}}, 0, {}}});
  for (const auto& [smoothing, layers] :
       std::initializer_list<std::pair<double, int>>{{1, 2}, {1.2, 3}, {1.5, 3}, {2, 4}}) {
    scene.solver.kernel.smoothing = smoothing;
    EXPECT_EQ(wall_layers(scene, scene.walls[0]), layers) << smoothing;
  }
  scene.solver.kernel.smoothing = 1.1;
  scene.particle_spacing = 0.3;  // whatever the spacing's last digits
  EXPECT_EQ(wall_layers(scene, scene.walls[0]), 3);
}

TEST(Sampling, KeepsOneParticleWhereWallsCoincide) {
  const Wall tank{Tank{{0, 0, 0}, {1, 1, 0}, {}}, 2, {}};
  const std::size_t alone = sample(scene_with({tank})).wall_positions.size();
  EXPECT_EQ(sample(scene_with({tank, tank, tank})).wall_positions.size(), alone);
}

TEST(Sampling, GivesWallParticlesTheSlideOfTheirWall) {
  const Wall tank{Tank{{0, 0, 0}, {1, 1, 0}, {Side::top}}, 2, {}};
  Wall lid{Tank{{0, 0, 0}, {1, 1, 0}, {Side::left, Side::bottom, Side::right}}, 2, {}};
  lid.slide = Vec3(3, 0, 0);
  const Sampling sampling = sample(scene_with({tank, lid}));
  ASSERT_EQ(sampling.wall_velocities.size(), sampling.wall_positions.size());
  std::size_t sliding = 0;
  for (std::size_t i = 0; i < sampling.wall_positions.size(); ++i) {
    EXPECT_EQ(sampling.wall_velocities[i], sampling.wall_positions[i].y > 1 ? Vec3(3, 0, 0) : Vec3(0));
    if (sampling.wall_positions[i].y > 1) ++sliding;
  }
  EXPECT_EQ(sliding, 20U);
}

TEST(Sampling, MergesWallsWithoutCrowdingOrGaps) {
  const Wall tank{Tank{{0, 0, 0}, {3, 2, 0}, {Side::top}}, 2, {}};
  const std::vector<std::vector<Wall>> combinations{
      {tank, {Block{{1, 0, 0}, {1.4, 0.5, 0}}, 2, {}}},
      {tank, {Block{{1.03, 0, 0}, {1.47, 0.55, 0}}, 2, {}}},
      {tank, {Block{{1.05, -0.15, 0}, {1.35, 0.45, 0}}, 0, {}}},
      {tank,
       {Polyline{{{0, 1.5, 0}, {1.3, 0.8, 0}}, false, Flank::right}, 2, {}},
       {Polyline{{{1.7, 0.8, 0}, {3, 1.5, 0}}, false, Flank::right}, 2, {}}},
      {tank, {Round{{1.5, 0.6, 0}, 0.33, Face::inside}, 2, {}}},
      {tank, {Round{{1.5, 0, 0}, 0.5, Face::inside}, 2, {}}},
      {tank, {Tank{{3, 0, 0}, {4, 1, 0}, {Side::top}}, 2, {}}},
      {tank, {Polyline{{{3, 0.3, 0}, {2.4, 0, 0}}, false, Flank::left}, 2, {}}},
  };
  for (std::size_t i = 0; i < combinations.size(); ++i) {
    const std::vector<Vec3> walls = sample(scene_with(combinations[i])).wall_positions;
    EXPECT_GE(least_distance(walls), wall_merge_distance) << i;
    EXPECT_LE(widest_gap(walls, {-0.05, -0.05, 0}, {3.05, -0.05, 0}), 1.5) << i;
    EXPECT_LE(widest_gap(walls, {-0.05, -0.05, 0}, {-0.05, 1.95, 0}), 1.5) << i;
  }
}

}  // namespace
}  // namespace weir
