// Each mistake in a file: its text, line and column.
#include "scene/reader.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "scene/texts.h"

namespace weir {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A line added to the shortest scene stands in line 6.
std::vector<std::string> with_line(const std::string& line) { return mistakes_in(shortest_text + line + "\n"); }

TEST(Reader, KnowsEveryQuantityThatColours) {
  for (const QuantityFacts& facts : quantities) {
    const std::string text = shortest_text + fmt::format("render: {{color: {{by: {}}}}}\n", facts.name);
    if (facts.colours()) {
      EXPECT_EQ(scene_of(text).render.color.by, facts.quantity) << facts.name;
    } else {
      EXPECT_THAT(mistakes_in(text),
                  ElementsAre(fmt::format("s.yaml:6:18: render.color.by expects one of speed, density, "
                                          "pressure, id, volume, vorticity, got '{}'",
                                          facts.name)));
    }
  }
}

TEST(Reader, ReadsTheShortestScene) {
  const Scene scene = scene_of(shortest_text);
  EXPECT_EQ(scene.name, "s");
  EXPECT_EQ(scene.dimension, 2);
  EXPECT_EQ(scene.duration, 2);
  EXPECT_EQ(scene.particle_spacing, 0.1);
  EXPECT_EQ(scene.gravity, Vec3(0, -9.81, 0));
  ASSERT_EQ(scene.fluid.volumes.size(), 1U);
  EXPECT_EQ(std::get<Box>(scene.fluid.volumes[0].shape).max, Vec3(1, 1, 0));
}

TEST(Reader, NamesASceneAfterItsKeyOrItsFile) {
  EXPECT_EQ(read_scene_text(shortest_text, "folder/dam_break.yaml").name, "dam_break");
  EXPECT_EQ(scene_of(shortest_text + "name: other-1.5\n").name, "other-1.5");
  EXPECT_EQ(scene_of(shortest_text, {"name=third"}).name, "third");
  // A written scene reads back under the same name, whatever its file is called.
  const std::string effective = write_scene(read_scene_text(shortest_text, "folder/dam_break.yaml"));
  EXPECT_EQ(read_scene_text(effective, "scene.yaml").name, "dam_break");
  EXPECT_EQ(write_scene(read_scene_text(effective, "scene.yaml")), effective);
}

TEST(Reader, RefusesNamesThatCannotNameAFolder) {
  EXPECT_THAT(with_line("name: a/b"),
              ElementsAre("s.yaml:6:1: name must hold only letters (a-z, A-Z), digits, _ - and ., got 'a/b'"));
  EXPECT_THAT(with_line("name: .."), ElementsAre("s.yaml:6:1: name must begin with a letter, a digit or _, got '..'"));
  EXPECT_THAT(with_line("name: 2024"), ElementsAre("s.yaml:6:1: name expects text, got '2024'; put it in quotes"));
  EXPECT_THAT(with_line("name: [a]"), ElementsAre("s.yaml:6:1: name expects text, got a list"));
  EXPECT_THAT(mistakes_in(shortest_text, {"name=-x"}),
              ElementsAre("--set name=-x: name must begin with a letter, a digit or _, got '-x'"));
}

TEST(Reader, AsksForANameWhereTheFilesOwnIsNone) {
  try {
    read_scene_text(shortest_text, "my scene.yaml");
    FAIL();
  } catch (const SceneError& error) {
    ASSERT_EQ(error.mistakes.size(), 1U);
    EXPECT_EQ(error.mistakes[0].where, "my scene.yaml:1:1");
    EXPECT_EQ(error.mistakes[0].message,
              "name, by default the file's, must hold only letters (a-z, A-Z), digits, _ - and ., got 'my scene'");
  }
  EXPECT_EQ(read_scene_text(shortest_text + "name: mine\n", "my scene.yaml").name, "mine");
}

TEST(Reader, PointsGravityDownwardsInEachDimension) {
  EXPECT_EQ(scene_of(shortest_3d_text).gravity, Vec3(0, 0, -9.81));
  EXPECT_EQ(scene_of(shortest_3d_text + "gravity: [1, 2, 3]\n").gravity, Vec3(1, 2, 3));
}

TEST(Reader, ReadsEveryKeyOfTheSketch) {
  const Scene scene = scene_of(R"(weir: 1
title: Dam break
dimension: 2
duration: 2.0
gravity: [0, -9.81]
particles: {spacing: 0.01}
fluid:
  rest_density: 998
  viscosity: {model: monaghan, kinematic: 1.0e-5}
  surface_tension: {model: hinsch2024, coefficient: 0.5}
  volumes:
    - box: {min: [0, 0], max: [1, 1]}
      velocity: [1, 2]
      angular_velocity: 3
walls:
  - tank: {min: [0, 0], max: [3, 2], open: [top], layers: 2}
  - polyline: {points: [[1, 0.5], [2, 0.5]], solid: left, holes: [{disc: {center: [1.5, 0.5], radius: 0.1}}]}
  - polygon: {points: [[2.4, 0.4], [2.8, 0.4], [2.6, 0.8], [2.4, 0.4]], solid: inside, layers: 3}
periodic: []
bodies: []
solver:
  method: wcsph
  kernel: {name: wendland_c2, smoothing: 1.5}
  sound_speed: 30
  exponent: 1
  negative_pressure: keep
  wall_slip: free_slip
  time_step: {fixed: 1.0e-4}
timeline:
  - {at: 1.0, over: 0.2, set: {gravity: [3, -9.81], fluid.viscosity.kinematic: 0.01}}
  - {at: 1.5, reset: true, pause: true}
camera: {view: {center: [1, 1], width: 4}}
render:
  size: [640, 480]
  fps: 30
  color: {by: pressure, map: magma, range: [0, 5]}
  overlay: [time, cfl]
  theme: dark
  transparent: true
  walls: false
probes: []
output: {movie: {quality: 10}, frames: true, stills: [0, 0.5], log: {every: 0.1}, particles: {every: 0.5, fields: [velocity, id]}, checkpoint: false}
)");
  EXPECT_EQ(scene.title, "Dam break");
  EXPECT_EQ(scene.fluid.rest_density, 998);
  EXPECT_EQ(scene.fluid.viscosity.model, ViscosityModel::monaghan);
  EXPECT_EQ(scene.fluid.surface_tension.coefficient, 0.5);
  EXPECT_EQ(scene.fluid.volumes.at(0).velocity, Vec3(1, 2, 0));
  EXPECT_EQ(scene.fluid.volumes.at(0).angular_velocity, Vec3(0, 0, 3));
  EXPECT_THAT(std::get<Tank>(scene.walls.at(0).shape).open, ElementsAre(Side::top));
  EXPECT_EQ(scene.walls.at(0).layers, 2);
  EXPECT_EQ(std::get<Polyline>(scene.walls.at(1).shape).solid, Flank::left);
  EXPECT_EQ(std::get<Ball>(scene.walls.at(1).holes.at(0)).radius, 0.1);
  EXPECT_EQ(std::get<PolygonWall>(scene.walls.at(2).shape).points.at(1), Vec3(2.8, 0.4, 0));
  EXPECT_EQ(std::get<PolygonWall>(scene.walls.at(2).shape).solid, Face::inside);
  EXPECT_EQ(scene.solver.kernel.smoothing, 1.5);
  EXPECT_EQ(std::get<SoundSpeed>(scene.solver.compressibility).c0, 30);
  EXPECT_EQ(scene.solver.exponent, 1);
  EXPECT_EQ(std::get<FixedStep>(scene.solver.time_step).dt, 1e-4);
  EXPECT_EQ(scene.timeline.at(0).set.gravity, Vec3(3, -9.81, 0));
  EXPECT_EQ(scene.timeline.at(0).set.viscosity, 0.01);
  EXPECT_EQ(scene.timeline.at(0).pause, std::nullopt);
  EXPECT_EQ(scene.timeline.at(1).pause, true);
  EXPECT_EQ(std::get<View2D>(scene.camera.view).width, 4);
  EXPECT_EQ(scene.render.color.range, (std::array<double, 2>{0, 5}));
  EXPECT_EQ(scene.output.movie->quality, 10);
  EXPECT_EQ(scene.output.movie->preset, "ultrafast");
  EXPECT_THAT(scene.output.stills, ElementsAre(0, 0.5));
  EXPECT_EQ(scene.output.particles->every, 0.5);
  EXPECT_THAT(scene.output.particles->fields, ElementsAre(field_of(Quantity::velocity), field_of(Quantity::id)));
}

TEST(Reader, RefusesUnknownKeysAndGuessesWhatWasMeant) {
  EXPECT_THAT(with_line("titel: x"), ElementsAre("s.yaml:6:1: unknown key 'titel'; did you mean 'title'?"));
  EXPECT_THAT(with_line("render: {fsp: 30}"),
              ElementsAre("s.yaml:6:10: unknown key 'render.fsp'; did you mean 'fps'?"));
  EXPECT_THAT(with_line("zzzzzzzz: 1"), ElementsAre("s.yaml:6:1: unknown key 'zzzzzzzz'"));
  EXPECT_THAT(with_line("<<: {title: x}"), ElementsAre("s.yaml:6:1: merge keys (<<) are not read; write the keys out"));
}

TEST(Reader, RefusesRepeatedKeysAtAnyDepth) {
  EXPECT_THAT(with_line("dimension: 2"), ElementsAre("s.yaml:6:1: repeated key 'dimension', first at line 2"));
  EXPECT_THAT(with_line("render: {fps: 30, fps: 40, fps: 50}"),
              ElementsAre("s.yaml:6:19: repeated key 'render.fps', first at line 6",
                          "s.yaml:6:28: repeated key 'render.fps', first at line 6"));
}

TEST(Reader, NamesMissingKeysAtTheMapThatLacksThem) {
  EXPECT_THAT(
      mistakes_in("# a scene\nweir: 1\nfluid:\n  volumes:\n    - disc: {center: [0, 0]}\n      velocity: [0, 0]\n"),
      ElementsAre("s.yaml:2:1: missing key 'dimension'", "s.yaml:2:1: missing key 'duration'",
                  "s.yaml:2:1: missing key 'particles.spacing'",
                  "s.yaml:5:7: missing key 'fluid.volumes.0.disc.radius'"));
  EXPECT_THAT(mistakes_in("dimension: 2\nduration: 1\nparticles: {spacing: 1}\nfluid: {}\n"),
              ElementsAre("s.yaml:1:1: missing key 'weir'; a scene begins with 'weir: 1'",
                          "s.yaml:4:1: missing key 'fluid.volumes'"));
  EXPECT_THAT(with_line("walls: [{}]"),
              ElementsAre("s.yaml:6:9: walls.0 needs one of the keys tank, box, polyline, disc, polygon"));
}

TEST(Reader, RefusesWrongTypes) {
  EXPECT_THAT(with_line("title: [a]"), ElementsAre("s.yaml:6:1: title expects text, got a list"));
  EXPECT_THAT(with_line("title: 5"), ElementsAre("s.yaml:6:1: title expects text, got '5'; put it in quotes"));
  EXPECT_THAT(with_line("title:"), ElementsAre("s.yaml:6:1: title expects text, got nothing"));
  EXPECT_THAT(with_line("render: 5"), ElementsAre("s.yaml:6:1: render expects a map, got '5'"));
  EXPECT_THAT(with_line("render: {fps: 30.5}"),
              ElementsAre("s.yaml:6:10: render.fps expects a whole number, got 30.5"));
  EXPECT_THAT(with_line("render: {fps: \"30\"}"),
              ElementsAre("s.yaml:6:10: render.fps expects a whole number, got the text '30'"));
  EXPECT_THAT(with_line("render: {walls: yes}"),
              ElementsAre("s.yaml:6:10: render.walls expects true or false, got 'yes'"));
  EXPECT_THAT(with_line("walls: {}"), ElementsAre("s.yaml:6:1: walls expects a list, got a map"));
  EXPECT_THAT(with_line("gravity: -9.81"), ElementsAre("s.yaml:6:1: gravity expects 2 numbers [x, y], got '-9.81'"));
  EXPECT_THAT(with_line("output: {stills: 1}"),
              ElementsAre("s.yaml:6:10: output.stills expects a list of numbers, got '1'"));
  EXPECT_THAT(with_line("output: {movie: maybe}"),
              ElementsAre("s.yaml:6:10: output.movie expects true, false or a map, got 'maybe'"));
  EXPECT_THAT(with_line("camera: {view: near}"),
              ElementsAre("s.yaml:6:10: camera.view expects auto, or a map of center, width, got 'near'"));
  EXPECT_THAT(with_line("render: {color: {range: 1}}"),
              ElementsAre("s.yaml:6:18: render.color.range expects auto or two numbers [low, high], got '1'"));
  EXPECT_THAT(mistakes_in("- weir: 1\n"), ElementsAre("s.yaml:1:1: a scene is a map of keys, got a list"));
}

TEST(Reader, RefusesUnknownChoices) {
  EXPECT_THAT(
      with_line("solver: {kernel: {name: cubic_splin}}"),
      ElementsAre(
          "s.yaml:6:19: solver.kernel.name expects one of cubic_spline, wendland_c2, wendland_c4, got 'cubic_splin'; "
          "did you mean 'cubic_spline'?"));
  EXPECT_THAT(
      with_line("render: {overlay: [time, clock, time]}"),
      ElementsAre("s.yaml:6:26: render.overlay.1 expects one of title, time, colorbar, scalebar, cfl, got 'clock'",
                  "s.yaml:6:33: render.overlay holds 'time' twice"));
}

TEST(Reader, RefusesMalformedNumbers) {
  const auto said = [](const std::string& number) { return with_line("gravity: [0, " + number + "]"); };
  const std::string start = "s.yaml:6:14: gravity.1 expects a number, got '";
  EXPECT_THAT(said(".inf"), ElementsAre(start + ".inf'; infinity is not a number here"));
  EXPECT_THAT(said("-.INF"), ElementsAre(start + "-.INF'; infinity is not a number here"));
  EXPECT_THAT(said(".nan"), ElementsAre(start + ".nan'; nan is not a number here"));
  EXPECT_THAT(said("1e999"), ElementsAre(start + "1e999'; that does not fit a double-precision number"));
  EXPECT_THAT(said("0x10"), ElementsAre(start + "0x10'; write the number in decimal"));
  EXPECT_THAT(said("010"), ElementsAre(start + "010'; a leading zero could mean octal; leave it out"));
  EXPECT_THAT(said("1_000"), ElementsAre(start + "1_000'; leave out the underscores"));
  EXPECT_THAT(said("9.81 m"), ElementsAre(start + "9.81 m'"));
}

TEST(Reader, RefusesValuesOutOfRange) {
  EXPECT_THAT(with_line("solver: {exponent: 8}"),
              ElementsAre("s.yaml:6:10: solver.exponent must be at least 1 and at most 7, got 8"));
  EXPECT_THAT(with_line("solver: {stiffness: 0}"),
              ElementsAre("s.yaml:6:10: solver.stiffness must be above 0 Pa, got 0"));
  EXPECT_THAT(with_line("fluid: {rest_density: -1}"), testing::Contains(HasSubstr("repeated key 'fluid'")));
  EXPECT_THAT(with_line("output: {stills: [-1]}"),
              ElementsAre("s.yaml:6:19: output.stills.0 must be at least 0 s, got -1"));
  EXPECT_THAT(with_line("render: {fps: 1e12}"),
              ElementsAre("s.yaml:6:10: render.fps must be at least 1 1/s and at most 1000 1/s, got 1000000000000"));
}

TEST(Reader, KeepsEscapedCharactersThroughWritingAndReading) {
  const auto title = [](const std::string& text) {
    const Scene scene = scene_of(shortest_text + "title: \"" + text + "\"\n");
    EXPECT_EQ(scene_of(write_scene(scene)).title, scene.title);
    return scene.title;
  };
  EXPECT_EQ(title(R"(a\Nb\_c)"), "a\u0085b\u00a0c");  // next line, no-break space
  EXPECT_EQ(title(R"(\N\Né\_)"), "\u0085\u0085é\u00a0");
  EXPECT_EQ(title(R"(\x85\xe9\u2028\U0010ffff)"), "\u0085é\u2028\U0010ffff");
  EXPECT_EQ(title(R"(tab\t quote\" bell\x07)"), "tab\t quote\" bell\a");
  EXPECT_THAT(with_line(R"("\_": 1)"), ElementsAre(HasSubstr("unknown key '\u00a0'")));
}

TEST(Reader, RefusesOddFrameSizes) {
  EXPECT_THAT(with_line("render: {size: [1921, 1080]}"),
              ElementsAre("s.yaml:6:17: render.size.0 must be a multiple of 2, got 1921"));
  EXPECT_THAT(with_line("render: {size: [1920]}"),
              ElementsAre("s.yaml:6:10: render.size expects two whole numbers, got 1"));
  EXPECT_THAT(with_line("render: {size: [8, 20000]}"),
              ElementsAre("s.yaml:6:17: render.size.0 must be at least 16 pixels and at most 16384 pixels, got 8",
                          "s.yaml:6:20: render.size.1 must be at least 16 pixels and at most 16384 pixels, got 20000"));
}

TEST(Reader, RefusesVectorsAndShapesOfTheOtherDimension) {
  EXPECT_THAT(with_line("gravity: [0, 0, -9.81]"), ElementsAre("s.yaml:6:1: gravity expects 2 numbers [x, y], got 3"));
  EXPECT_THAT(mistakes_in(shortest_3d_text + "gravity: [0, 1]\n"),
              ElementsAre("s.yaml:6:1: gravity expects 3 numbers [x, y, z], got 2"));
  EXPECT_THAT(with_line("walls: [{ball: {center: [0, 0], radius: 1}}]"),
              ElementsAre("s.yaml:6:10: walls.0.ball is for 3D scenes; this one has dimension 2"));
  EXPECT_THAT(mistakes_in(shortest_3d_text + "walls: [{polyline: {points: [[0, 0], [1, 1]]}}]\n"),
              ElementsAre("s.yaml:6:10: walls.0.polyline is for 2D scenes; this one has dimension 3"));
  EXPECT_THAT(
      with_line("camera: {view: {eye: [0, 0], target: [1, 1]}}"),
      ElementsAre("s.yaml:6:10: missing key 'camera.view.center'", "s.yaml:6:10: missing key 'camera.view.width'",
                  "s.yaml:6:17: camera.view.eye does not go with the other keys of camera.view",
                  "s.yaml:6:30: camera.view.target does not go with the other keys of camera.view"));
}

TEST(Reader, RefusesTwoKeysThatExcludeEachOther) {
  EXPECT_THAT(with_line("solver: {sound_speed: 10, stiffness: 1000}"),
              ElementsAre("s.yaml:6:10: solver.sound_speed stands beside solver.stiffness; give one of them"));
  EXPECT_THAT(with_line("solver: {time_step: {fixed: 0.1, cfl: 0.4}}"),
              ElementsAre("s.yaml:6:22: solver.time_step.fixed does not go with the other keys of solver.time_step"));
  EXPECT_THAT(with_line("walls: [{tank: {min: [0, 0], max: [1, 1]}, box: {min: [0, 0], max: [1, 1]}}]"),
              ElementsAre("s.yaml:6:44: walls.0.box stands beside walls.0.tank; give one of them"));
}

TEST(Reader, KnowsTheFormsOfParticleFiles) {
  EXPECT_THAT(with_line("output: {particles: true}"), IsEmpty());
  EXPECT_THAT(with_line("output: {particles: {every: frame, fields: []}}"), IsEmpty());
  EXPECT_THAT(with_line("output: {particles: {every: 0, fields: [id, id]}}"),
              ElementsAre("s.yaml:6:22: output.particles.every must be above 0 s, got 0",
                          "s.yaml:6:45: output.particles.fields holds 'id' twice"));
  EXPECT_THAT(with_line("output: {particles: {every: 1e-12, fields: [colour]}}"),
              ElementsAre("s.yaml:6:45: output.particles.fields.0 expects one of speed, density, pressure, velocity, "
                          "id, volume, vorticity, got 'colour'"));
  EXPECT_THAT(with_line("output: {particles: {every: 1e-12}}"),
              ElementsAre("s.yaml:6:22: output.particles.every makes 2e+12 files; a run has at most 1e+09"));
}

TEST(Reader, RefusesReservedKeysByName) {
  EXPECT_THAT(with_line("bodies: [{}]"),
              ElementsAre("s.yaml:6:1: bodies is not built yet (rigid bodies); leave it out"));
  EXPECT_THAT(with_line("probes: [{}]"), ElementsAre("s.yaml:6:1: probes is not built yet (probes); leave it out"));
  EXPECT_THAT(with_line("output: {checkpoint: {every: 60}}"),
              ElementsAre("s.yaml:6:10: output.checkpoint is not built yet (checkpoints); leave it out"));
  EXPECT_THAT(with_line("walls: [{tank: {min: [0, 0], max: [1, 1], motion: {turn: 1}}}]"),
              ElementsAre("s.yaml:6:52: unknown key 'walls.0.tank.motion.turn'"));
  EXPECT_THAT(
      with_line("domain: {min: [0, 0], max: [1, 1]}"),
      ElementsAre("s.yaml:6:1: domain without periodic axes is not built yet; name axes in `periodic`, or leave "
                  "it out"));
  EXPECT_THAT(with_line("walls: [{plane: {}}]"),
              ElementsAre("s.yaml:6:9: walls.0 needs one of the keys tank, box, polyline, disc, polygon",
                          "s.yaml:6:10: walls.0.plane is not built yet (a wall without particles); leave it out"));
  EXPECT_THAT(with_line("solver: {method: iisph}"),
              ElementsAre("s.yaml:6:10: solver.method 'iisph' is not built yet; choose from wcsph, delta_sph"));
  EXPECT_THAT(with_line("periodic: []\nbodies: []\nprobes: []\noutput: {particles: false, checkpoint: false}"),
              IsEmpty());
}

TEST(Reader, RefusesOtherFormatVersionsAlone) {
  EXPECT_THAT(mistakes_in("weir: 2\nnew_key: 1\n"),
              ElementsAre("s.yaml:1:1: weir is 2: this program reads format version 1"));
}

TEST(Reader, ReportsSyntaxErrorsAlone) {
  EXPECT_THAT(mistakes_in("titel: x\nrender: {fps: 30\nwalls: ]\n"), ElementsAre(HasSubstr("s.yaml:3:6: not YAML: ")));
  EXPECT_THAT(mistakes_in(shortest_text + "---\nweir: 1\n"),
              ElementsAre("s.yaml:6:1: a second document begins here; a file holds one scene"));
  EXPECT_THAT(mistakes_in(shortest_text + "[a]: 1\n"),
              ElementsAre("s.yaml:6:1: a key must be a name, not a list or map; is a bracket left open?"));
  EXPECT_THAT(mistakes_in(shortest_text + "walls: " + std::string(100, '[') + std::string(100, ']')),
              ElementsAre("s.yaml:6:71: nested deeper than 64 levels"));
}

TEST(Reader, RefusesAnchorsAliasesAndTags) {
  EXPECT_THAT(with_line("gravity: &g [0, 1]\nrender: {color: {range: *g}}"),
              ElementsAre("s.yaml:6:10: anchors (&name) are not read; leave it out",
                          "s.yaml:7:18: aliases (*name) are not read; write the value out"));
  EXPECT_THAT(with_line("title: !!str 5"),
              ElementsAre("s.yaml:6:1: title expects text, got '5'; put it in quotes",
                          "s.yaml:6:8: tags (tag:yaml.org,2002:str) are not read; leave it out"));
}

TEST(Reader, RefusesTextThatIsNoUtf8) {
  const auto said = [](const std::string& bytes) { return mistakes_in("weir: 1\ntitle: \xC3\xA4" + bytes + "\n"); };
  const auto at = [](const std::string& byte) {
    return "s.yaml:2:9: not UTF-8: byte 0x" + byte + "; save the file as UTF-8";
  };
  EXPECT_THAT(said("\xFF"), ElementsAre(at("ff")));
  EXPECT_THAT(said("\xE4x"), ElementsAre(at("e4")));             // Latin-1
  EXPECT_THAT(said("\xC0\xAF"), ElementsAre(at("c0")));          // overlong '/'
  EXPECT_THAT(said("\xE0\x80\xAF"), ElementsAre(at("e0")));      // overlong in three bytes
  EXPECT_THAT(said("\xF0\x80\x80\xAF"), ElementsAre(at("f0")));  // and in four
  EXPECT_THAT(said("\xED\xA0\x80"), ElementsAre(at("ed")));      // surrogate U+D800
  EXPECT_THAT(said("\xF4\x90\x80\x80"), ElementsAre(at("f4")));  // U+110000
  EXPECT_THAT(said("\xE2\x82"), ElementsAre(at("e2")));          // cut off
  EXPECT_THAT(said("\x04"), ElementsAre("s.yaml:2:9: control character 0x04; a scene is plain text"));
  EXPECT_THAT(said(std::string(1, '\0')), ElementsAre("s.yaml:2:9: control character 0x00; a scene is plain text"));
}

TEST(Reader, CountsColumnsInCharacters) {
  EXPECT_THAT(with_line("render: {theme: \"\xC3\xA4\xE2\x82\xAC\", fps: 0}"),
              testing::Contains(HasSubstr("s.yaml:6:23: render.fps must")));
  EXPECT_THAT(mistakes_in("\xEF\xBB\xBF" + shortest_text + "titel: x\n"),
              ElementsAre(HasSubstr("s.yaml:6:1: unknown")));
  EXPECT_THAT(mistakes_in("\xEF\xBB\xBFtitel: x\n"), testing::Contains(HasSubstr("s.yaml:1:1: unknown key 'titel'")));
  EXPECT_THAT(mistakes_in("weir: 1\r\ntitel: x\r\n"), testing::Contains(HasSubstr("s.yaml:2:1: unknown key 'titel'")));
}

TEST(Reader, OrdersAllMistakesByPosition) {
  EXPECT_THAT(mistakes_in("weir: 1\ntitel: x\ndimension: 2\nduration: -1\nparticles: {spacing: 0.1}\n"
                          "fluid: {volumes: [{box: {min: [0, 0], max: [1, 1]}}, {box: {min: [0.5, 0], max: [2, 1]}}]}\n"
                          "render: {fps: 0}\n"),
              ElementsAre("s.yaml:2:1: unknown key 'titel'; did you mean 'title'?",
                          "s.yaml:4:1: duration must be above 0 s, got -1",
                          "s.yaml:6:55: fluid.volumes.1.box overlaps fluid.volumes.0.box",
                          "s.yaml:7:10: render.fps must be at least 1 1/s and at most 1000 1/s, got 0"));
}

class ReaderFiles : public testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string said(const std::filesystem::path& file) {
    try {
      read_scene(file);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "";
  }
  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) / "weir_reader_files";
};

