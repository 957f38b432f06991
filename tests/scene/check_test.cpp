// Rules between fields, on scenes built in C++: the path and the text of each.
#include "scene/check.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "scene/memory.h"
#include "scene/sampling.h"

namespace weir {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Scene scene_in(int dimension) {
  Scene scene;
  scene.name = "scene";
  scene.dimension = dimension;
  scene.duration = 2;
  scene.particle_spacing = 0.1;
  const double z = dimension == 3 ? 1 : 0;
  scene.fluid.volumes.push_back({Box{{0, 0, 0}, {1, 1, z}}, Vec3(0), Vec3(0)});
  return scene;
}

std::vector<std::string> said(const Scene& scene) {
  std::vector<std::string> all;
  for (const Violation& violation : check(scene)) all.push_back(violation.path + " " + violation.message);
  return all;
}

std::vector<std::string> said_of_shape(const Shape& shape, int dimension = 2) {
  Scene scene = scene_in(dimension);
  scene.fluid.volumes = {{shape, Vec3(0), Vec3(0)}};
  return said(scene);
}

std::vector<std::string> said_of_walls(std::vector<Wall> walls, int dimension = 2) {
  Scene scene = scene_in(dimension);
  scene.walls = std::move(walls);
  return said(scene);
}

TEST(Check, AcceptsValidScenes) {
  EXPECT_THAT(said(scene_in(2)), IsEmpty());
  EXPECT_THAT(said(scene_in(3)), IsEmpty());
  EXPECT_THAT(said_of_walls({{Tank{{0, 0, 0}, {3, 2, 0}, {Side::top}}, 2, {}}}), IsEmpty());
  EXPECT_THAT(said_of_walls({{Tank{{0, 0, 0}, {1, 1, 0}, {}}, 2, {}}}), IsEmpty());
}

TEST(Check, RefusesScenesWithoutFluid) {
  Scene scene = scene_in(2);
  scene.fluid.volumes.clear();
  EXPECT_THAT(said(scene), ElementsAre("fluid.volumes needs at least 1"));
}

TEST(Check, RefusesNamesThatCannotNameAFolder) {
  Scene scene = scene_in(2);
  for (const char* name : {"a", "Dam-break_2.5", "_", "2"}) {
    scene.name = name;
    EXPECT_THAT(said(scene), IsEmpty()) << name;
  }
  for (const char* name : {"", ".", "..", ".hidden", "-o", "a/b", "a b", "dämme", "a\nb", "c:d"}) {
    scene.name = name;
    EXPECT_THAT(said(scene), ElementsAre(testing::StartsWith("name must "))) << name;
  }
  scene.name = std::string(200, 'a');
  EXPECT_THAT(said(scene), IsEmpty());
  scene.name += 'a';
  EXPECT_THAT(said(scene), ElementsAre("name must have at most 200 characters, got 201"));
}

TEST(Check, ComparesFieldsBuiltInCppWithTheTable) {
  Scene scene = scene_in(2);
  scene.duration = std::numeric_limits<double>::quiet_NaN();
  scene.gravity.y = std::numeric_limits<double>::infinity();
  scene.render.size = {1921, 1080};
  scene.solver.exponent = 0;
  scene.output.movie->quality = 52;
  EXPECT_THAT(said(scene), ElementsAre("duration must be finite", "gravity.1 must be finite",
                                       "solver.exponent must be at least 1 and at most 7, got 0",
                                       "render.size.0 must be a multiple of 2, got 1921",
                                       "output.movie.quality must be at least 0 and at most 51, got 52"));
  scene = scene_in(2);
  scene.particle_spacing = 0;
  EXPECT_THAT(said(scene), ElementsAre("particles.spacing must be above 0 m, got 0"));
}

TEST(Check, NamesBothVolumesThatOverlap) {
  const auto with_second = [](const Shape& shape) {
    Scene scene = scene_in(2);
    scene.fluid.volumes.push_back({shape, Vec3(0), Vec3(0)});
    return said(scene);
  };
  const auto overlap = [](const std::string& key) {
    return ElementsAre("fluid.volumes.1." + key + " overlaps fluid.volumes.0.box");
  };
  EXPECT_THAT(with_second(Box{{0.5, 0.5, 0}, {2, 2, 0}}), overlap("box"));
  EXPECT_THAT(with_second(Box{{0.997, 0, 0}, {2, 1, 0}}), overlap("box"));
  EXPECT_THAT(with_second(Box{{-1, -1, 0}, {2, 2, 0}}), overlap("box"));  // around it
  EXPECT_THAT(with_second(Box{{1, 0, 0}, {2, 1, 0}}), IsEmpty());         // beside it
  EXPECT_THAT(with_second(Ball{{0.5, 0.5, 0}, 0.2}), overlap("disc"));
  EXPECT_THAT(with_second(Ball{{1.5, 0.5, 0}, 0.5}), IsEmpty());
  EXPECT_THAT(with_second(Polygon{{{0.8, 0.5, 0}, {2, 0, 0}, {2, 1, 0}}}), overlap("polygon"));
  EXPECT_THAT(with_second(Polygon{{{1, 0.5, 0}, {2, 0, 0}, {2, 1, 0}}}), IsEmpty());
}

TEST(Check, NamesEachOfManyCoincidingVolumes) {
  Scene scene = scene_in(2);
  scene.fluid.volumes.assign(400, {Ball{{0, 0, 0}, 2}, Vec3(0), Vec3(0)});
  const std::vector<std::string> all = said(scene);  // minutes, were each compared with each by its particles
  ASSERT_EQ(all.size(), 399U);
  EXPECT_EQ(all.front(), "fluid.volumes.1.disc overlaps fluid.volumes.0.disc");
  EXPECT_EQ(all.back(), "fluid.volumes.399.disc overlaps fluid.volumes.0.disc and 398 more");
}

TEST(Check, RefusesFluidOutsideClosedWalls) {
  const auto walls = [](const WallShape& shape) { return said_of_walls({{shape, 1, {}}}); };
  const std::vector<Vec3> square{{2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {2, 1, 0}};
  const std::string all_outside =
      "fluid.volumes.0.box lies outside the closed walls: 100 of 100 particles, such as at (0.05, 0.05)";
  EXPECT_THAT(walls(Tank{{2, 0, 0}, {3, 1, 0}, {}}), ElementsAre(all_outside));
  EXPECT_THAT(walls(Tank{{2, 0, 0}, {3, 1, 0}, {Side::top}}), IsEmpty());
  EXPECT_THAT(walls(Polyline{square, true, Flank::right}), ElementsAre(all_outside));
  EXPECT_THAT(walls(Polyline{square, true, Flank::left}), IsEmpty());  // an obstacle beside it
  EXPECT_THAT(walls(Polyline{square, false, Flank::right}), IsEmpty());
  EXPECT_THAT(walls(PolygonWall{square, Face::outside}), ElementsAre(all_outside));
  EXPECT_THAT(walls(PolygonWall{square, Face::inside}), IsEmpty());
  EXPECT_THAT(walls(Round{{3, 0.5, 0}, 1, Face::outside}), ElementsAre(all_outside));
  EXPECT_THAT(walls(Round{{0.5, 0.5, 0}, 1, Face::outside}), IsEmpty());
  // An outline with a hole is not closed.
  EXPECT_THAT(said_of_walls({{Tank{{2, 0, 0}, {3, 1, 0}, {}}, 1, {Box{{3, 0.4, 0}, {3.2, 0.6, 0}}}}}), IsEmpty());
}

TEST(Check, RefusesFluidInWalls) {
  const auto walls = [](const WallShape& shape) { return said_of_walls({{shape, 1, {}}}); };
  EXPECT_THAT(walls(Tank{{0.5, 0, 0}, {3, 2, 0}, {Side::top}}),
              ElementsAre("fluid.volumes.0.box reaches into walls.0.tank"));
  EXPECT_THAT(walls(Block{{-1, -1, 0}, {2, 2, 0}}), ElementsAre("fluid.volumes.0.box reaches into walls.0.box"));
  EXPECT_THAT(walls(Round{{0.5, 0.5, 0}, 2, Face::inside}),
              ElementsAre("fluid.volumes.0.box reaches into walls.0.disc"));
  EXPECT_THAT(walls(PolygonWall{{{-9, -1, 0}, {9, -1, 0}, {0, 20, 0}}, Face::inside}),  // its layers are far away
              ElementsAre("fluid.volumes.0.box reaches into walls.0.polygon"));
  EXPECT_THAT(walls(PolygonWall{{{0.5, -1, 0}, {3, 3, 0}, {-1, 3, 0}}, Face::outside}),
              ElementsAre("fluid.volumes.0.box reaches into walls.0.polygon",
                          HasSubstr("fluid.volumes.0.box lies outside the closed walls")));
  EXPECT_THAT(walls(Polyline{{{0.5, -1, 0}, {0.5, 2, 0}}, false, Flank::left}),
              ElementsAre("fluid.volumes.0.box reaches into walls.0.polyline"));
  // A box that is no multiple of the spacing, in a tank of its size, is rounded but not in the wall.
  for (const double size : {0.95, 0.96, 1.04, 1.05}) {
    Scene scene = scene_in(2);
    scene.fluid.volumes = {{Box{{0, 0, 0}, {size, 0.5, 0}}, Vec3(0), Vec3(0)}};
    scene.walls = {{Tank{{0, 0, 0}, {size, 2, 0}, {}}, 2, {}}};
    EXPECT_THAT(said(scene), IsEmpty()) << size;
  }
}

TEST(Check, RefusesDegenerateShapes) {
  EXPECT_THAT(said_of_shape(Box{{0, 1, 0}, {1, 0, 0}}),
              ElementsAre("fluid.volumes.0.box.max must lie above min along y: min is 1, max is 0"));
  EXPECT_THAT(said_of_shape(Box{{0, 0, 0}, {1, 0.05, 0}}),
              ElementsAre("fluid.volumes.0.box is smaller than a particle along y: 0.05 m at a spacing of 0.1 m"));
  EXPECT_THAT(said_of_shape(Ball{{0, 0, 0}, 0.01}),
              ElementsAre("fluid.volumes.0.disc is smaller than a particle at a spacing of 0.1 m"));
  EXPECT_THAT(said_of_shape(Polygon{{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}}),
              ElementsAre("fluid.volumes.0.polygon.points makes edges that cross: those from points 0 and 2"));
  EXPECT_THAT(said_of_shape(Polygon{{{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}}),
              ElementsAre("fluid.volumes.0.polygon.points lie on one line and enclose nothing"));
  EXPECT_THAT(said_of_shape(Polygon{{{0, 0, 0}, {1, 1, 0}}}),
              ElementsAre("fluid.volumes.0.polygon.points needs at least 3, got 2"));
  EXPECT_THAT(said_of_shape(Polygon{{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}}}, 3),
              ElementsAre("fluid.volumes.0 is a shape of 2D scenes"));
  EXPECT_THAT(said_of_walls({{Polyline{{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}}, false, Flank::right}, 1, {}}}),
              ElementsAre("walls.0.polyline.points.1 repeats the point before it"));
  // Two points so near that the piece between them has no direction in double precision.
  EXPECT_THAT(said_of_walls({{Polyline{{{5, 5, 0}, {5, 5 + 1e-15, 0}, {6, 5, 0}}, false, Flank::right}, 1, {}}}),
              ElementsAre("walls.0.polyline.points.1 repeats the point before it"));
  EXPECT_THAT(said_of_walls({{Polyline{{{0, 0, 0}, {0, -1e-200, 0}, {-1, -1, 0}}, false, Flank::right}, 1, {}}}),
              ElementsAre("walls.0.polyline.points.1 repeats the point before it"));
  EXPECT_THAT(said_of_walls({{Polyline{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1e-200, 0}}, true, Flank::right}, 1, {}}}),
              ElementsAre("walls.0.polyline.points.3 repeats the first point"));
  const auto polygon = [](const std::vector<Vec3>& points) {
    return said_of_walls({{PolygonWall{points, Face::inside}, 1, {}}});
  };
  EXPECT_THAT(polygon({{3, 0, 0}, {4, 1, 0}, {4, 0, 0}, {3, 1, 0}}),
              ElementsAre("walls.0.polygon.points makes edges that cross: those from points 0 and 2"));
  EXPECT_THAT(polygon({{3, 0, 0}, {4, 1, 0}, {5, 2, 0}}),
              ElementsAre("walls.0.polygon.points lie on one line and enclose nothing"));
  EXPECT_THAT(polygon({{3, 0, 0}, {4, 1, 0}}), ElementsAre("walls.0.polygon.points needs at least 3, got 2"));
  EXPECT_THAT(polygon({{3, 0, 0}, {4, 1, 0}, {3, 0, 0}}),
              ElementsAre("walls.0.polygon.points needs at least 3 points to close"));
  EXPECT_THAT(polygon({{3, 0, 0}, {4, 1, 0}, {4, 1, 0}, {3, 1, 0}}),
              ElementsAre("walls.0.polygon.points.2 repeats the point before it"));
  EXPECT_THAT(polygon({{3, 0, 0}, {4, 1, 0}, {3, 1, 0}, {3, 1e-12, 0}}),
              ElementsAre("walls.0.polygon.points.3 repeats the first point"));
  EXPECT_THAT(polygon({{3, 0, 0}, {4, 1, 0}, {3, 1, 0}, {3, 0, 0}}), IsEmpty());  // a ring in full
  EXPECT_THAT(said_of_walls({{Tank{{0, 0, 0}, {1, 1, 0}, {Side::back}}, 1, {}}}),
              ElementsAre("walls.0.tank.open names front or back; a 2D tank has left, right, bottom and top"));
  EXPECT_THAT(said_of_walls({{Tank{{0, 0, 0}, {1, 1, 0}, {}}, 1, {Box{{1, 1, 0}, {0, 2, 0}}}}}),
              ElementsAre("walls.0.tank.holes.0.box.max must lie above min along x: min is 1, max is 0"));
}

