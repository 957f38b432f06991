// Files of earlier runs in a run folder, kept, refused or replaced.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/sha256.h"
#include "output/file.h"
#include "pipeline/fakes.h"
#include "pipeline/small_scene.h"
#include "pipeline/temporary_folder.h"
#include "run/run.h"
#include "run/run_folder.h"
#include "scene/reader.h"

namespace weir {

namespace fs = std::filesystem;

namespace {

using testing::HasSubstr;

// Without pictures: the fakes write none, and a run whose movie is missing does not count as finished.
class Folder : public testing::Test {
 protected:
  Folder() {
    behave({});
    scene_.output.movie.reset();
    options_.folder = folder_;
  }
  std::string refusal() {
    try {
      run(scene_, options_);
    } catch (const UsageError& error) {
      return error.what();
    }
    return "not refused";
  }
  void put(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    write_file(file, text);
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_ / "run";
  Scene scene_ = small_scene();
  RunOptions options_;
};

TEST_F(Folder, HoldsTheEffectiveSceneThatItsHashIsOf) {
  ASSERT_EQ(run(scene_, options_).exit, ExitCode::done);
  const std::string text = read_file(folder_ / "scene.yaml");
  const auto manifest = nlohmann::json::parse(read_file(folder_ / "manifest.json"));
  EXPECT_EQ(manifest["scene_sha256"], sha256(text));
  const Scene again = read_scene(folder_ / "scene.yaml");
  EXPECT_EQ(effective_scene_text(again), text);
}

TEST_F(Folder, SkipsTheIdenticalFinishedRun) {
  EXPECT_FALSE(run(scene_, options_).was_there);
  const auto written = fs::last_write_time(folder_ / "manifest.json");
  const RunResult again = run(scene_, options_);
  EXPECT_TRUE(again.was_there);
  EXPECT_EQ(again.exit, ExitCode::done);
  EXPECT_THAT(again.message, HasSubstr("identical finished run"));
  EXPECT_EQ(fs::last_write_time(folder_ / "manifest.json"), written);
}

TEST_F(Folder, RefusesADifferentRun) {
  run(scene_, options_);
  scene_.duration = 0.25;
  EXPECT_THAT(refusal(), HasSubstr("different or unfinished run"));
  EXPECT_THAT(refusal(), HasSubstr("--force"));
  options_.force = true;
  EXPECT_EQ(run(scene_, options_).exit, ExitCode::done);
}

TEST_F(Folder, BelongsToOneRunAtATime) {
  RunFolder other(folder_, scene_);
  other.prepare();
  put(folder_ / "log.csv", "rows of the other run");
  options_.force = true;
  EXPECT_THAT(refusal(), HasSubstr("another process is writing a run into " + folder_.string() + " now"));
  EXPECT_EQ(read_file(folder_ / "log.csv"), "rows of the other run");
}

TEST_F(Folder, RefusesAFailedRun) {
  behave({.diverge_in_step = 2});
  EXPECT_EQ(run(scene_, options_).exit, ExitCode::diverged);
  behave({});
  EXPECT_THAT(refusal(), HasSubstr("different or unfinished run"));
}

TEST_F(Folder, RefusesARunOfAnotherVersion) {
  run(scene_, options_);
  std::string manifest = read_file(folder_ / "manifest.json");
  const std::string version = "\"version\": \"" WEIR_VERSION "\"";
  manifest.replace(manifest.find(version), version.size(), "\"version\": \"0.0.1\"");
  write_file(folder_ / "manifest.json", manifest);
  EXPECT_THAT(refusal(), HasSubstr("different or unfinished run"));
}

TEST_F(Folder, RefusesARunThatWasKilled) {
  run(scene_, options_);
  fs::remove(folder_ / "manifest.json");
  EXPECT_THAT(refusal(), HasSubstr("different or unfinished run"));
}

TEST_F(Folder, RefusesAFinishedRunThatLacksAFile) {
  run(scene_, options_);
  fs::remove(folder_ / "log.csv");
  EXPECT_THAT(refusal(), HasSubstr("different or unfinished run"));
}

TEST_F(Folder, LosesOnlyFilesOfRunsWhenForced) {
  run(scene_, options_);
  put(folder_ / "notes.txt", "mine");
  put(folder_ / "frames" / "mine.png", "mine");
  put(folder_ / "frames" / "frame_00099.png", "an earlier, longer run's");
  put(folder_ / "other.mp4", "of another scene");
  options_.force = true;
  scene_.duration = 0.25;
  ASSERT_EQ(run(scene_, options_).exit, ExitCode::done);
  EXPECT_TRUE(fs::exists(folder_ / "notes.txt"));
  EXPECT_TRUE(fs::exists(folder_ / "frames" / "mine.png"));
  EXPECT_TRUE(fs::exists(folder_ / "other.mp4"));
  EXPECT_FALSE(fs::exists(folder_ / "frames" / "frame_00099.png"));
}

TEST_F(Folder, KeepsASceneFileOfTheUser) {
  put(folder_ / "scene.yaml", "weir: 1\n");
  options_.force = true;
  EXPECT_THAT(refusal(), HasSubstr("was not written by weir"));
  EXPECT_EQ(read_file(folder_ / "scene.yaml"), "weir: 1\n");
}

TEST_F(Folder, MayHoldOtherFiles) {
  put(folder_ / "notes.txt", "mine");
  EXPECT_EQ(run(scene_, options_).exit, ExitCode::done);
}

TEST_F(Folder, MustNotBeAFile) {
  put(folder_, "a file");
  EXPECT_THROW(run(scene_, options_), OutputError);
  EXPECT_EQ(read_file(folder_), "a file");
}

TEST_F(Folder, IsNamedAfterTheSceneByDefault) {
  const fs::path before = fs::current_path();
  fs::current_path(temporary_.path());
  options_.folder.clear();
  const RunResult result = run(scene_, options_);
  fs::current_path(before);
  EXPECT_EQ(result.folder, "out/small");
  EXPECT_TRUE(fs::exists(temporary_ / "out" / "small" / "manifest.json"));
}

}  // namespace

}  // namespace weir
