// Reader, writer, schema and reference know the same keys.
#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "scene/document.h"
#include "scene/keys.h"
#include "scene/texts.h"

namespace weir {
namespace {

using Json = nlohmann::ordered_json;

// Scenes that between them hold every key; a test below proves that they do.
const std::vector<std::string> full_texts{
    R"(weir: 1
name: all
title: all of 2D
dimension: 2
duration: 2
gravity: [1, -9]
particles: {spacing: 0.1}
fluid:
  rest_density: 900
  viscosity: {model: monaghan, kinematic: 0.001}
  surface_tension: {model: hinsch2024, coefficient: 0.5}
  volumes:
    - {box: {min: [0, 0], max: [1, 1]}, velocity: [1, 2], angular_velocity: 3}
    - disc: {center: [3, 3], radius: 0.5}
    - polygon: {points: [[5, 5], [6, 5], [6, 6]]}
walls:
  - tank: {min: [-5, -5], max: [20, 20], open: [top], layers: 2, holes: [{box: {min: [-6, 8], max: [-5, 9]}}]}
  - box: {min: [10, 0], max: [11, 1], layers: 2, holes: [{disc: {center: [10, 0], radius: 0.2}}]}
  - polyline: {points: [[12, 0], [13, 0], [13, 1]], closed: true, solid: left, layers: 1, holes: [{polygon: {points: [[12, 0], [12.2, 0], [12.2, 0.1]]}}]}
  - disc: {center: [15, 1], radius: 0.6, solid: inside, layers: 3, holes: []}
  - polygon: {points: [[15, 3], [16, 3], [15, 4]], solid: inside, layers: 3, holes: []}
solver:
  method: wcsph
  kernel: {name: wendland_c2, smoothing: 1.3}
  stiffness: 5000
  exponent: 5
  negative_pressure: keep
  wall_slip: free_slip
  time_step: {cfl: 0.3, acoustic: 0.3, force: 0.2, viscous: 0.1, maximum: 0.01}
timeline:
  - {at: 0.5, over: 0.1, set: {gravity: [0, 1], fluid.viscosity.kinematic: 0.1, fluid.surface_tension.coefficient: 2, solver.stiffness: 10}, reset: true, pause: false}
  - {at: 1.5, set: {solver.sound_speed: 10}}
camera:
  view: {center: [1, 1], width: 5}
  keyframes: [{at: 0.25, center: [1, 2], width: 3}]
render: {size: [640, 480], fps: 20, color: {by: density, map: magma, range: [900, 1100]}, overlay: [time], theme: dark, transparent: true, walls: false}
output: {movie: {encoder: libx264, quality: 18, preset: fast}, frames: true, stills: [0.5], log: {every: 0.5}, particles: {every: 0.25, fields: [volume, velocity]}}
)",
    R"(weir: 1
dimension: 2
duration: 2
gravity: [0, 0]
particles: {spacing: 0.25}
fluid:
  volumes:
    - {box: {min: [0, 0], max: [1, 1]}, flow: {taylor_green: {speed: 1, wave_length: 2}}, perturbation: 0.2, pressure: hydrostatic}
walls:
  - tank: {min: [-1, -1], max: [3, 3], open: [left, right], motion: {slide: [1, 0]}}
  - box: {min: [0, 1.5], max: [1, 2.5], motion: {slide: [1, 0]}}
  - polyline: {points: [[1.5, 2], [2, 2], [2, 2.5]], motion: {slide: [1, 0]}}
  - disc: {center: [2, 1], radius: 0.5, motion: {slide: [1, 0]}}
  - polygon: {points: [[1.5, -1], [2.5, -1], [2.5, 0], [1.5, 0]], motion: {slide: [1, 0]}}
periodic: [x]
domain: {min: [-1, -1], max: [3, 3]}
solver: {method: delta_sph, density_diffusion: 0.2, wall_pressure: extrapolated}
camera: {view: {center: [1, 1], width: 5}}
render: {overlay: [time]}
output: {movie: false, frames: true}
)",
    R"(weir: 1
dimension: 3
duration: 2
particles: {spacing: 0.25}
fluid:
  volumes:
    - {ball: {center: [0, 0, 0], radius: 0.5}, velocity: [1, 2, 3], angular_velocity: [1, 2, 3]}
walls:
  - tank: {min: [-2, -2, -2], max: [2, 2, 2], open: [front], holes: [{ball: {center: [2, 0, 0], radius: 0.5}}]}
  - ball: {center: [1.2, 0, 0], radius: 0.5, solid: inside, layers: 2, motion: {slide: [1, 0, 0]}, holes: [{ball: {center: [1.6, 0, 0], radius: 0.1}}]}
solver: {sound_speed: 20, wall_pressure: extrapolated, time_step: {fixed: 0.001}}
camera:
  view: {eye: [9, 9, 9], target: [0, 0, 0], field_of_view: 30}
  keyframes: [{at: 1, eye: [9, 9, 9], target: [0, 0, 1], field_of_view: 30}]
render: {overlay: [time]}
output: {movie: false, frames: true}
)"};