TEST(Check, RefusesWallsThatMakeNoParticle) {
  const auto refused = [](const std::string& key) {
    return ElementsAre("walls.0." + key +
                       " makes no particle at a spacing of 0.1 m: make it thicker, or the spacing smaller");
  };
  EXPECT_THAT(said_of_walls({{PolygonWall{{{3, 0, 0}, {5, 0, 0}, {5, 0.09, 0}}, Face::inside}, 2, {}}}),
              refused("polygon"));
  EXPECT_THAT(said_of_walls({{Round{{3, 0, 0}, 0.04, Face::inside}, 2, {}}}), refused("disc"));
  EXPECT_THAT(said_of_walls({{Block{{3, 0, 0}, {4, 0.01, 0}}, 2, {}}}), IsEmpty());
}

TEST(Check, RefusesMoreParticlesThanFit) {
  const auto with_spacing = [](double spacing) {
    Scene scene = scene_in(3);
    scene.particle_spacing = spacing;
    return said(scene);
  };
  EXPECT_THAT(
      with_spacing(1e-5),
      ElementsAre(HasSubstr("particles.spacing of 1.0e-05 m makes about 1e+15 particles, more than can be counted; "
                            "choose at least 0.00")));
  EXPECT_THAT(with_spacing(1.0 / 1290), ElementsAre(HasSubstr("particles, which need ")));  // 2.1e9, a terabyte or more
  // Sizes that no number of particles can be counted for.
  EXPECT_THAT(with_spacing(1e-300), ElementsAre(HasSubstr("fluid.volumes.0.box reaches 1 m from the origin")));
  EXPECT_THAT(said_of_shape(Ball{{0, 0, 0}, 1e300}), ElementsAre(HasSubstr("fluid.volumes.0.disc reaches 1e+300 m")));
  EXPECT_THAT(said_of_shape(Box{{0, 0, 0}, {9e7, 9e7, 0}}), ElementsAre(HasSubstr("more than can be counted")));
  EXPECT_THAT(said_of_walls({{Block{{2, 0, 0}, {9e7, 9e7, 0}}, 100, {}}}),
              ElementsAre(HasSubstr("more than can be counted")));
}

