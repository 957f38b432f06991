#include "render/camera.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/test_scene.h"

namespace weir {
namespace {

constexpr PixelBox content{10, 20, 290, 170};

TEST(Camera, BoundsHoldWallsAndFluid) {
  const test::Still still = test::dam_break();  // walls of two layers of 3 cm around [0, 3] x [0, 2.01]
  const Bounds bounds = bounds_of(still.scene, still.static_scene);
  EXPECT_NEAR(bounds.min.x, -0.06, 1e-6);
  EXPECT_NEAR(bounds.min.y, -0.06, 1e-6);
  EXPECT_NEAR(bounds.max.x, 3.06, 1e-6);
  EXPECT_NEAR(bounds.max.y, 2.01, 1e-6);
}

TEST(Camera, WithoutWallsAQuarterIsAdded) {
  test::Still still = test::dam_break();
  still.static_scene.walls.clear();
  still.scene.fluid.volumes = {{Ball{Vec3(1, 2, 0), 0.5}, Vec3(0), Vec3(0)},
                               {Polygon{{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 1, 0)}}, Vec3(0), Vec3(0)}};
  const Bounds bounds = bounds_of(still.scene, still.static_scene);  // fluid: [0, 2] x [0, 2.5]
  EXPECT_EQ(bounds.min, Vec3(-0.625, -0.625, 0));
  EXPECT_EQ(bounds.max, Vec3(2.625, 3.125, 0));
}

TEST(Camera, FittedPlaneFillsTheContentAndIsCentred) {
  const Projection projection = fit_2d({Vec3(-1, 0, 0), Vec3(3, 1, 0)}, content);
  EXPECT_DOUBLE_EQ(projection.focal, 280.0 / 4);  // limited by the width: 70 pixels per metre, 70 of 150 pixels high
  const glm::dvec2 low = projection.pixel(Vec3(-1, 0, 0));
  const glm::dvec2 high = projection.pixel(Vec3(3, 1, 0));
  EXPECT_NEAR(low.x, content.left, 1e-9);
  EXPECT_NEAR(high.x, content.right, 1e-9);
  EXPECT_NEAR(low.y + high.y, content.top + content.bottom, 1e-9);
  EXPECT_GT(low.y, high.y);  // up is up
}

TEST(Camera, FittedSpaceTouchesTheContentAndStaysInside) {
  const Bounds bounds{Vec3(-1, 2, 0), Vec3(3, 3, 5)};
  const Projection projection = fit_3d(bounds, content);
  PixelBox seen{1e9, 1e9, -1e9, -1e9};
  for (int k = 0; k < 8; ++k) {
    const glm::dvec2 at = projection.pixel(Vec3(k & 1 ? 3 : -1, k & 2 ? 3 : 2, k & 4 ? 5 : 0));
    seen = {std::min(seen.left, at.x), std::min(seen.top, at.y), std::max(seen.right, at.x),
            std::max(seen.bottom, at.y)};
  }
  EXPECT_GE(seen.left, content.left - 1e-6);
  EXPECT_GE(seen.top, content.top - 1e-6);
  EXPECT_LE(seen.right, content.right + 1e-6);
  EXPECT_LE(seen.bottom, content.bottom + 1e-6);
  // One direction determines the distance, and both sides touch in it; a pixel of tolerance for the iteration.
  EXPECT_NEAR(std::max(seen.width() / content.width(), seen.height() / content.height()), 1, 0.01);
  EXPECT_GT(projection.pixel(Vec3(0, 2, 0)).y, projection.pixel(Vec3(0, 2, 5)).y);  // z is up
}

TEST(Camera, StatedPlaneHasItsCentreAndWidth) {
  const Projection projection = projection_of(View2D{Vec3(1, 2, 0), 4}, 320, 180);
  EXPECT_EQ(projection.pixel(Vec3(1, 2, 0)), glm::dvec2(160, 90));
  EXPECT_EQ(projection.pixel(Vec3(3, 2, 0)), glm::dvec2(320, 90));
}

TEST(Camera, StatedSpaceHasItsFieldOfView) {
  const Projection projection = projection_of(View3D{Vec3(0, -10, 0), Vec3(0), 60}, 320, 180);
  const double half = 10 * std::tan(glm::radians(30.0));  // m, visible above the target
  EXPECT_NEAR(projection.pixel(Vec3(0)).x, 160, 1e-9);
  EXPECT_NEAR(projection.pixel(Vec3(0, 0, half)).y, 0, 1e-9);
  EXPECT_NEAR(projection.pixel(Vec3(half, 0, 0)).x, 160 + 90, 1e-9);  // +x is to the right, seen from the front
  EXPECT_NEAR(projection.pixels_per_metre(), 90 / half, 1e-9);
}

TEST(Camera, LookingStraightDownHasADefinedUp) {
  const Projection projection = projection_of(View3D{Vec3(0, 0, 10), Vec3(0), 60}, 320, 180);
  EXPECT_LT(projection.pixel(Vec3(0, 1, 0)).y, 90);
  EXPECT_GT(projection.pixel(Vec3(1, 0, 0)).x, 160);
}

Scene with_keyframes(std::vector<CameraKeyframe> keyframes) {
  Scene scene = test::dam_break().scene;
  scene.camera.keyframes = std::move(keyframes);
  return scene;
}

TEST(Camera, StandsStillBeforeTheFirstAndAfterTheLastKeyframe) {
  const Scene scene = with_keyframes({{1, View2D{Vec3(0), 4}}, {2, View2D{Vec3(1, 0, 0), 2}}});
  const CameraPath path(scene, {}, content);
  EXPECT_EQ(path.at(0), path.at(1));
  EXPECT_EQ(path.at(2), path.at(9));
  EXPECT_DOUBLE_EQ(path.at(0).focal, 80);
  EXPECT_DOUBLE_EQ(path.at(9).focal, 160);
}

TEST(Camera, ZoomsGeometricallyAboutAPointAtRest) {
  const View2D from{Vec3(0), 4};
  const View2D to{Vec3(1, 0.5, 0), 1};
  const auto half = std::get<View2D>(view_between(from, to, 0.5));
  EXPECT_DOUBLE_EQ(half.width, 2);
  // The fixed point p of the similarity: (p - from) / 4 = (p - to) / 1, p = (4 to - from) / 3.
  const Vec3 fixed = (4.0 * to.center - from.center) / 3.0;
  const glm::dvec2 before = projection_of(from, 320, 180).pixel(fixed);
  for (const double along : {0.1, 0.5, 0.9, 1.0}) {
    const glm::dvec2 at = projection_of(view_between(from, to, along), 320, 180).pixel(fixed);
    EXPECT_NEAR(at.x, before.x, 1e-9);
    EXPECT_NEAR(at.y, before.y, 1e-9);
  }
}

TEST(Camera, PansWithoutZoom) {
  const auto half = std::get<View2D>(view_between(View2D{Vec3(0), 2}, View2D{Vec3(1, 3, 0), 2}, 0.5));
  EXPECT_EQ(half.center, Vec3(0.5, 1.5, 0));
  EXPECT_DOUBLE_EQ(half.width, 2);
}

TEST(Camera, StartsAndStopsSmoothly) {
  const Scene scene = with_keyframes({{0, View2D{Vec3(0), 2}}, {1, View2D{Vec3(1, 0, 0), 2}}});
  const CameraPath path(scene, {}, content);
  const auto speed = [&](double t) { return (path.at(t + 1e-4).eye.x - path.at(t - 1e-4).eye.x) / 2e-4; };
  EXPECT_NEAR(speed(0), 0, 1e-3);
  EXPECT_NEAR(speed(1), 0, 1e-3);
  EXPECT_NEAR(speed(0.5), 1.5, 1e-3);  // of the smoothstep 3 u^2 - 2 u^3
}

TEST(Camera, MovesAroundTheTarget) {
  const View3D from{Vec3(0, -2, 0), Vec3(0), 30};
  const View3D to{Vec3(8, 0, 0), Vec3(0), 50};
  const auto half = std::get<View3D>(view_between(from, to, 0.5));
  EXPECT_NEAR(glm::length(half.eye), 4, 1e-12);  // sqrt(2 * 8)
  EXPECT_NEAR(half.eye.x, -half.eye.y, 1e-12);   // half of the right angle
  EXPECT_DOUBLE_EQ(half.field_of_view, 40);
  // It moves sideways to the opposite side, never through the target.
  const auto opposite = std::get<View3D>(view_between(from, View3D{Vec3(0, 2, 0), Vec3(0), 30}, 0.5));
  EXPECT_NEAR(glm::length(opposite.eye), 2, 1e-12);
  EXPECT_NEAR(opposite.eye.z, 0, 1e-12);
}

}  // namespace
}  // namespace weir
