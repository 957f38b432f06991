#include "sph/clock.h"

#include <gtest/gtest.h>

#include <cmath>

namespace weir {
namespace {

Scene timed(double duration, int fps) {
  Scene scene;
  scene.duration = duration;
  scene.render.fps = fps;
  return scene;
}

struct Walk {
  std::vector<double> frame_times;
  double shortest = 1e300, longest = 0;
  int steps = 0;
};

Walk walk(const Scene& scene, double limit) {
  Clock clock(scene);
  Walk walk;
  while (!clock.finished()) {
    if (clock.frame_index() >= 0) walk.frame_times.push_back(clock.time());
    const double dt = fitted_step(limit, clock.way());
    walk.shortest = std::min(walk.shortest, dt);
    walk.longest = std::max(walk.longest, dt);
    clock.advance(dt);
    ++walk.steps;
  }
  EXPECT_EQ(clock.time(), scene.duration);
  if (clock.frame_index() >= 0) walk.frame_times.push_back(clock.time());
  return walk;
}

TEST(Clock, MeetsEveryFrameTimeToTheLastBit) {
  for (const double limit : {1e-3, 1.7e-4, 0.3}) {
    const Walk w = walk(timed(3, 60), limit);
    ASSERT_EQ(w.frame_times.size(), 181);
    for (std::size_t k = 0; k < w.frame_times.size(); ++k) EXPECT_EQ(w.frame_times[k], static_cast<double>(k) / 60);
  }
}

TEST(Clock, DividesTheWayToALandingEvenly) {
  const double limit = 1.0 / 60 / 7.3;  // eight steps a frame
  const Walk w = walk(timed(1, 60), limit);
  EXPECT_EQ(w.steps, 60 * 8);
  EXPECT_LE(w.longest, limit);
  EXPECT_NEAR(w.shortest, w.longest, 1e-12) << "no sliver";
}

TEST(Clock, ALimitThatFitsExactlyIsNotSplitByRounding) { EXPECT_EQ(walk(timed(2, 50), 0.001).steps, 2000); }

TEST(Clock, LandsOnEventsAndOnADurationBetweenFrames) {
  Scene scene = timed(0.25, 10);
  scene.timeline = {{.at = 0.12, .over = 0.05}};
  Clock clock(scene);
  std::vector<double> landings;
  while (!clock.finished()) {
    clock.advance_to_landing();
    landings.push_back(clock.time());
  }
  EXPECT_EQ(landings, (std::vector<double>{0.1, 0.12, 0.12 + 0.05, 0.2, 0.25}));
}

TEST(Clock, AnEventThatMissesAFrameTimeByRoundingIsOnIt) {
  Scene scene = timed(1, 10);
  scene.timeline = {{.at = 0.1, .over = 0.2}};  // 0.1 + 0.2 > 0.3 in binary
  Clock clock(scene);
  int landings = 0;
  for (; !clock.finished(); ++landings) clock.advance_to_landing();
  EXPECT_EQ(landings, 10);
}

TEST(Clock, FramesAreNotMetBetweenThem) {
  Clock clock(timed(1, 10));
  EXPECT_EQ(clock.frame_index(), 0);
  clock.advance(fitted_step(0.04, clock.way()));
  EXPECT_EQ(clock.frame_index(), -1);
  clock.advance_to_landing();
  EXPECT_EQ(clock.frame_index(), 1);
}

}  // namespace
}  // namespace weir