TEST(Check, RefusesCoordinatesThatADoubleDoesNotResolve) {
  // 1e-6 2^52 spacings of 0.1 m are 4.5036e8 m.
  const auto at = [](double x) { return said_of_shape(Box{{x, 0, 0}, {x + 1, 1, 0}}); };
  EXPECT_THAT(at(4.5e8), IsEmpty());
  EXPECT_THAT(at(-4.6e8), ElementsAre("fluid.volumes.0.box reaches 4.6e+08 m from the origin; at a spacing of 0.1 m, "
                                      "positions are exact to a millionth of it only up to 4.5e+08 m"));
}

TEST(Check, RefusesSpansOfMoreTilesThanTheSolverCounts) {
  Scene scene = scene_in(2);
  const auto apart_by = [&](double x) {
    scene.fluid.volumes = {{Box{{0, 0, 0}, {1, 1, 0}}, Vec3(0), Vec3(0)},
                           {Box{{x, 0, 0}, {x + 1, 1, 0}}, Vec3(0), Vec3(0)}};
    return said(scene);
  };
  EXPECT_THAT(apart_by(1.6e6), IsEmpty());
  EXPECT_THAT(apart_by(1.7e6),
              ElementsAre("particles.spacing of 0.1 m: fluid and walls span 1.7e+06 m along x, more than 16777216 "
                          "spacings; choose at least 0.11 m"));
}

