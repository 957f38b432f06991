#include "render/wall_view.h"

#include <gtest/gtest.h>

namespace weir {
namespace {

// 2 m x 1 m x 1 m inside, two layers of 0.1 m around.
Scene tank() {
  Scene scene;
  scene.dimension = 3;
  scene.particle_spacing = 0.1;
  scene.walls = {{.shape = Tank{Vec3(0), Vec3(2, 1, 1), {Side::top}}, .layers = 2, .holes = {}}};
  return scene;
}

TEST(WallView, CullsTheSidesOfATankThatFaceTheEyeWithTheirOutside) {
  const Scene scene = tank();
  const Vec3 eye(-3, -5, 3);                                     // in front, on the left, above
  EXPECT_TRUE(hides_inside(scene, Vec3(1, -0.05, 0.5), eye));    // front
  EXPECT_TRUE(hides_inside(scene, Vec3(-0.15, 0.5, 0.5), eye));  // left
  EXPECT_FALSE(hides_inside(scene, Vec3(1, 1.05, 0.5), eye));    // back
  EXPECT_FALSE(hides_inside(scene, Vec3(2.15, 0.5, 0.5), eye));  // right
  EXPECT_FALSE(hides_inside(scene, Vec3(1, 0.5, -0.05), eye));   // floor
  EXPECT_TRUE(hides_inside(scene, Vec3(1, 0.5, -0.05), Vec3(1, 0.5, -4)));
}

TEST(WallView, KeepsEdgesOfVisibleSides) {
  const Scene scene = tank();
  const Vec3 eye(-3, -5, 3);
  EXPECT_TRUE(hides_inside(scene, Vec3(-0.05, -0.05, 0.5), eye));     // front and left
  EXPECT_FALSE(hides_inside(scene, Vec3(-0.05, 1.05, 0.5), eye));     // left and back
  EXPECT_FALSE(hides_inside(scene, Vec3(-0.05, -0.05, -0.05), eye));  // front, left and floor
}

TEST(WallView, KeepsObstacles) {
  Scene scene = tank();
  const Vec3 eye(-3, -5, 3);
  EXPECT_FALSE(hides_inside(scene, Vec3(1, 0.5, 0.5), eye));   // an obstacle inside
  EXPECT_FALSE(hides_inside(scene, Vec3(1, -0.5, 0.5), eye));  // one in front of the tank
  scene.walls = {{.shape = Block{Vec3(0), Vec3(1)}, .layers = 2, .holes = {}},
                 {.shape = Round{Vec3(3, 0, 0), 1, Face::inside}, .layers = 2, .holes = {}}};
  EXPECT_FALSE(hides_inside(scene, Vec3(0.5, 0.05, 0.5), eye));
  EXPECT_FALSE(hides_inside(scene, Vec3(3, -0.95, 0), eye));
}

TEST(WallView, OpensAHollowBallTowardsTheEye) {
  Scene scene;
  scene.dimension = 3;
  scene.particle_spacing = 0.1;
  scene.walls = {{.shape = Round{Vec3(0), 1, Face::outside}, .layers = 2, .holes = {}}};
  const Vec3 eye(0, -5, 0);
  EXPECT_TRUE(hides_inside(scene, Vec3(0, -1.05, 0), eye));
  EXPECT_FALSE(hides_inside(scene, Vec3(0, 1.05, 0), eye));
  // The horizon as seen from 5 m lies 0.2 m before the middle of a ball of 1 m.
  EXPECT_TRUE(hides_inside(scene, 1.05 * Vec3(std::sqrt(1 - 0.3 * 0.3), -0.3, 0), eye));
  EXPECT_FALSE(hides_inside(scene, 1.05 * Vec3(std::sqrt(1 - 0.1 * 0.1), -0.1, 0), eye));
}

}  // namespace
}  // namespace weir
