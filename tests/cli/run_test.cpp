// `weir run`: files, messages and exit codes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.h"
#include "cli/scene_text.h"
#include "output/decode.h"
#include "pipeline/temporary_folder.h"

namespace weir {

namespace fs = std::filesystem;

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using testing::UnorderedElementsAre;

class Run : public testing::Test {
 protected:
  Run() { put_file(scene_, small_scene_text); }

  Outcome run(std::vector<std::string> more = {}, const Surroundings& surroundings = {}) {
    std::vector<std::string> arguments{"run", scene_.string(), "-o", folder_.string(), "--progress", "none"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return weir_program(arguments, surroundings);
  }
  nlohmann::json manifest() const {
    return nlohmann::json::parse(file_text(folder_ / "manifest.json"), nullptr, false);
  }
  static std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
    return names;
  }

  TemporaryFolder temporary_;
  fs::path scene_ = temporary_ / "small.yaml";
  fs::path folder_ = temporary_ / "run";
};

TEST_F(Run, WritesTheRunFolder) {
  const Outcome outcome = run({"--set", "output.frames=true", "--set", "output.stills=[0.04]"});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_EQ(outcome.out, folder_.string() + "\n");
  EXPECT_THAT(names_in(folder_),
              UnorderedElementsAre("scene.yaml", "manifest.json", "log.csv", "frames", "stills", "small.mp4"));
  EXPECT_THAT(names_in(folder_ / "frames"),
              UnorderedElementsAre("frame_00000.png", "frame_00001.png", "frame_00002.png", "frame_00003.png",
                                   "frame_00004.png", "frame_00005.png"));
  EXPECT_THAT(names_in(folder_ / "stills"), UnorderedElementsAre("still_00002.png"));
  EXPECT_EQ(file_text(folder_ / "stills" / "still_00002.png"), file_text(folder_ / "frames" / "frame_00002.png"));
  const MovieFacts movie = decode_movie(folder_ / "small.mp4", {});
  EXPECT_EQ(movie.frames, 6);
  EXPECT_EQ(movie.width, 64);
  EXPECT_TRUE(movie.faststart);
  EXPECT_EQ(manifest()["frames"], 6);
  EXPECT_EQ(manifest()["particles"]["fluid"], 100);
  EXPECT_EQ(manifest()["exit"], 0);
}

TEST_F(Run, EndsAtItsDurationAndLogsIt) {
  ASSERT_EQ(run({"--set", "output.movie=false"}).exit, 0);
  std::istringstream log(file_text(folder_ / "log.csv"));
  std::string header;
  std::string line;
  std::string last;
  std::getline(log, header);
  std::getline(log, line);
  EXPECT_THAT(header, StartsWith("time[s],step,dt[s],"));
  EXPECT_THAT(line, StartsWith("0,0,0,"));
  while (std::getline(log, line)) last = line;
  EXPECT_THAT(last, StartsWith("0.1,"));
}

TEST_F(Run, HasTheSameStateForAnyThreadsAndOutput) {
  ASSERT_EQ(run({"--threads", "1"}).exit, 0);
  const std::string hash = manifest()["state_hash"];
  for (const char* threads : {"2", "3", "8"}) {
    ASSERT_EQ(run({"--threads", threads, "--force", "--set", "output.frames=true"}).exit, 0);
    EXPECT_EQ(manifest()["state_hash"], hash) << threads << " threads";
    EXPECT_EQ(manifest()["threads"], std::stoi(threads));
  }
  ASSERT_EQ(run({"--force", "--set", "output.movie=false", "--set", "output.log.every=0.0005"}).exit, 0);
  EXPECT_EQ(manifest()["state_hash"], hash) << "without pictures, with another log";
  ASSERT_EQ(run({"--force", "--set", "gravity=[0, -9]"}).exit, 0);
  EXPECT_NE(manifest()["state_hash"], hash) << "with another gravity";
}

TEST_F(Run, FromTheEffectiveSceneGivesTheSame) {
  ASSERT_EQ(run({"--set", "particles.spacing=0.1"}).exit, 0);
  const nlohmann::json first = manifest();
  const fs::path again = temporary_ / "again";
  const Outcome outcome = weir_program({"run", (folder_ / "scene.yaml").string(), "-o", again.string()});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  const auto second = nlohmann::json::parse(file_text(again / "manifest.json"));
  EXPECT_EQ(second["state_hash"], first["state_hash"]);
  EXPECT_EQ(second["scene_sha256"], first["scene_sha256"]);
  // The same run, so the same movie's name, and nothing to do where it is finished.
  EXPECT_TRUE(fs::exists(again / "small.mp4"));
  const Outcome in_place = weir_program({"run", (folder_ / "scene.yaml").string(), "-o", folder_.string()});
  EXPECT_EQ(in_place.exit, 0) << in_place.err;
  EXPECT_NE((in_place.out + in_place.err).find("holds the identical finished run"), std::string::npos);
}

TEST_F(Run, SkipsTheFinishedRunAndRefusesAnother) {
  ASSERT_EQ(run().exit, 0);
  const Outcome again = run();
  EXPECT_EQ(again.exit, 0);
  EXPECT_THAT(again.err, HasSubstr("identical finished run"));
  const Outcome other = run({"--set", "duration=0.12"});
  EXPECT_EQ(other.exit, 2);
  EXPECT_THAT(other.err, AllOf(HasSubstr("different or unfinished run"), HasSubstr("--force")));
  EXPECT_EQ(run({"--set", "duration=0.12", "--force"}).exit, 0);
}

TEST_F(Run, ReportsMistakesWithPositionsAndWritesNothing) {
  put_file(scene_, small_scene_text + "colour: red\nbodies: 3\n");
  const Outcome outcome = run();
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, HasSubstr(scene_.string() + ":12:1: error: "));
  EXPECT_THAT(outcome.err, HasSubstr("colour"));
  EXPECT_THAT(outcome.err, HasSubstr(scene_.string() + ":13:"));
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(Run, CitesTheOptionOfAWrongSetting) {
  const Outcome outcome = run({"--set", "particles.spacing=-1"});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--set particles.spacing=-1"));
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(Run, RefusesASettingWithoutValue) {
  const Outcome outcome = run({"--set", "duration"});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, HasSubstr("duration"));
}

TEST_F(Run, RefusesAMissingScene) {
  fs::remove(scene_);
  const Outcome outcome = run();
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, HasSubstr(scene_.string()));
}