TEST(Check, WallsSlideOnlyWhereFrictionReachesThem) {
  Scene scene = scene_in(2);
  scene.walls = {{Tank{{0, 0, 0}, {3, 2, 0}, {Side::top}}, 2, {}, {1, 0, 0}}};
  scene.solver.wall_slip = WallSlip::free_slip;
  EXPECT_THAT(said(scene),
              ElementsAre("walls.0.tank.motion.slide needs solver.wall_slip: no_slip; it is free_slip",
                          "walls.0.tank.motion.slide needs solver.wall_pressure: extrapolated; it is mirrored"));
  scene.solver.wall_slip = WallSlip::no_slip;
  scene.solver.wall_pressure = WallPressure::extrapolated;
  EXPECT_THAT(said(scene), IsEmpty());
}

TEST(Check, SamplesThinShapesOfAnyLengthInTime) {
  // A sliver with a bounding box of 1e10 cells, and a block of 1e8 of which only the skin is wall.
  EXPECT_THAT(said_of_shape(Polygon{{{0, 0, 0}, {1e4, 1e4, 0}, {1e4, 1e4 + 0.5, 0}}}), IsEmpty());
  EXPECT_THAT(said_of_walls({{Block{{2, 0, 0}, {1e3, 1e3, 0}}, 2, {}}}), IsEmpty());
}

