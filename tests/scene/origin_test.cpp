// A scene far from zero is sampled as the same scene at zero is.
#include "scene/origin.h"

#include <gmock/gmock.h>

#include <filesystem>

#include "scene/check.h"
#include "scene/reader.h"
#include "scene/sampling.h"

namespace weir {
namespace {

// Every kind of shape; lengths in units of `unit`.
Scene scene_at(const Vec3& at, double unit) {
  const auto point = [&](double x, double y) { return at + unit * Vec3(x, y, 0); };
  Scene scene;
  scene.name = "scene";
  scene.dimension = 2;
  scene.duration = 1;
  scene.particle_spacing = unit;
  scene.fluid.volumes = {{Box{point(0, 0), point(16, 12)}, {1, 2, 0}, {0, 0, 3}, {TaylorGreen{2, 20 * unit}}, 0.2},
                         {Ball{point(40, 10), 5 * unit}, Vec3(0), {0, 0, 1}},
                         {Polygon{{point(20, 1), point(30, 1), point(25, 9.5)}}, Vec3(0), Vec3(0)}};
  scene.walls = {{Tank{point(-8, -4), point(56, 40), {Side::top}}, 2, {Box{point(-10, 20), point(-8, 24)}}},
                 {Block{point(32, 24), point(40, 28)}, 0, {}},
                 {Polyline{{point(0, 24), point(8, 20.5), point(16, 24)}, false, Flank::left}, 2, {}},
                 {Round{point(24, 24), 4 * unit, Face::inside}, 2, {}},
                 {PolygonWall{{point(44, 24), point(52, 24), point(50, 32)}, Face::inside}, 2, {}}};
  scene.camera.view = View2D{point(24, 16), 64 * unit};
  scene.camera.keyframes = {{0, View2D{point(24, 16), 64 * unit}}};
  return scene;
}

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = std::max(largest, glm::length(a[i] - b[i]));
  return largest;
}

Scene at_its_origin(const Scene& scene) { return relative_to(scene, scene_origin(scene)); }

TEST(Origin, IsTheCornerOfScenesFarAway) {
  EXPECT_EQ(scene_origin(scene_at({3e5, -2e5, 0}, 0.0625)), Vec3(3e5, -2e5, 0) + 0.0625 * Vec3(-8, -4, 0));
  EXPECT_EQ(scene_origin(scene_at({0, 0, 0}, 0.0625)), Vec3(0));  // the corner is not at zero, but near it
  EXPECT_EQ(scene_origin(Scene{}), Vec3(0));
  Scene scene = scene_at({3e5, -2e5, 0}, 0.0625);
  scene.periodic = {Axis::x};
  scene.domain = Bounds{{2.9e5, -2e5, 0}, {3.1e5, -1e5, 0}};
  EXPECT_EQ(scene_origin(scene).x, 2.9e5);
}

TEST(Origin, ScenesThatShipKeepTheirs) {
  for (const auto& entry : std::filesystem::directory_iterator("scenes")) {
    if (entry.path().extension() == ".yaml") {
      EXPECT_EQ(scene_origin(read_scene(entry.path())), Vec3(0)) << entry.path();
    }
  }
}

TEST(Origin, MovedScenesAreSampledBitForBitOnPowersOfTwo) {
  const Vec3 corner = 0.0625 * Vec3(-8, -4, 0);
  const Scene near = relative_to(scene_at({0, 0, 0}, 0.0625), corner);
  const Scene far = at_its_origin(scene_at({3e5, -2e5, 0}, 0.0625));
  const Sampling expected = sample(near);
  const Sampling sampling = sample(far);
  ASSERT_GT(expected.fluid_positions.size(), 250U);
  ASSERT_GT(expected.wall_positions.size(), 250U);
  EXPECT_EQ(sampling.fluid_positions, expected.fluid_positions);
  EXPECT_EQ(sampling.wall_positions, expected.wall_positions);
  // The phase of vortices is that of the scene's own coordinates: here 3e5 / 1.25 and -2e5 / 1.25 are whole.
  EXPECT_EQ(sampling.fluid_velocities, expected.fluid_velocities);
  EXPECT_EQ(std::get<View2D>(far.camera.view).center, std::get<View2D>(near.camera.view).center);
  EXPECT_EQ(std::get<View2D>(far.camera.keyframes[0].view).center,
            std::get<View2D>(near.camera.keyframes[0].view).center);
}

TEST(Origin, MovedScenesAreSampledToAMillionthOfTheSpacing) {
  const double unit = 0.01;
  const Sampling expected = sample(relative_to(scene_at({0, 0, 0}, unit), unit * Vec3(-8, -4, 0)));
  const Sampling sampling = sample(at_its_origin(scene_at({3e5, -2e5, 0}, unit)));
  EXPECT_LT(largest_difference(sampling.fluid_positions, expected.fluid_positions), 1e-6 * unit);
  EXPECT_LT(largest_difference(sampling.wall_positions, expected.wall_positions), 1e-6 * unit);
  EXPECT_LT(largest_difference(sampling.fluid_velocities, expected.fluid_velocities), 1e-6);
}

TEST(Origin, PhaseOfVorticesIsThatOfTheScenesCoordinates) {
  Scene scene = scene_at({3e5 + 0.3, -2e5, 0}, 0.0625);
  const Sampling expected = sample(scene);
  const Sampling sampling = sample(at_its_origin(scene));
  EXPECT_LT(largest_difference(sampling.fluid_velocities, expected.fluid_velocities), 1e-8);
}

TEST(Origin, CheckAndEstimateAgreeWithThoseAtZero) {
  const double unit = 0.01;
  const Scene near = scene_at({0, 0, 0}, unit);
  const Scene far = scene_at({3e5, -2e5, 0}, unit);
  EXPECT_TRUE(check(near).empty());
  EXPECT_TRUE(check(far).empty());
  EXPECT_EQ(estimate(near).fluid_particles, estimate(far).fluid_particles);
  EXPECT_EQ(estimate(near).wall_particles, estimate(far).wall_particles);
}

}  // namespace
}  // namespace weir
