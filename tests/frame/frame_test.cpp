#include "frame/frame.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace weir {
namespace {

Snapshot two_particles(FieldValues field) {
  Snapshot snapshot;
  snapshot.index = 7;
  snapshot.time = 0.5;
  snapshot.cfl_met = false;
  snapshot.fluid.count = 2;
  snapshot.fluid.positions = {{1, 2, 3}, {4, 5, 6}};
  snapshot.fluid.fields = {std::move(field)};
  return snapshot;
}

TEST(Frame, HoldsPositionsWithTheQuantityThatColours) {
  Frame frame;
  frame.particles.resize(9);  // of an earlier snapshot
  make_frame(two_particles({Quantity::density, 1, std::vector<float>{900, 1100}}), Quantity::density, frame);
  EXPECT_EQ(frame.particles, (std::vector<glm::vec4>{{1, 2, 3, 900}, {4, 5, 6, 1100}}));
  EXPECT_EQ(frame.index, 7);
  EXPECT_EQ(frame.time, 0.5);
  EXPECT_FALSE(frame.cfl_met);
}

TEST(Frame, HoldsIntegersAsNumbers) {
  Frame frame;
  make_frame(two_particles({Quantity::id, 1, std::vector<std::int32_t>{1, 0}}), Quantity::id, frame);
  EXPECT_EQ(frame.particles, (std::vector<glm::vec4>{{1, 2, 3, 1}, {4, 5, 6, 0}}));
}

TEST(Frame, IsNotMadeFromAnotherQuantity) {
  Frame frame;
  EXPECT_THROW(make_frame(two_particles({Quantity::id, 1, std::vector<std::int32_t>{1, 0}}), Quantity::speed, frame),
               std::out_of_range);
}

TEST(Frame, AsksForNoMoreThanItHolds) {
  const SnapshotRequest request = frame_request(Quantity::pressure);
  EXPECT_EQ(request.fluid, std::vector<Quantity>{Quantity::pressure});
  EXPECT_EQ(request.fluid_positions, Precision::single);
  EXPECT_EQ(request.wall_positions, Precision::none);
}

}  // namespace
}  // namespace weir
