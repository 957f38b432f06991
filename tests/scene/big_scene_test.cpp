// Scenes of ten million fluid particles are checked without storing one: their positions alone would take 240 MB.
#include <gmock/gmock.h>

#include <cmath>

#include "scene/allocations.h"
#include "scene/check.h"
#include "scene/reader.h"

namespace weir {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::size_t most_for_walls =
    120'000'000;  // bytes asked for; positions of walls are stored, one wall at a time

// In spacings of 1 m.
Scene scene_of(int dimension, std::vector<Shape> shapes, std::vector<WallShape> walls) {
  Scene scene;
  scene.name = "scene";
  scene.dimension = dimension;
  scene.duration = 1;
  scene.gravity = Vec3(0);
  scene.particle_spacing = 1;
  for (Shape& shape : shapes) scene.fluid.volumes.push_back({std::move(shape), Vec3(0), Vec3(0)});
  for (WallShape& wall : walls) scene.walls.push_back({std::move(wall), 2, {}});
  return scene;
}

std::vector<std::string> said(const Scene& scene) {
  const std::size_t before = allocated_bytes();
  std::vector<std::string> all;
  for (const Violation& violation : check(scene)) all.push_back(violation.path + " " + violation.message);
  EXPECT_LT(allocated_bytes() - before, most_for_walls);
  return all;
}

void expect_count(const Scene& scene, std::int64_t fluid, std::int64_t wall) {
  const Estimate cost = estimate(scene);
  EXPECT_EQ(cost.fluid_particles, fluid);
  EXPECT_EQ(cost.wall_particles, wall);
}

TEST(BigScene, AllocationsAreCounted) {
  const std::size_t before = allocated_bytes();
  const std::vector<double> numbers(1000);
  EXPECT_GE(allocated_bytes() - before, 8000U);
  EXPECT_EQ(numbers.size(), 1000U);
}

TEST(BigScene, BoxInATank) {
  const Scene scene = scene_of(2, {Box{{0, 0, 0}, {5000, 2000, 0}}}, {Tank{{0, 0, 0}, {8000, 4000, 0}, {Side::top}}});
  EXPECT_THAT(said(scene), IsEmpty());
  expect_count(scene, 10'000'000, 8004 * 4002 - 8000 * 4000);
}

TEST(BigScene, BoxInATankIn3D) {
  const Scene scene = scene_of(3, {Box{{0, 0, 0}, {250, 200, 200}}}, {Tank{{0, 0, 0}, {400, 200, 300}, {}}});
  EXPECT_THAT(said(scene), IsEmpty());
  expect_count(scene, 10'000'000, 404 * 204 * 304 - 400 * 200 * 300);
}

TEST(BigScene, BesideAnObstacleInATank) {
  const Scene scene = scene_of(3, {Box{{0, 0, 0}, {250, 200, 200}}},
                               {Tank{{0, 0, 0}, {400, 200, 300}, {Side::top}}, Block{{250, 50, 0}, {300, 100, 50}}});
  EXPECT_THAT(said(scene), IsEmpty());
  expect_count(scene, 10'000'000, 404 * 204 * 302 - 400 * 200 * 300 + 50 * 50 * 50 - 46 * 46 * 46);
}

TEST(BigScene, DiscInARing) {
  const double radius = 1784.1;
  const Scene scene = scene_of(2, {Ball{{0, 0, 0}, radius}}, {Round{{0, 0, 0}, radius, Face::outside}});
  EXPECT_THAT(said(scene), IsEmpty());
  std::int64_t count = 0;  // of cells about the centre, in half spacings
  for (std::int64_t y = -3570; y <= 3570; y += 2) {
    for (std::int64_t x = -3570; x <= 3570; x += 2) {
      if (static_cast<double>(x * x + y * y) < 4 * radius * radius) ++count;
    }
  }
  std::int64_t other = 0;
  for (std::int64_t y = -3571; y <= 3571; y += 2) {
    for (std::int64_t x = -3571; x <= 3571; x += 2) {
      if (static_cast<double>(x * x + y * y) < 4 * radius * radius) ++other;
    }
  }
  const double area = M_PI * radius * radius;
  if (std::abs(static_cast<double>(other) - area) < std::abs(static_cast<double>(count) - area)) count = other;
  EXPECT_GT(count, 9'900'000);
  expect_count(scene, count, std::llround(2 * M_PI * (radius + 0.5)) + std::llround(2 * M_PI * (radius + 1.5)));
}

TEST(BigScene, BoxesSideBySide) {
  const Scene scene = scene_of(2, {Box{{0, 0, 0}, {2500, 2000, 0}}, Box{{2500, 0, 0}, {5000, 2000, 0}}},
                               {Tank{{0, 0, 0}, {5000, 2000, 0}, {}}});
  EXPECT_THAT(said(scene), IsEmpty());
  expect_count(scene, 10'000'000, 5004 * 2004 - 5000 * 2000);
}

TEST(BigScene, TrianglesOnTheirDiagonal) {
  const Vec3 a(0, 0, 0), b(4000, 0, 0), c(4000, 5000, 0), d(0, 5000, 0);
  const Scene scene = scene_of(2, {Polygon{{a, b, c}}, Polygon{{a, c, d}}}, {Tank{a, c, {}}});
  EXPECT_THAT(said(scene), IsEmpty());
  EXPECT_NEAR(static_cast<double>(estimate(scene).fluid_particles), 20'000'000, 4000);
}

TEST(BigScene, MistakesAreFound) {
  const Box box{{0, 0, 0}, {5000, 2000, 0}};
  EXPECT_THAT(said(scene_of(2, {box, Box{{4999, 1999, 0}, {6000, 3000, 0}}}, {})),
              ElementsAre("fluid.volumes.1.box overlaps fluid.volumes.0.box"));
  EXPECT_THAT(said(scene_of(2, {box, Ball{{5050, 1000, 0}, 50.6}}, {})),
              ElementsAre("fluid.volumes.1.disc overlaps fluid.volumes.0.box"));
  EXPECT_THAT(said(scene_of(2, {box}, {Tank{{0, 0, 0}, {4999, 2000, 0}, {Side::top}}})),
              ElementsAre("fluid.volumes.0.box reaches into walls.0.tank"));
  EXPECT_THAT(said(scene_of(2, {box}, {Polyline{{{0, 0, 0}, {4990, 10, 0}, {9000, 10, 0}}, false, Flank::right}})),
              ElementsAre("fluid.volumes.0.box reaches into walls.0.polyline"));
  EXPECT_THAT(said(scene_of(2, {box}, {Round{{2000, 1000, 0}, 3, Face::inside}})),
              ElementsAre("fluid.volumes.0.box reaches into walls.0.disc"));
  EXPECT_THAT(
      said(scene_of(2, {box}, {Tank{{10000, 0, 0}, {10100, 100, 0}, {}}})),
      ElementsAre("fluid.volumes.0.box lies outside the closed walls: 10000000 of 10000000 particles, such as at "
                  "(0.5, 0.5)"));
}

TEST(BigScene, IsReadWithoutStoringFluid) {
  const std::string text =
      "{weir: 1, dimension: 2, duration: 1, particles: {spacing: 0.001},\n"
      " fluid: {volumes: [{box: {min: [0, 0], max: [5, 2]}}]}, walls: [{tank: {min: [0, 0], max: [8, 4]}}]}\n";
  const std::size_t before = allocated_bytes();
  const Scene scene = read_scene_text(text, "s.yaml");
  EXPECT_LT(allocated_bytes() - before, most_for_walls);
  EXPECT_EQ(estimate(scene).fluid_particles, 10'000'000);
}

}  // namespace
}  // namespace weir