TEST(Check, RefusesInvalidTimelines) {
  Scene scene = scene_in(2);
  const auto event = [](double at, double over, const Settings& set) {
    return TimelineEvent{at, over, set, false, {}};
  };
  Settings gravity;
  gravity.gravity = Vec3(1, 0, 0);
  Settings viscous;
  viscous.viscosity = 0.1;
  Settings tension;
  tension.surface_tension = 1;
  Settings stiff;
  stiff.stiffness = 10;
  Settings sound;
  sound.sound_speed = 10;

  scene.timeline = {event(0.5, 0.5, gravity), event(1, 0, gravity), event(1, 1, stiff), event(2, 0, sound)};
  EXPECT_THAT(said(scene), IsEmpty());
  scene.timeline = {event(3, 0, gravity)};
  EXPECT_THAT(said(scene), ElementsAre("timeline.0.at lies beyond the duration of 2 s, got 3"));
  scene.timeline = {event(1, 0, gravity), event(0.5, 0, gravity)};
  EXPECT_THAT(said(scene), ElementsAre("timeline.1.at lies before timeline.0.at; events stand in the order of time"));
  scene.timeline = {event(0, 1, stiff), event(0.5, 0, gravity), event(0.75, 0, sound)};
  EXPECT_THAT(said(scene),
              ElementsAre("timeline.2.at is 0.75 s, when timeline.0 still changes the same setting (until 1 s)"));
  scene.timeline = {event(1, 0, gravity), event(1, 0, gravity)};
  EXPECT_THAT(said(scene),
              ElementsAre("timeline.1.at is 1 s, when timeline.0 still changes the same setting (until 1 s)"));
  scene.timeline = {event(1, 0, {})};
  EXPECT_THAT(said(scene), ElementsAre("timeline.0 does nothing; give it set, reset or pause"));
  scene.timeline = {{1, 0.5, {}, true, {}}};
  EXPECT_THAT(said(scene), ElementsAre("timeline.0.over needs settings to change, in `set`"));
  scene.fluid.viscosity.model = ViscosityModel::none;
  scene.timeline = {event(0, 0, viscous), event(1, 0, tension)};
  EXPECT_THAT(said(scene),
              ElementsAre("timeline.0.set.fluid.viscosity.kinematic has no effect: fluid.viscosity.model is none",
                          "timeline.1.set.fluid.surface_tension.coefficient has no effect: fluid.surface_tension.model "
                          "is none"));
  stiff.sound_speed = 1;
  scene.timeline = {event(0, 0, stiff)};
  EXPECT_THAT(said(scene),
              ElementsAre("timeline.0.set.solver.sound_speed stands beside solver.stiffness; give one of them"));
}