void collect_from_schema(const Json& type, const std::string& path, std::set<std::string>& keys) {
  const Json properties = type.value("properties", Json::object());
  for (const auto& [key, each] : properties.items()) {
    if (each.contains("not") || (each.contains("const") && each.at("const") == false) ||
        each.value("maxItems", 1) == 0) {
      continue;  // not built yet
    }
    keys.insert(joined(path, key));
    collect_from_schema(each, joined(path, key), keys);
  }
  if (type.contains("items")) collect_from_schema(type.at("items"), path + "[]", keys);
  for (const Json& form : type.value("anyOf", Json::array())) collect_from_schema(form, path, keys);
}

void collect_from_document(const Node& node, const std::string& path, std::set<std::string>& keys) {
  for (const Node& each : node.children) {
    const std::string below = node.kind == Node::Kind::list ? path + "[]" : joined(path, each.key);
    if (node.kind == Node::Kind::map) keys.insert(below);
    collect_from_document(each, below, keys);
  }
}

// Holes hold any shape under any wall; the full scenes show each shape once.
std::set<std::string> without_holes(const std::set<std::string>& keys) {
  std::set<std::string> rest;
  for (const std::string& key : keys) {
    const std::size_t holes = key.find(".holes[]");
    rest.insert(holes == std::string::npos ? key : "hole" + key.substr(holes + 8));
  }
  return rest;
}

std::set<std::string> schema_keys() {
  std::set<std::string> keys;
  collect_from_schema(Json::parse(scene_schema()), "", keys);
  return without_holes(keys);
}

std::set<std::string> document_keys(const std::vector<std::string>& texts) {
  std::set<std::string> keys;
  std::vector<Mistake> mistakes;
  for (const std::string& text : texts) collect_from_document(parse_document(text, -1, mistakes), "", keys);
  return without_holes(keys);
}

TEST(Schema, KnowsEveryKeyThatTheReaderReads) {
  for (const std::string& text : full_texts) EXPECT_THAT(mistakes_in(text), testing::IsEmpty());
  EXPECT_EQ(schema_keys(), document_keys(full_texts));  // all of them are read
  std::vector<std::string> written;
  for (const std::string& text : full_texts) written.push_back(write_scene(scene_of(text)));
  EXPECT_EQ(schema_keys(), document_keys(written));  // and written
}

TEST(Schema, ListsTheSameKeysAsTheReference) {
  std::set<std::string> rows;
  for (const KeyRow& row : scene_keys()) {
    EXPECT_TRUE(rows.insert(row.key).second) << row.key;
    EXPECT_FALSE(row.meaning.empty()) << row.key;
    EXPECT_FALSE(row.type.empty()) << row.key;
  }
  std::set<std::string> expected;
  for (const std::string& key : schema_keys()) {
    if (!key.starts_with("hole")) expected.insert(key);
  }
  EXPECT_EQ(rows, expected);
}

// Candidates for another valid value of a leaf.
std::vector<std::string> other_values(const Node& leaf) {
  if (leaf.quoted) return {leaf.text + "x"};
  return {leaf.text + "1",
          "none",
          "inside",
          "wendland_c2",
          "keep",
          "free_slip",
          "pressure",
          "cividis",
          "[1, 2]",
          "title",
          "dark",
          "true",
          "false",
          "left",
          "right",
          "outside",
          "hinsch2024",
          "naive",
          "index_sort",
          "clamp",
          "no_slip",
          "light",
          "speed",
          "back",
          "bottom",
          "morris",
          "auto",
          "viridis",
          "cubic_spline",
          "0.51",
          "1",
          "2",
          "7",
          "20",
          "delta_sph",
          "wcsph",
          "mirrored",
          "extrapolated",
          "hydrostatic",
          "0.25"};
}

