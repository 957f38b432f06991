#include "run/schedule.h"

#include <gtest/gtest.h>

#include <vector>

namespace weir {

namespace {

std::vector<double> times_due(double every, const std::vector<double>& times) {
  Schedule schedule(every);
  std::vector<double> due;
  for (const double time : times) {
    if (!schedule.due(time)) continue;
    schedule.written(time);
    due.push_back(time);
  }
  return due;
}

TEST(Schedule, IsDueAtTheStart) { EXPECT_EQ(times_due(0.1, {0.0, 0.05}), std::vector<double>{0.0}); }

TEST(Schedule, IsDueOnceAMultipleIsPassed) {
  EXPECT_EQ(times_due(0.1, {0.0, 0.09, 0.13, 0.17, 0.199, 0.21, 0.55, 0.59, 0.6}),
            (std::vector<double>{0.0, 0.13, 0.21, 0.55, 0.6}));
}

TEST(Schedule, KnowsAMultipleInItsLastBits) {
  // 3 * 0.1 is 0.30000000000000004; a landing at 0.3 is the same instant.
  EXPECT_EQ(times_due(0.1, {0.0, 0.1, 0.2, 0.3, 0.35}), (std::vector<double>{0.0, 0.1, 0.2, 0.3}));
}

TEST(Schedule, IsDueAtEveryMultipleOfAFrameTime) {
  std::vector<double> landings;
  for (int frame = 0; frame <= 600; ++frame) landings.push_back(frame / 60.0);
  EXPECT_EQ(times_due(1.0 / 60.0, landings), landings);
}

TEST(Schedule, RemembersTheLastTime) {
  Schedule schedule(1);
  EXPECT_LT(schedule.last(), 0);
  schedule.written(0.25);
  EXPECT_EQ(schedule.last(), 0.25);
}

}  // namespace

}  // namespace weir
