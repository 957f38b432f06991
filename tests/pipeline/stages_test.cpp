// The stages of a run together, some failing on purpose.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "core/trace.h"
#include "output/file.h"
#include "pipeline/fakes.h"
#include "pipeline/small_scene.h"
#include "pipeline/temporary_folder.h"
#include "run/run.h"

namespace weir {

namespace fs = std::filesystem;

namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::Ge;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Le;
using testing::SizeIs;

class Stages : public testing::Test {
 protected:
  Stages() {
    options_.folder = temporary_ / "run";
    options_.threads = 2;
  }

  RunResult run_with(const FakeBehaviour& behaviour) {
    behave(behaviour);
    return run(scene_, options_);
  }
  nlohmann::json manifest() const { return nlohmann::json::parse(read_file(options_.folder / "manifest.json")); }
  static std::vector<std::int64_t> frames(std::int64_t count) {
    std::vector<std::int64_t> indices(static_cast<std::size_t>(count));
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
  }
  static std::size_t threads_alive() {
    const fs::directory_iterator tasks("/proc/self/task");
    return static_cast<std::size_t>(std::distance(begin(tasks), end(tasks)));
  }

  TemporaryFolder temporary_;
  Scene scene_ = small_scene();
  RunOptions options_;
};

TEST_F(Stages, DrawAndEncodeEveryFrameOnceAndInOrder) {
  scene_.output.frames = true;
  const RunResult result = run_with({});
  EXPECT_EQ(result.exit, ExitCode::done) << result.message;
  EXPECT_EQ(record().drawn, frames(11));  // floor(0.5 s * 20 / s) + 1
  EXPECT_EQ(record().encoded, frames(11));
  EXPECT_THAT(record().pngs, SizeIs(11));
  EXPECT_EQ(record().pngs.count("frame_00010.png"), 1U);
  EXPECT_TRUE(record().movie_finished);
  EXPECT_EQ(manifest()["frames"], 11);
}

// Of its 32 steps until eight pictures wait for the device.
TEST_F(Stages, DoNotHoldUpTheSolverWhileTheDeviceStarts) {
  run_with({.device_time = std::chrono::milliseconds(0)});
  const std::string log = read_file(options_.folder / "log.csv");
  options_.force = true;
  const RunResult result =
      run_with({.device_time = std::chrono::milliseconds(50), .step_time = std::chrono::milliseconds(1)});
  EXPECT_EQ(result.exit, ExitCode::done) << result.message;
  EXPECT_THAT(record().steps_ahead, AllOf(Ge(1), Le(32)));
  EXPECT_EQ(record().drawn, frames(11));
  EXPECT_EQ(record().encoded, frames(11));
  EXPECT_EQ(read_file(options_.folder / "log.csv"), log);
}

TEST_F(Stages, ReportADivergenceAheadOfTheDevice) {
  const RunResult result = run_with({.diverge_in_step = 6, .device_time = std::chrono::milliseconds(20)});
  EXPECT_EQ(record().steps_ahead, 6);
  EXPECT_EQ(result.exit, ExitCode::diverged);
  EXPECT_EQ(result.message, "diverged on purpose");
  EXPECT_EQ(record().encoded, frames(2));
  EXPECT_EQ(manifest()["steps"], 6);
}

// With pictures that wait to be drawn.
TEST_F(Stages, LeaveNothingBehindWithoutDeviceOrEncoderAfterSteps) {
  scene_.output.frames = true;
  for (const bool device : {false, true}) {
    const FakeBehaviour behaviour{
        .no_device = !device, .device_time = std::chrono::milliseconds(20), .no_encoder = true};
    if (device)
      EXPECT_THROW(run_with(behaviour), OutputError);
    else
      EXPECT_THROW(run_with(behaviour), DeviceError);
    EXPECT_GT(record().steps_ahead, 0);
    EXPECT_FALSE(fs::exists(options_.folder));
  }
}

TEST_F(Stages, DrawOnTheThreadThatMadeTheRenderer) {
  run_with({});
  EXPECT_FALSE(record().drawn_elsewhere);
  EXPECT_NE(record().renderer_thread, std::this_thread::get_id());
}

TEST_F(Stages, DrawOnlyWhatStillsAskFor) {
  scene_.output.movie.reset();
  scene_.output.stills = {0.25, 0.1};
  EXPECT_EQ(run_with({}).exit, ExitCode::done);
  EXPECT_THAT(record().drawn, ElementsAre(2, 5));
  EXPECT_THAT(record().pngs, ElementsAre("still_00002.png", "still_00005.png"));
  EXPECT_FALSE(record().movie_made);
}

TEST_F(Stages, DoNotExistWithoutPictures) {
  scene_.output.movie.reset();
  const std::size_t before = threads_alive();
  std::size_t during = 0;
  options_.progress = [&](const Progress&) { during = std::max(during, threads_alive()); };
  EXPECT_EQ(run_with({}).exit, ExitCode::done);
  EXPECT_EQ(during, before);
  EXPECT_THAT(record().others_at_work, IsEmpty());
  EXPECT_EQ(record().renderer_thread, std::thread::id());
  EXPECT_EQ(manifest()["gl_renderer"], "");
  EXPECT_EQ(manifest()["encoder"], "");
}

TEST_F(Stages, HoldTheSolverWhenTheEncoderIsSlow) {
  scene_.duration = 2;
  run_with({.encode_time = std::chrono::milliseconds(5)});
  EXPECT_EQ(record().encoded, frames(41));
  // Of buffers for eight frames and three images, one is the picture that is being encoded.
  EXPECT_LE(record().most_ahead, 11);
  EXPECT_GT(record().most_ahead, 6);
}

// Only three, and three images.
TEST_F(Stages, HoldFewFramesOfManyParticles) {
  scene_.duration = 2;
  run_with({.particles = 10'000'000, .encode_time = std::chrono::milliseconds(5)});
  EXPECT_EQ(record().encoded, frames(41));
  EXPECT_LE(record().most_ahead, 6);
}

TEST_F(Stages, OverlapWithEachOther) {
  // The solver needs 8 ms a frame, so that drawing and encoding always have a frame to go on with.
  run_with({.step_time = std::chrono::milliseconds(2),
            .draw_time = std::chrono::milliseconds(12),
            .encode_time = std::chrono::milliseconds(12)});
  EXPECT_EQ(record().most_at_once, 3);  // a step, a drawing and an encoding at one moment
}

TEST_F(Stages, CountThemselvesForTheSolverWhileTheyWork) {
  run_with({.step_time = std::chrono::milliseconds(2), .draw_time = std::chrono::milliseconds(3)});
  EXPECT_THAT(record().others_at_work, ElementsAre(0, 1));
  options_.force = true;
  run_with({.step_time = std::chrono::milliseconds(2),
            .draw_time = std::chrono::milliseconds(3),
            .encode_time = std::chrono::milliseconds(20)});
  EXPECT_THAT(record().others_at_work, Contains(2));
}

TEST_F(Stages, ReportAFailedDrawing) {
  const RunResult result = run_with({.draw_fails_at = 3});
  EXPECT_EQ(result.exit, ExitCode::no_device);
  EXPECT_THAT(result.message, HasSubstr("drawing failed on purpose"));
  EXPECT_EQ(record().encoded, frames(3));
  EXPECT_TRUE(record().movie_finished);  // drawn pictures are readable
  EXPECT_EQ(manifest()["exit"], 4);
}

TEST_F(Stages, ReportAFailedEncoder) {
  scene_.output.frames = true;
  scene_.duration = 4;
  const RunResult result = run_with({.encode_fails_at = 2});
  EXPECT_EQ(result.exit, ExitCode::output);
  EXPECT_THAT(result.message, HasSubstr("encoding failed on purpose"));
  EXPECT_EQ(record().encoded, frames(2));
  EXPECT_FALSE(record().movie_finished);  // the part file remains
  EXPECT_LT(record().filled, 81);         // the solver did not go on to the end
  EXPECT_EQ(manifest()["exit"], 5);
}

TEST_F(Stages, FinishTheMovieWhenAPngFails) {
  scene_.output.frames = true;
  const RunResult result = run_with({.png_fails_at = 4});
  EXPECT_EQ(result.exit, ExitCode::output);
  EXPECT_THAT(result.message, HasSubstr("PNG failed on purpose"));
  EXPECT_EQ(record().encoded, record().drawn);
  EXPECT_TRUE(record().movie_finished);
}

TEST_F(Stages, ReportAMovieThatCannotBeFinished) {
  const RunResult result = run_with({.finish_fails = true});
  EXPECT_EQ(result.exit, ExitCode::output);
  EXPECT_THAT(result.message, HasSubstr("finishing failed on purpose"));
}

TEST_F(Stages, LeaveNothingBehindWithoutDevice) {
  EXPECT_THROW(run_with({.no_device = true}), DeviceError);
  EXPECT_FALSE(fs::exists(options_.folder));
}

TEST_F(Stages, LeaveNothingBehindWithoutEncoder) {
  options_.folder = temporary_ / "deep" / "run";
  EXPECT_THROW(run_with({.no_encoder = true}), OutputError);
  EXPECT_FALSE(fs::exists(temporary_ / "deep"));
}

TEST_F(Stages, CloseEverythingWhenTheSimulationDiverges) {
  scene_.output.log.every = 0.05;
  const RunResult result = run_with({.diverge_in_step = 10});
  EXPECT_EQ(result.exit, ExitCode::diverged);
  EXPECT_EQ(result.message, "diverged on purpose");
  EXPECT_EQ(record().encoded, frames(3));  // 4 steps a frame: frames 0, 1, 2
  EXPECT_TRUE(record().movie_finished);
  EXPECT_EQ(manifest()["exit"], 3);
  EXPECT_THAT(read_file(options_.folder / "log.csv"), HasSubstr("\n0.1,8,"));
}

TEST_F(Stages, ReportBothWhenTheMovieFailsAfterADivergence) {
  const RunResult result = run_with({.diverge_in_step = 10, .finish_fails = true});
  EXPECT_EQ(result.exit, ExitCode::diverged);
  EXPECT_THAT(result.message, HasSubstr("diverged on purpose"));
  EXPECT_THAT(result.message, HasSubstr("finishing failed on purpose"));
}

TEST_F(Stages, CloseEverythingOnASignal) {
  const std::atomic<bool> stop = true;
  options_.stop = &stop;
  const RunResult result = run_with({});
  EXPECT_EQ(result.exit, ExitCode::stopped);
  EXPECT_THAT(result.message, HasSubstr("stopped by a signal at 0 s of 0.5 s"));
  EXPECT_THAT(result.message, HasSubstr("small.mp4"));
  EXPECT_THAT(result.message, HasSubstr("No checkpoint was written"));
  EXPECT_EQ(record().encoded, frames(1));
  EXPECT_TRUE(record().movie_finished);
  EXPECT_EQ(manifest()["exit"], 6);
}

TEST_F(Stages, StopAfterTheGivenWallTime) {
  options_.max_wall_time = 0.05;
  const RunResult result = run_with({.step_time = std::chrono::milliseconds(5)});  // 40 steps, 0.2 s
  EXPECT_EQ(result.exit, ExitCode::stopped);
  EXPECT_THAT(result.message, HasSubstr("--max-wall-time of 0.05 s"));
  EXPECT_LT(manifest()["steps"], 20);
  EXPECT_TRUE(record().movie_finished);
}

TEST_F(Stages, RefuseAnInvalidSceneBeforeAnythingElse) {
  scene_.duration = -1;
  EXPECT_THROW(run_with({}), SceneError);
  EXPECT_FALSE(fs::exists(options_.folder));
  EXPECT_THAT(record().drawn, IsEmpty());
}

TEST_F(Stages, AreInTheTraceOnTheirThreads) {
  options_.trace = true;
  scene_.output.stills = {0.1};
  EXPECT_EQ(run_with({}).exit, ExitCode::done);
  std::map<int, std::string> threads;
  std::set<std::pair<std::string, std::string>> spans;  // thread and span
  const auto events = nlohmann::json::parse(read_file(options_.folder / "trace.json"))["traceEvents"];
  for (const auto& event : events)
    if (event["ph"] == "M") threads[event["tid"]] = event["args"]["name"];
  for (const auto& event : events)
    if (event["ph"] == "X") spans.emplace(threads[event["tid"]], event["name"]);
  for (const auto& [thread, span] : {std::pair("drawing", "start device"), std::pair("drawing", "begin picture"),
                                     std::pair("drawing", "finish picture"), std::pair("drawing", "draw"),
                                     std::pair("encoding", "encode"), std::pair("encoding", "finish movie")})
    EXPECT_EQ(spans.count({thread, span}), 1U) << thread << " " << span;
  EXPECT_EQ(spans.count({"png 1", "write PNG"}) + spans.count({"png 2", "write PNG"}), 1U);
}

TEST_F(Stages, EndTheTraceOfARunThatCannotBegin) {
  options_.trace = true;
  EXPECT_THROW(run_with({.no_device = true}), DeviceError);
  EXPECT_FALSE(Trace::on());
}

TEST_F(Stages, AreAccountedForInTheManifest) {
  run_with({.draw_time = std::chrono::milliseconds(2), .encode_time = std::chrono::milliseconds(3)});
  const nlohmann::json facts = manifest();
  EXPECT_EQ(facts["version"], WEIR_VERSION);
  EXPECT_EQ(facts["state_hash"], "state of step 40");
  EXPECT_EQ(facts["dimension"], 2);
  EXPECT_EQ(facts["particles"]["fluid"], 1);
  EXPECT_EQ(facts["steps"], 40);
  EXPECT_EQ(facts["threads"], 2);
  EXPECT_EQ(facts["gl_renderer"], "fake renderer");
  EXPECT_EQ(facts["encoder"], "fake encoder");
  EXPECT_EQ(facts["exit"], 0);
  EXPECT_EQ(facts["max_density_error"], 5.0);           // an eighth of the step
  EXPECT_EQ(facts["particle_steps_per_second"], 10.0);  // 1 particle * 40 steps / (1 s + 3 s)
  EXPECT_GE(facts["wall_time_s"]["render"], 0.022);     // 11 * 2 ms
  EXPECT_GE(facts["wall_time_s"]["encode"], 0.033);     // 11 * 3 ms
  EXPECT_EQ(facts["wall_time_s"]["neighbours"], 1.0);
  EXPECT_EQ(facts["wall_time_s"]["solve"], 4.0);  // neighbours included
  for (const char* key : {"total", "setup", "write"}) {
    EXPECT_TRUE(facts["wall_time_s"][key].is_number()) << key;
  }
  EXPECT_FALSE(facts["instruction_set"].get<std::string>().empty());
}

}  // namespace

}  // namespace weir
