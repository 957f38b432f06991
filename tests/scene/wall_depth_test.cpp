#include "scene/wall_depth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace weir {
namespace {

TEST(WallDepth, OfATankIsTheDistanceFromItsInside) {
  const Tank tank{Vec3(0), Vec3(2, 1, 0), {Side::top}};
  EXPECT_DOUBLE_EQ(wall_depth(tank, 2, Vec3(1, -0.05, 0)), 0.05);
  EXPECT_DOUBLE_EQ(wall_depth(tank, 2, Vec3(2.3, 0.5, 0)), 0.3);
  EXPECT_DOUBLE_EQ(wall_depth(tank, 2, Vec3(-0.3, -0.4, 0)), 0.5);  // of a corner
  EXPECT_DOUBLE_EQ(wall_depth(tank, 2, Vec3(2.3, 1.5, 0)), 0.3);    // beside the open top
}

TEST(WallDepth, OfABlockIsTheDistanceToTheNearestFace) {
  const Block block{Vec3(0), Vec3(2, 1, 3)};
  EXPECT_DOUBLE_EQ(wall_depth(block, 3, Vec3(1, 0.9, 1.5)), 0.1);
  EXPECT_DOUBLE_EQ(wall_depth(block, 3, Vec3(1.75, 0.5, 1.5)), 0.25);
}

TEST(WallDepth, OfALineIsTheDistanceToItsNearestPiece) {
  const Polyline open{{Vec3(0), Vec3(1, 0, 0), Vec3(1, 1, 0)}};
  EXPECT_DOUBLE_EQ(wall_depth(open, 2, Vec3(0.5, -0.2, 0)), 0.2);
  EXPECT_DOUBLE_EQ(wall_depth(open, 2, Vec3(1.3, -0.4, 0)), 0.5);
  EXPECT_DOUBLE_EQ(wall_depth(open, 2, Vec3(0, 1, 0)), 1);
  const Polyline closed{{Vec3(0), Vec3(1, 0, 0), Vec3(1, 1, 0)}, true};
  EXPECT_DOUBLE_EQ(wall_depth(closed, 2, Vec3(0, 1, 0)), std::sqrt(0.5));
}

TEST(WallDepth, OfAPolygonIsTheDistanceToItsNearestEdge) {
  const std::vector<Vec3> triangle{Vec3(0), Vec3(1, 0, 0), Vec3(1, 1, 0)};
  for (const Face solid : {Face::inside, Face::outside}) {
    EXPECT_DOUBLE_EQ(wall_depth(PolygonWall{triangle, solid}, 2, Vec3(0.75, 0.125, 0)), 0.125);
    EXPECT_DOUBLE_EQ(wall_depth(PolygonWall{triangle, solid}, 2, Vec3(0, 1, 0)), std::sqrt(0.5));
  }
}

TEST(WallDepth, OfADiscIsTheDistanceFromItsRim) {
  EXPECT_DOUBLE_EQ(wall_depth(Round{Vec3(1, 0, 0), 0.5}, 2, Vec3(1.2, 0, 0)), 0.3);
  EXPECT_DOUBLE_EQ(wall_depth(Round{Vec3(1, 0, 0), 0.5, Face::outside}, 2, Vec3(1.7, 0, 0)), 0.2);
}

}  // namespace
}  // namespace weir