TEST_F(ReaderFiles, NamesFilesThatCannotBeRead) {
  const std::string missing = (folder_ / "no.yaml").string();
  EXPECT_EQ(said(missing), missing + ": error: there is no such file");
  EXPECT_EQ(said(folder_), folder_.string() + ": error: is a folder; name a scene file in it");
  const std::filesystem::path empty = folder_ / "empty.yaml";
  std::ofstream(empty) << "# nothing\n";
  EXPECT_EQ(said(empty), empty.string() + ": error: the file is empty; a scene begins with 'weir: 1'");
  const std::filesystem::path large = folder_ / "large.yaml";
  std::ofstream(large) << std::string((16U << 20U) + 1, '\n');
  EXPECT_EQ(said(large), large.string() + ": error: is longer than 16 MiB; that is no scene");
}

TEST_F(ReaderFiles, NamesTheSceneAfterTheFile) {
  const std::filesystem::path file = folder_ / "a_pool.v2.yaml";
  std::ofstream(file) << shortest_text;
  EXPECT_EQ(read_scene(file).name, "a_pool.v2");
}

TEST_F(ReaderFiles, NamesFilesWithoutPermission) {
  const std::filesystem::path file = folder_ / "secret.yaml";
  std::ofstream(file) << shortest_text;
  std::filesystem::permissions(file, std::filesystem::perms::none);
  if (std::ifstream(file).good()) GTEST_SKIP() << "this user may read everything";
  EXPECT_EQ(said(file), file.string() + ": error: cannot be opened; may this user read it?");
}

TEST(Writer, ReadsBackToTheSameScene) {
  for (const std::string& text :
       {shortest_text, shortest_3d_text + "walls: [{ball: {center: [0.5, 0.5, 0.5], radius: 3, solid: outside}}]\n"}) {
    const Scene scene = scene_of(text + "title: 'a \"b\" \\ #: \xC3\xA4'\nsolver: {stiffness: 123456.789e-7}\n");
    const std::string written = write_scene(scene);
    const Scene again = scene_of(written);
    EXPECT_EQ(write_scene(again), written);
    EXPECT_EQ(again.title, "a \"b\" \\ #: \xC3\xA4");
    EXPECT_EQ(std::get<Stiffness>(again.solver.compressibility).k, 0.0123456789);
  }
}

}  // namespace
}  // namespace weir
