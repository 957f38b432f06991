// Runs that are stopped by signals, and the libraries that runs map.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/program.h"
#include "cli/scene_text.h"
#include "output/decode.h"
#include "pipeline/temporary_folder.h"

namespace weir {

namespace fs = std::filesystem;

namespace {

using testing::HasSubstr;
using testing::Not;

class Endless : public testing::Test {
 protected:
  Endless() { put_file(scene_, small_scene_text); }
  // Never ends by itself within a test's time; 10 frames a second, so that a second of movie is quickly full.
  std::vector<std::string> arguments(std::vector<std::string> more = {}) {
    std::vector<std::string> words{"run",   scene_.string(),   "-o",    folder_.string(), "--progress", "json",
                                   "--set", "duration=100000", "--set", "render.fps=10",  "--threads",  "1"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  static void wait_for_size(const fs::path& file, std::uintmax_t bytes) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    std::error_code missing;
    while (std::chrono::steady_clock::now() < deadline) {
      const std::uintmax_t size = fs::file_size(file, missing);
      if (!missing && size >= bytes) return;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    FAIL() << file << " does not grow";
  }

  TemporaryFolder temporary_;
  fs::path scene_ = temporary_ / "small.yaml";
  fs::path folder_ = temporary_ / "run";
};

TEST_F(Endless, IsClosedInGoodOrderOnASignal) {
  for (const int number : {SIGTERM, SIGINT}) {
    Program program(arguments({"--force"}));
    ASSERT_TRUE(program.says("\"event\":\"progress\""));
    program.signal(number);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exit, 6) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("stopped by a signal"));
    EXPECT_THAT(outcome.err, HasSubstr("No checkpoint was written"));
    const MovieFacts movie = decode_movie(folder_ / "small.mp4", {});
    const auto manifest = nlohmann::json::parse(file_text(folder_ / "manifest.json"));
    EXPECT_EQ(manifest["exit"], 6);
    EXPECT_EQ(manifest["frames"], movie.frames);
    EXPECT_GE(movie.frames, 1);
    EXPECT_TRUE(movie.faststart);
  }
}

TEST_F(Endless, LeavesAPlayablePartFileWhenKilled) {
  Program program(arguments());
  wait_for_size(folder_ / "small.part.mp4", 4096);
  program.signal(SIGKILL);
  EXPECT_EQ(program.wait().signal, SIGKILL);
  EXPECT_GE(decode_movie(folder_ / "small.part.mp4", {}).frames, 10);  // a flushed second at least
  EXPECT_THAT(file_text(folder_ / "log.csv"), HasSubstr("\n0.1"));
  EXPECT_FALSE(fs::exists(folder_ / "small.mp4"));
  const Outcome again = weir_program(arguments());
  EXPECT_EQ(again.exit, 2);
  EXPECT_THAT(again.err, HasSubstr("different or unfinished run"));
}

TEST_F(Endless, MapsNeitherGraphicsNorCodecsWithoutPictures) {
  Program program(arguments({"--set", "output.movie=false"}));
  ASSERT_TRUE(program.says("\"event\":\"progress\""));
  const std::string maps = file_text(fs::path("/proc") / std::to_string(program.pid()) / "maps");
  ASSERT_THAT(maps, HasSubstr("libyaml-cpp"));  // else nothing was read
  for (const char* library : {"libGL", "libEGL", "libepoxy", "gallium", "dri", "LLVM", "libav", "libsw", "x264",
                              "freetype", "cairo", "weir_render", "weir_movie"}) {
    EXPECT_THAT(maps, Not(HasSubstr(library)));
  }
}

TEST_F(Endless, MapsThemWithAMovie) {
  Program program(arguments());
  ASSERT_TRUE(program.says("\"event\":\"progress\""));
  const std::string maps = file_text(fs::path("/proc") / std::to_string(program.pid()) / "maps");
  for (const char* library : {"libEGL", "libepoxy", "LLVM", "libav", "x264", "weir_render", "weir_movie"}) {
    EXPECT_THAT(maps, HasSubstr(library));
  }
}

}  // namespace

}  // namespace weir
