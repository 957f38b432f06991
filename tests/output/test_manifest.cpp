#include "output/manifest.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "helpers.h"
#include "output/file.h"

namespace weir::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ManifestFile : public FolderTest {
 protected:
  std::filesystem::path file() const { return folder / "manifest.json"; }
};

Manifest filled() {
  Manifest manifest;
  manifest.version = "1.2.3";
  manifest.scene_sha256 = std::string(64, 'a');
  manifest.state_hash = std::string(64, 'b');
  manifest.dimension = 3;
  manifest.particles = {.fluid = 15000, .wall = 1234};
  manifest.steps = 9'000'000'000;
  manifest.simulated_time_s = 0.1 + 0.2;
  manifest.frames = 121;
  manifest.threads = 2;
  manifest.wall_time_s = {
      .total = 9.5, .setup = 0.25, .neighbours = 1.5, .solve = 5.125, .render = 2, .encode = 3, .write = 0.5};
  manifest.particle_steps_per_second = 1.0e7 / 3;
  manifest.gl_renderer = "llvmpipe \"quoted\" \xc3\xa9";
  manifest.encoder = "libx264";
  manifest.max_density_error = 1e-300;
  manifest.instruction_set = "avx2";
  manifest.exit = ExitCode::diverged;
  return manifest;
}

TEST_F(ManifestFile, ComesBackAsItWas) {
  write_manifest(file(), filled());
  EXPECT_EQ(read_manifest(file()), filled());
  EXPECT_FALSE(std::filesystem::exists(temporary_of(file())));
}

TEST_F(ManifestFile, HasTheFieldsInOrder) {
  write_manifest(file(), filled());
  const auto json = nlohmann::ordered_json::parse(content_of(file()));
  const auto names = [](const nlohmann::ordered_json& object) {
    std::vector<std::string> found;
    for (const auto& [name, value] : object.items()) found.push_back(name);
    return found;
  };
  EXPECT_THAT(names(json),
              ElementsAre("version", "scene_sha256", "state_hash", "dimension", "particles", "steps",
                          "simulated_time_s", "frames", "threads", "wall_time_s", "particle_steps_per_second",
                          "gl_renderer", "encoder", "max_density_error", "instruction_set", "exit"));
  EXPECT_THAT(names(json["particles"]), ElementsAre("fluid", "wall"));
  EXPECT_THAT(names(json["wall_time_s"]),
              ElementsAre("total", "setup", "neighbours", "solve", "render", "encode", "write"));
  EXPECT_EQ(json["exit"], 3);
}

TEST_F(ManifestFile, MarksAnUnfinishedRunByANullExit) {
  Manifest running = filled();
  running.exit.reset();
  write_manifest(file(), running);
  EXPECT_THAT(content_of(file()), HasSubstr("\"exit\": null"));
  EXPECT_EQ(read_manifest(file()).exit, std::nullopt);
}

TEST_F(ManifestFile, StaysReadableAfterADivergence) {
  Manifest blown = filled();
  blown.max_density_error = std::numeric_limits<double>::infinity();
  write_manifest(file(), blown);
  EXPECT_TRUE(std::isnan(read_manifest(file()).max_density_error));  // JSON knows no infinity
}

TEST_F(ManifestFile, IgnoresUnknownFields) {
  std::ofstream(file()) << R"({"version": "9", "invented": [1], "exit": 0})";
  const Manifest manifest = read_manifest(file());
  EXPECT_EQ(manifest.version, "9");
  EXPECT_EQ(manifest.exit, ExitCode::done);
  EXPECT_EQ(manifest.steps, 0);
}

TEST_F(ManifestFile, NamesAFileThatIsNoManifest) {
  for (const char* text : {"", "{", "[]", "3", R"({"steps": "many"})", R"({"particles": 3})"}) {
    std::ofstream(file()) << text;
    EXPECT_THAT(error_text<OutputError>([&] { read_manifest(file()); }), HasSubstr(file().string())) << text;
  }
}

}  // namespace
}  // namespace weir::testing
