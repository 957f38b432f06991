// Pictures of given particles against committed ones.
#include <gtest/gtest.h>

#include "render/test_scene.h"
#include "support/golden.h"

namespace weir::test {
namespace {

testing::AssertionResult drawing_matches(const Still& still, const std::string& name) {
  const auto renderer = make_renderer(still.scene, still.static_scene, device_choice(""));
  Image image;
  renderer->draw(still.frame, image);
  return matches_golden(image, "render/" + name, renderer->gl_renderer());
}

TEST(DrawingGolden, DamBreak) { EXPECT_TRUE(drawing_matches(dam_break(), "dam_break")); }

TEST(DrawingGolden, DarkWithUnmetCondition) {
  Still still = dam_break();
  still.scene.render.theme = Theme::dark;
  still.scene.render.color.map = ColormapName::turbo;
  still.frame.cfl = 0.612;
  still.frame.cfl_met = false;
  EXPECT_TRUE(drawing_matches(still, "dam_break_dark"));
}

TEST(DrawingGolden, TransparentWithoutWalls) {
  Still still = dam_break();
  still.scene.render.transparent = true;
  still.scene.render.walls = false;
  still.scene.render.color.map = ColormapName::cividis;
  EXPECT_TRUE(drawing_matches(still, "dam_break_transparent"));
}

TEST(DrawingGolden, NearView) {
  Still still = dam_break();
  still.scene.camera.view = View2D{Vec3(1, 0.2, 0), 0.5};
  still.scene.render.color.map = ColormapName::magma;
  EXPECT_TRUE(drawing_matches(still, "near_view"));
}

TEST(DrawingGolden, DensityOnLargerPicture) {
  Still still = dam_break();
  still.scene.render.size = {640, 480};
  still.scene.render.color = {Quantity::density, ColormapName::coolwarm, {{990, 1010}}};
  for (glm::vec4& particle : still.frame.particles) particle.w = 1000 + 4 * (particle.w - 2);
  EXPECT_TRUE(drawing_matches(still, "density"));
}

TEST(DrawingGolden, ThreeDimensions) { EXPECT_TRUE(drawing_matches(cup(), "cup")); }

TEST(DrawingGolden, ReportsDifferences) {
  Image a{2, 1, {10, 20, 30, 255, 1, 2, 3, 255}};
  Image b = a;
  EXPECT_EQ(difference(a, b).pixels, 0);
  b.rgba[5] = 7;
  b.rgba[6] = 4;
  EXPECT_EQ(difference(a, b).pixels, 1);
  EXPECT_EQ(difference(a, b).largest, 5);
}

}  // namespace
}  // namespace weir::test
