// Every scene that ships runs, shortened.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "cli/program.h"
#include "pipeline/temporary_folder.h"

namespace weir {

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> shipped_scenes() {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator("scenes")) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(Scenes, AllPassTheCheckAndRun) {
  ASSERT_FALSE(shipped_scenes().empty());
  for (const fs::path& scene : shipped_scenes()) {
    SCOPED_TRACE(scene.string());
    const TemporaryFolder temporary;
    // Unchanged, with its pictures, for a second: the later parts of the file are read and checked all the same.
    Program program({"run", scene.string(), "-o", temporary.path().string(), "--progress", "json"});
    program.says("\"event\":\"progress\"", 2);
    program.signal(SIGTERM);
    const Outcome outcome = program.wait();
    EXPECT_TRUE(outcome.exit == 6 || outcome.exit == 0) << outcome.err;
    const auto manifest = nlohmann::json::parse(file_text(temporary / "manifest.json"), nullptr, false);
    ASSERT_TRUE(manifest.is_object());
    EXPECT_GE(manifest["steps"], 1);
    EXPECT_GE(manifest["particles"]["fluid"], 1);
    EXPECT_LT(manifest["max_density_error"], 0.5);
  }
}

// Others may show what a paper did against the advice.
TEST(Scenes, OfValidationPassTheCheckWithoutAdvice) {
  int scenes = 0;
  for (const fs::path& scene : shipped_scenes()) {
    if (scene.parent_path().filename() != "validation") continue;
    SCOPED_TRACE(scene.string());
    const Outcome outcome = weir_program({"check", scene.string()});
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find("advice"), std::string::npos) << outcome.out;
    ++scenes;
  }
  EXPECT_GE(scenes, 4);
}

}  // namespace

}  // namespace weir
