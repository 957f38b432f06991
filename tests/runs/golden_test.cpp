// Whole runs against committed pictures: a middle and the last frame of each.
#include <gtest/gtest.h>

#include "runs/scenes.h"
#include "support/golden.h"

namespace weir::test {
namespace {

testing::AssertionResult frame_matches(const FinishedRun& run, int number, const std::string& name) {
  return matches_golden(run.frame(number), "runs/" + name, run.machine());
}

TEST(RunGolden, DamBreak) {
  const FinishedRun run(dam_break_run());
  ASSERT_EQ(run.frames(), 6);
  EXPECT_TRUE(frame_matches(run, 3, "dam_break_middle"));
  EXPECT_TRUE(frame_matches(run, 5, "dam_break_last"));
}

TEST(RunGolden, IsTheSameForAnyNumberOfThreads) {
  const FinishedRun one(dam_break_run(), 1);
  for (const int threads : {2, 3, 8}) {
    const FinishedRun several(dam_break_run(), threads);
    EXPECT_EQ(several.manifest().state_hash, one.manifest().state_hash) << threads << " threads";
    EXPECT_EQ(difference(several.frame(5), one.frame(5)).pixels, 0) << threads << " threads";
  }
}

TEST(RunGolden, ThreeDimensions) {
  const FinishedRun run(cup_run());
  ASSERT_EQ(run.frames(), 6);
  EXPECT_TRUE(frame_matches(run, 3, "cup_middle"));
  EXPECT_TRUE(frame_matches(run, 5, "cup_last"));
}

// Sizes are multiples of a power of two, so that they are the same numbers at map coordinates.
Scene dam_break_at(const Vec3& corner) {
  Scene scene = dam_break_run();
  scene.duration = 0.08;
  scene.particle_spacing = 1.0 / 64;
  scene.fluid.volumes = {{.shape = Box{corner, corner + Vec3(0.25, 0.375, 0)}}};
  scene.walls = {{.shape = Tank{corner, corner + Vec3(0.875, 0.5, 0), {Side::top}}, .layers = 2, .holes = {}}};
  scene.camera.keyframes = {{.at = 0, .view = View2D{corner + Vec3(0.5, 0.25, 0), 1}}};
  return scene;
}

TEST(RunGolden, IsTheSameAtMapCoordinates) {
  const FinishedRun near(dam_break_at(Vec3(0)));
  const FinishedRun far(dam_break_at(Vec3(524288, 4194304, 0)));
  EXPECT_EQ(far.manifest().state_hash, near.manifest().state_hash);
  for (const int frame : {0, 2}) EXPECT_EQ(difference(far.frame(frame), near.frame(frame)).pixels, 0) << frame;
}

TEST(RunGolden, TimelineHoldsTiltsAndStartsAgain) {
  Scene scene = dam_break_run();
  scene.title = "Timeline";
  scene.timeline = {{.at = 0.08, .pause = true},
                    {.at = 0.14, .set = {.gravity = Vec3(-9.81, 0, 0)}, .reset = true, .pause = false}};
  scene.duration = 0.28;
  scene.render.overlay = {OverlayItem::title, OverlayItem::colorbar, OverlayItem::scalebar};
  const FinishedRun run(scene);
  ASSERT_EQ(run.frames(), 8);
  EXPECT_GT(difference(run.frame(1), run.frame(2)).pixels, 0);
  EXPECT_EQ(difference(run.frame(2), run.frame(3)).pixels, 0);  // paused from 0.08 s to 0.14 s
  EXPECT_GT(difference(run.frame(3), run.frame(4)).pixels, 0);  // 0.02 s after the new start
  EXPECT_TRUE(frame_matches(run, 3, "timeline_paused"));
  EXPECT_TRUE(frame_matches(run, 7, "timeline_last"));
}

TEST(RunGolden, DarkAndTransparentWithAMovingCamera) {
  Scene scene = dam_break_run();
  scene.title = "Dark";
  scene.render.theme = Theme::dark;
  scene.render.transparent = true;
  scene.render.color = {.by = Quantity::pressure, .map = ColormapName::magma, .range = {{0, 4000}}};
  scene.camera.keyframes = {{.at = 0, .view = View2D{Vec3(0.45, 0.25, 0), 1.0}},
                            {.at = 0.2, .view = View2D{Vec3(0.3, 0.15, 0), 0.6}}};
  const FinishedRun run(scene);
  EXPECT_TRUE(frame_matches(run, 3, "dark_middle"));
  EXPECT_TRUE(frame_matches(run, 5, "dark_last"));
  EXPECT_EQ(run.frame(5).pixel(160, 20)[3], 0);  // nothing there
}

}  // namespace
}  // namespace weir::test
