// --set KEY=VALUE.
#include <gmock/gmock.h>

#include "scene/texts.h"

namespace weir {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string with_list = shortest_text +
                              "walls:\n  - tank: {min: [0, 0], max: [3, 2], open: [top]}\n"
                              "timeline:\n  - {at: 1, set: {gravity: [1, 0]}}\n"
                              "solver: {stiffness: 1000}\noutput: {movie: false}\n";

TEST(Overrides, ReplaceAndAddValues) {
  EXPECT_EQ(scene_of(with_list, {"duration=5"}).duration, 5);
  EXPECT_EQ(scene_of(with_list, {"render.fps=30"}).render.fps, 30);  // the file has no render
  EXPECT_EQ(scene_of(with_list, {"output.movie.quality=3"}).output.movie->quality, 3);
  EXPECT_EQ(scene_of(with_list, {"duration=5", "duration=6"}).duration, 6);
  EXPECT_EQ(scene_of(with_list, {"render={fps: 24, theme: dark}"}).render.fps, 24);
  EXPECT_EQ(scene_of(with_list, {"title=a=b"}).title, "a=b");
}

TEST(Overrides, ReachIntoListsByNumber) {
  EXPECT_THAT(std::get<Tank>(scene_of(with_list, {"walls.0.tank.open=[top, left]"}).walls[0].shape).open,
              ElementsAre(Side::top, Side::left));
  EXPECT_EQ(std::get<Tank>(scene_of(with_list, {"walls.0.tank.max.1=9"}).walls[0].shape).max, Vec3(3, 9, 0));
  EXPECT_EQ(scene_of(with_list, {"walls.1={box: {min: [2, 0], max: [2.5, 0.5]}}"}).walls.size(), 2U);
  EXPECT_EQ(scene_of(shortest_text, {"timeline.0={at: 1, pause: true}"}).timeline.size(), 1U);
}

TEST(Overrides, TakeAllAfterSetAsOneKey) {
  const Scene scene = scene_of(with_list, {"timeline.0.set.fluid.viscosity.kinematic=0.5"});
  EXPECT_EQ(scene.timeline[0].set.viscosity, 0.5);
  EXPECT_EQ(scene.timeline[0].set.gravity, Vec3(1, 0, 0));
}

TEST(Overrides, TakeKeysOutWithNull) {
  const Scene scene = scene_of(with_list, {"solver.stiffness=null", "solver.sound_speed=20", "walls.0="});
  EXPECT_EQ(std::get<SoundSpeed>(scene.solver.compressibility).c0, 20);
  EXPECT_TRUE(scene.walls.empty());
}

TEST(Overrides, AreCitedWhenWrong) {
  EXPECT_THAT(mistakes_in(with_list, {"duration=-1"}),
              ElementsAre("--set duration=-1: duration must be above 0 s, got -1"));
  EXPECT_THAT(
      mistakes_in(with_list, {"solver.sound_speed=20"}),
      ElementsAre("--set solver.sound_speed=20: solver.sound_speed stands beside solver.stiffness; give one of them"));
  EXPECT_THAT(mistakes_in(with_list, {"render.fsp=20"}),
              ElementsAre("--set render.fsp=20: unknown key 'render.fsp'; did you mean 'fps'?"));
  EXPECT_THAT(mistakes_in(with_list, {"walls.3.tank.layers=2"}),
              ElementsAre("--set walls.3.tank.layers=2: walls is a list of 1: its elements are numbered from 0, and 1 "
                          "would add one; '3' names none"));
  EXPECT_THAT(mistakes_in(with_list, {"gravity=[1}"}), ElementsAre(HasSubstr("--set gravity=[1}: not YAML: ")));
  EXPECT_THAT(mistakes_in(with_list, {"title=\xFF"}), ElementsAre(HasSubstr("not UTF-8")));
  EXPECT_THAT(mistakes_in(with_list, {"fluid.volumes.0.box.max=[9, 9]"}),
              ElementsAre("--set fluid.volumes.0.box.max=[9, 9]: fluid.volumes.0.box reaches into walls.0.tank"));
}

TEST(Overrides, StandAfterTheMistakesOfTheFile) {
  EXPECT_THAT(
      mistakes_in(shortest_text + "titel: x\n", {"render.fps=0", "duration=0"}),
      ElementsAre(HasSubstr("s.yaml:6:1: "), HasSubstr("--set render.fps=0: "), HasSubstr("--set duration=0: ")));
}

TEST(Overrides, NeedAKeyAndAValue) {
  for (const char* text : {"duration", "=5", ".a=5", "a.=5", "a..b=5", ""}) {
    EXPECT_THROW(parse_override(text), UsageError) << text;
  }
  EXPECT_EQ(parse_override("a.b=c=d").value, "c=d");
}

}  // namespace
}  // namespace weir