TEST_F(Run, ReportsADivergenceAndKeepsWhatWasWritten) {
  const Outcome outcome = run({"--set", "solver.stiffness=1e9", "--set", "solver.time_step={fixed: 0.01}"});
  EXPECT_EQ(outcome.exit, 3) << outcome.err;
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("step"), HasSubstr("particle"), HasSubstr("try")));
  EXPECT_GE(decode_movie(folder_ / "small.mp4", {}).frames, 1);
  EXPECT_EQ(manifest()["exit"], 3);
  EXPECT_FALSE(fs::exists(folder_ / "small.part.mp4"));
}

TEST_F(Run, ReportsMissingOpenGlAndWritesNothing) {
  const Outcome outcome = run({}, {.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere.json"}}});
  EXPECT_EQ(outcome.exit, 4) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("EGL"));
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(Run, RefusesAMissingDevice) {
  const Outcome outcome = run({"--gl-device", "99"});
  EXPECT_EQ(outcome.exit, 4) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("99"));
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(Run, NeedsNoOpenGlWithoutPictures) {
  const Outcome outcome =
      run({"--set", "output.movie=false"}, {.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere.json"}}});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
}

TEST_F(Run, ReportsAFolderThatCannotBeMade) {
  folder_ = "/proc/weir";  // refuses even root
  const Outcome outcome = run();
  EXPECT_EQ(outcome.exit, 5);
  EXPECT_THAT(outcome.err, HasSubstr("/proc/weir"));
}

TEST_F(Run, ReportsAFolderBelowAFile) {
  folder_ = scene_ / "run";
  const Outcome outcome = run();
  EXPECT_EQ(outcome.exit, 5);
  EXPECT_THAT(outcome.err, HasSubstr("small.yaml"));
}

TEST_F(Run, ReportsAFullDiskAndKeepsWhatWasWritten) {
  // A limit of the file size stands in for the full disk: writes fail in the same place with another reason.
  const Outcome outcome =
      run({"--set", "duration=100", "--set", "output.frames=true"}, {.largest_file = std::size_t{24} * 1024});
  EXPECT_EQ(outcome.exit, 5) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("error: "));
  EXPECT_EQ(manifest()["exit"], 5);
  EXPECT_GE(manifest()["steps"], 1);
  const fs::path movie = folder_ / "small.mp4";
  const fs::path part = folder_ / "small.part.mp4";
  EXPECT_GE(decode_movie(fs::exists(part) ? part : movie, {}).frames, 1);
  EXPECT_NO_THROW(read_png(folder_ / "frames" / "frame_00000.png"));
}

TEST_F(Run, StopsAfterTheGivenWallTime) {
  const Outcome outcome = run({"--set", "duration=10000", "--max-wall-time", "0.5s"});
  EXPECT_EQ(outcome.exit, 6) << outcome.err;
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("--max-wall-time"), HasSubstr("No checkpoint was written")));
  EXPECT_GE(decode_movie(folder_ / "small.mp4", {}).frames, 1);
  EXPECT_EQ(manifest()["exit"], 6);
}

TEST_F(Run, RefusesAMalformedWallTime) {
  for (const char* time : {"soon", "-3", "0", "5 d", "1e3"}) {
    const Outcome outcome = run({"--max-wall-time", time});
    EXPECT_EQ(outcome.exit, 2) << time;
    EXPECT_THAT(outcome.err, HasSubstr("--max-wall-time")) << time;
  }
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(Run, ReportsProgressAsJson) {
  const Outcome outcome = weir_program(
      {"run", scene_.string(), "-o", folder_.string(), "--progress", "json", "--set", "output.movie=false"});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  std::istringstream lines(outcome.err);
  nlohmann::json last;
  bool finished = false;
  for (std::string line; std::getline(lines, line);) {
    last = nlohmann::json::parse(line, nullptr, false);
    ASSERT_TRUE(last.is_object()) << line;
    if (last["event"] == "progress" && last["time_s"] == 0.1) finished = true;
  }
  EXPECT_TRUE(finished);
  EXPECT_EQ(last["event"], "end");
  EXPECT_EQ(last["exit"], 0);
}

TEST_F(Run, ReportsProgressInLinesWithoutATerminal) {
  const Outcome outcome = weir_program({"run", scene_.string(), "-o", folder_.string(), "--set", "output.movie=false"});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("weir: 100 %  0.100 of 0.100 s"));
  EXPECT_THAT(outcome.err, Not(HasSubstr("\r")));
  EXPECT_THAT(outcome.err, Not(HasSubstr("\x1b")));
}

TEST_F(Run, RefusesReservedOptionsByName) {
  const Outcome outcome = run({"--resume"});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--resume is not built yet"));
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(Run, PrintsTheEstimatedColourRange) {
  EXPECT_THAT(run().err, HasSubstr("colour range of speed [m/s]: 0 to "));
  EXPECT_THAT(run({"--set", "render.color.range=[0, 3]", "--force"}).err, Not(HasSubstr("colour range")));
}

}  // namespace

}  // namespace weir