void each_leaf(const Node& node, const std::string& path,
               const std::function<void(const std::string&, const Node&)>& visit) {
  if (node.kind == Node::Kind::scalar) visit(path, node);
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    const Node& each = node.children[i];
    each_leaf(each, joined(path, node.kind == Node::Kind::list ? std::to_string(i) : each.key), visit);
  }
}

TEST(Reader, LosesNoLeaf) {
  for (const std::string& text : full_texts) {
    const std::string effective = write_scene(scene_of(text));
    EXPECT_EQ(write_scene(scene_of(effective)), effective);
    std::vector<Mistake> mistakes;
    each_leaf(parse_document(effective, -1, mistakes), "", [&](const std::string& path, const Node& leaf) {
      if (path == "weir" || path == "dimension") return;            // one valid value each
      if (path.find(".set.gravity.") != std::string::npos) return;  // keys below `set` are one key, tested below
      // Other values of these break rules of these scenes; they are tested below.
      if (path.ends_with(".solid") || path == "fluid.surface_tension.model") return;
      const bool slides = text.find("slide") != std::string::npos;
      if (slides ? path == "solver.wall_slip" || path == "solver.wall_pressure" : path.find(".slide") != path.npos)
        return;
      const bool periodic = text.find("periodic") != std::string::npos;
      if (periodic && (path.starts_with("periodic") || path.find(".open.") != path.npos)) return;
      for (const std::string& other : other_values(leaf)) {
        if (other == leaf.text) continue;
        try {
          const std::string changed = write_scene(scene_of(effective, {path + "=" + other}));
          EXPECT_NE(changed, effective) << path << " = " << other;
          return;
        } catch (const SceneError&) {
          continue;  // not valid for this key
        }
      }
      ADD_FAILURE() << "no other value fits " << path << ": " << leaf.text;
    });
  }
}

TEST(Reader, ReadsChoicesThatDependOnTheRest) {
  const auto round = [](const std::string& solid, const std::string& radius) {
    const Scene scene =
        scene_of(shortest_text + "walls: [{disc: {center: [0, 0], radius: " + radius + ", solid: " + solid + "}}]\n");
    return std::get<Round>(scene.walls[0].shape).solid;
  };
  EXPECT_EQ(round("outside", "3"), Face::outside);
  EXPECT_EQ(mistakes_in(shortest_text + "walls: [{disc: {center: [0, 0], radius: 3, solid: inside}}]\n").size(), 1U);
  EXPECT_EQ(scene_of(shortest_text, {"fluid.surface_tension.model=hinsch2024"}).fluid.surface_tension.model,
            SurfaceTensionModel::hinsch2024);
  EXPECT_THAT(scene_of(shortest_text, {"periodic=[y, x]"}).periodic, testing::ElementsAre(Axis::y, Axis::x));
}

TEST(Reader, ReadsGravityOfEvents) {
  EXPECT_EQ(scene_of(full_texts[0], {"timeline.0.set.gravity=[5, 6]"}).timeline[0].set.gravity, Vec3(5, 6, 0));
}

TEST(Schema, IsTheCommittedFile) {
  std::ifstream file("scenes/weir.schema.json");
  std::stringstream text;
  text << file.rdbuf();
  EXPECT_EQ(text.str(), scene_schema()) << "run `weir schema > scenes/weir.schema.json`";
}

TEST(Schema, CarriesUnitsDefaultsAndRanges) {
  const Json schema = Json::parse(scene_schema());
  EXPECT_EQ(schema.at("$schema"), "http://json-schema.org/draft-07/schema#");
  EXPECT_EQ(schema.at("additionalProperties"), false);
  const Json& smoothing =
      schema.at("properties").at("solver").at("properties").at("kernel").at("properties").at("smoothing");
  EXPECT_EQ(smoothing.at("minimum"), 0.5);
  EXPECT_EQ(smoothing.at("maximum"), 4);
  EXPECT_EQ(smoothing.at("default"), 1);
  const Json& duration = schema.at("properties").at("duration");
  EXPECT_EQ(duration.at("exclusiveMinimum"), 0);
  EXPECT_EQ(duration.at("description"), "run time [s]");
  EXPECT_EQ(schema.at("required"), Json::parse(R"(["weir", "dimension", "duration", "particles", "fluid"])"));
}

}  // namespace
}  // namespace weir