TEST(Check, RefusesInvalidCameras) {
  Scene scene = scene_in(2);
  scene.camera.view = View3D{{0, 0, 5}, {0, 0, 0}, 35};
  EXPECT_THAT(said(scene), ElementsAre("camera.view is a view of a 3D scene; a 2D scene needs center and width"));
  scene = scene_in(3);
  scene.camera.view = View2D{{0, 0, 0}, 1};
  EXPECT_THAT(said(scene), ElementsAre("camera.view is a view of a 2D scene; a 3D scene needs eye and target"));
  scene.camera.view = View3D{{1, 0, 0}, {1, 0, 0}, 35};
  EXPECT_THAT(said(scene), ElementsAre("camera.view.target lies in the eye; give the camera something to look at"));
  scene = scene_in(2);
  scene.camera.keyframes = {{0, View2D{}}, {1, View2D{}}, {1, View2D{}}};
  EXPECT_THAT(said(scene), ElementsAre("camera.keyframes.2.at must come after 1 s, the keyframe before it, got 1"));
  scene.camera.keyframes = {{0, AutoView{}}};
  EXPECT_THAT(said(scene), ElementsAre("camera.keyframes.0 needs a view of its own"));
}

TEST(Check, RefusesInvalidPicturesAndOutput) {
  Scene scene = scene_in(2);
  scene.render.color.range = {{5, 5}};
  EXPECT_THAT(said(scene), ElementsAre("render.color.range must rise, got [5, 5]"));
  scene = scene_in(2);
  scene.output.stills = {0, 2, 0.01, 2.5};
  EXPECT_THAT(
      said(scene),
      ElementsAre("output.stills.2 is no frame time: at 60 frames per second the nearest is 0.016666666666666666 s, "
                  "got 0.01",
                  "output.stills.3 lies beyond the last frame at 2 s, got 2.5"));
  scene.output.stills = {1.0 / 3, 0.1};  // frames 20 and 6, as well as doubles can say
  EXPECT_THAT(said(scene), IsEmpty());
  scene = scene_in(2);
  scene.render.transparent = true;
  EXPECT_THAT(said(scene),
              ElementsAre("render.transparent has no effect: only output.frames and output.stills can be transparent"));
  scene = scene_in(2);
  scene.output.log.every = 1e-10;
  EXPECT_THAT(said(scene), ElementsAre("output.log.every makes 2e+10 rows; a log has at most 1e+09"));
  scene = scene_in(2);
  scene.duration = 1e300;
  EXPECT_THAT(said(scene), ElementsAre(HasSubstr("duration makes 6e+301 frames at 60 per second")));
}

TEST(Scene, CountsFramesToTheLastDigit) {
  Scene scene = scene_in(2);
  for (const auto& [duration, fps, last] : std::initializer_list<std::tuple<double, int, std::int64_t>>{
           {2, 60, 120}, {0.7, 10, 7}, {0.1, 30, 3}, {1.0 / 3, 60, 20}, {0.09, 10, 0}, {1.99, 1, 1}}) {
    scene.duration = duration;
    scene.render.fps = fps;
    EXPECT_EQ(last_frame(scene), last) << duration;
  }
}

TEST(Scene, DerivesStiffnessAndSoundSpeedFromEachOther) {
  Scene scene = scene_in(2);
  scene.solver.compressibility = Stiffness{7000};
  EXPECT_DOUBLE_EQ(sound_speed(scene), 7);  // sqrt(7 7000 / 1000)
  scene.solver.compressibility = SoundSpeed{7};
  EXPECT_DOUBLE_EQ(stiffness(scene), 7000);
}

TEST(Scene, StartsFromItsOwnParameters) {
  Scene scene = scene_in(2);
  scene.gravity = Vec3(1, 2, 0);
  scene.fluid.viscosity.kinematic = 3;
  scene.fluid.surface_tension.coefficient = 4;
  scene.solver.compressibility = SoundSpeed{7};
  const Parameters parameters = initial_parameters(scene);
  EXPECT_EQ(parameters.gravity, Vec3(1, 2, 0));
  EXPECT_EQ(parameters.viscosity, 3);
  EXPECT_EQ(parameters.surface_tension, 4);
  EXPECT_DOUBLE_EQ(parameters.stiffness, 7000);
}

