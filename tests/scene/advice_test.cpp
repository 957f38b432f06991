#include "scene/advice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/scenes.h"

namespace weir {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Advice, WarnsOfMirroredWallsWhereViscosityIsLow) {
  Scene scene = small_dam_break(2, 0.02);
  scene.solver.compressibility = SoundSpeed{10};  // 0.01 h c0 = 0.002 m^2/s
  scene.fluid.viscosity = {ViscosityModel::morris, 0.0019};
  EXPECT_THAT(advice(scene),
              ElementsAre(HasSubstr("fluid.viscosity.kinematic is 0.0019 m^2/s: below about 0.01 h c0 = 0.002")));
  scene.fluid.viscosity.kinematic = 0.0021;
  EXPECT_THAT(advice(scene), IsEmpty());
  scene.fluid.viscosity.model = ViscosityModel::none;
  EXPECT_THAT(advice(scene), ElementsAre(HasSubstr("kinematic is 0 m^2/s")));
  scene.solver.wall_pressure = WallPressure::extrapolated;
  EXPECT_THAT(advice(scene), IsEmpty());
  scene.solver.wall_pressure = WallPressure::mirrored;
  scene.walls.clear();
  EXPECT_THAT(advice(scene), IsEmpty());
}

}  // namespace
}  // namespace weir
