#include "sph/timeline.h"

#include <gtest/gtest.h>

namespace weir {
namespace {

TEST(Timeline, StartsFromTheScenesOwnSettings) {
  Scene scene;
  scene.gravity = {1, 2, 0};
  scene.fluid.viscosity.kinematic = 0.5;
  scene.solver.compressibility = Stiffness{123};
  const Timeline timeline(scene);
  EXPECT_EQ(timeline.state().gravity, Vec3(1, 2, 0));
  EXPECT_EQ(timeline.state().viscosity, 0.5);
  EXPECT_EQ(timeline.state().stiffness, 123);
  EXPECT_FALSE(timeline.paused());
}

TEST(Timeline, AStepActsFromItsTimeOn) {
  Scene scene;
  scene.timeline = {{.at = 0.5, .set = {.viscosity = 2.0}}};
  Timeline timeline(scene);
  timeline.advance_to(0.499);
  EXPECT_NE(timeline.state().viscosity, 2.0);
  timeline.advance_to(0.5);
  EXPECT_EQ(timeline.state().viscosity, 2.0);
}

TEST(Timeline, ARampIsLinearAndEndsExactly) {
  Scene scene;
  scene.gravity = {0, -8, 0};
  scene.timeline = {{.at = 1, .over = 2, .set = {.gravity = Vec3{4, 0, 0}}}};
  Timeline timeline(scene);
  timeline.advance_to(1.5);
  EXPECT_EQ(timeline.state().gravity, Vec3(1, -6, 0));
  timeline.advance_to(2.5);
  EXPECT_EQ(timeline.state().gravity, Vec3(3, -2, 0));
  timeline.advance_to(3);
  EXPECT_EQ(timeline.state().gravity, Vec3(4, 0, 0));
  timeline.advance_to(9);
  EXPECT_EQ(timeline.state().gravity, Vec3(4, 0, 0));
}

TEST(Timeline, ALaterStepEndsARamp) {
  Scene scene;
  scene.fluid.surface_tension.coefficient = 0;
  scene.timeline = {{.at = 0, .over = 2, .set = {.surface_tension = 2.0}}, {.at = 1, .set = {.surface_tension = 7.0}}};
  Timeline timeline(scene);
  timeline.advance_to(0.5);
  EXPECT_EQ(timeline.state().surface_tension, 0.5);
  timeline.advance_to(1.5);
  EXPECT_EQ(timeline.state().surface_tension, 7);
}

TEST(Timeline, SoundSpeedSetsTheStiffness) {
  Scene scene;
  scene.fluid.rest_density = 1000;
  scene.solver.exponent = 7;
  scene.timeline = {{.at = 0, .set = {.sound_speed = 10.0}}};
  Timeline timeline(scene);
  timeline.advance_to(0);
  EXPECT_DOUBLE_EQ(timeline.state().stiffness, 1000 * 100.0 / 7);
}

TEST(Timeline, PausesAndResets) {
  Scene scene;
  scene.timeline = {{.at = 1, .pause = true}, {.at = 2, .pause = false}, {.at = 3, .reset = true}};
  Timeline timeline(scene);
  EXPECT_FALSE(timeline.advance_to(1));
  EXPECT_TRUE(timeline.paused());
  EXPECT_FALSE(timeline.advance_to(2));
  EXPECT_FALSE(timeline.paused());
  EXPECT_TRUE(timeline.advance_to(3.1));
  EXPECT_FALSE(timeline.advance_to(3.2)) << "once";
}

}  // namespace
}  // namespace weir