TEST(Scene, EstimatesTheTopSpeedByFalling) {
  Scene scene = scene_in(2);
  scene.walls = {{Tank{{0, -1, 0}, {3, 2, 0}, {Side::top}}, 2, {}}};
  EXPECT_DOUBLE_EQ(max_speed_estimate(scene), std::sqrt(2 * 9.81 * 2));  // from y = 1 to the floor at y = -1
  scene.walls.clear();
  EXPECT_DOUBLE_EQ(max_speed_estimate(scene), 9.81 * 2);  // for the whole run
  scene.fluid.volumes[0].velocity = Vec3(3, 4, 0);
  EXPECT_DOUBLE_EQ(max_speed_estimate(scene), 5 + 9.81 * 2);
  scene.gravity = Vec3(0);
  EXPECT_DOUBLE_EQ(max_speed_estimate(scene), 5);
  scene.fluid.volumes[0].flow.taylor_green = TaylorGreen{2, 1};
  EXPECT_DOUBLE_EQ(max_speed_estimate(scene), 7);
  scene.walls = {{Block{{2, 0, 0}, {3, 1, 0}}, 0, {}, {0, 8, 0}}};
  EXPECT_DOUBLE_EQ(max_speed_estimate(scene), 8);
}

TEST(Estimate, CountsWhatIsSampled) {
  Scene scene = scene_in(2);
  scene.fluid.volumes = {{Box{{0, 0, 0}, {1.04, 1, 0}}, Vec3(0), Vec3(0)}};
  scene.walls = {{Tank{{0, 0, 0}, {3, 2, 0}, {Side::top}}, 2, {}}};
  const Estimate cost = estimate(scene);
  EXPECT_EQ(cost.fluid_particles, 100);
  EXPECT_EQ(cost.wall_particles, 34 * 22 - 30 * 20);
  EXPECT_NEAR(cost.mass, 1000, 1e-9);
  EXPECT_NEAR(cost.mass_error, 1 / 1.04 - 1, 1e-12);
  // acoustic: h / (c0 + v) with c0 = sqrt(7 1e5 / 1000), v = sqrt(2 g 1)
  EXPECT_NEAR(cost.dt, 0.1 / (std::sqrt(700) + std::sqrt(2 * 9.81)), 1e-12);
  EXPECT_EQ(cost.steps, 120 * static_cast<std::int64_t>(std::ceil(1.0 / 60 / cost.dt)));
}

// Largest resident sets, measured without pictures (Wendland C2, no other work beside), less 25 MB of program: 10,017,225
// fluid and 63,018 wall particles in 2D, h = 1.3 dx: 1076 MB; 9,938,375 and 2,372,178 in 3D, h = 1.2 dx: 1829 MB.
TEST(Estimate, AsksForALittleMoreMemoryThanARunTook) {
  struct Run {
    int dimension;
    double smoothing, fluid, walls, bytes;
  };
  for (const Run& run : {Run{2, 1.3, 10017225, 63018, 1076e6}, Run{3, 1.2, 9938375, 2372178, 1829e6}}) {
    Scene scene = scene_in(run.dimension);
    scene.solver.kernel = {KernelName::wendland_c2, run.smoothing};
    scene.output.movie.reset();
    const double asked = run.fluid * bytes_per_particle(scene) + run.walls * bytes_per_wall_particle(scene);
    EXPECT_GT(asked, run.bytes) << run.dimension;
    EXPECT_LT(asked, 1.15 * run.bytes) << run.dimension;
  }
  Scene scene = scene_in(2);
  scene.output.movie.reset();
  const auto bytes = [&] { return bytes_per_particle(scene); };
  const double without = bytes();
  scene.output.movie = Movie{};
  EXPECT_NEAR(bytes() - without, 5 * 4 * sizeof(float), 1e-9);  // x, y, z and the colour's quantity in five buffers
  scene.solver.kernel.smoothing = 2;                            // (4.4 / 2.4)^2 times the neighbours
  EXPECT_GT(bytes(), without + 2 * 15);
  scene = scene_in(3);
  scene.output.movie.reset();
  EXPECT_GT(bytes(), without + 50);
}

}  // namespace
}  // namespace weir
