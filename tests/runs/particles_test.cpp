// Particle files of whole runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "output/file.h"
#include "output/helpers.h"
#include "pipeline/temporary_folder.h"
#include "run/run.h"
#include "runs/scenes.h"
#include "sph/simulation.h"
#include "support/particle_file.h"

namespace weir::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

class ParticleFiles : public ::testing::Test {
 protected:
  RunResult run_scene() {
    RunOptions options;
    options.folder = folder_.path();
    options.threads = 2;
    options.force = true;
    return run(scene_, options);
  }
  std::string state_hash() const { return read_manifest(folder_ / "manifest.json").state_hash; }
  std::vector<std::string> listed(const std::string& attribute) const {
    return listed_in_collection(read_file(folder_ / "particles.pvd"), attribute);
  }

  TemporaryFolder folder_;
  Scene scene_ = dam_break_run();
};

TEST_F(ParticleFiles, OfFramesHoldWhatTheSolverHas) {
  scene_.output.particles.emplace();
  ASSERT_EQ(run_scene().exit, ExitCode::done);
  ASSERT_EQ(listed("file").size(), 6U);
  const auto simulation = make_simulation(scene_, 1);
  Snapshot snapshot;
  for (;; simulation->step()) {
    if (const std::int64_t frame = simulation->frame_index(); frame >= 0) {
      simulation->fill(snapshot, {.fluid = {Quantity::velocity, Quantity::density, Quantity::pressure, Quantity::id}});
      const auto number = static_cast<std::size_t>(frame);
      EXPECT_EQ(listed("timestep").at(number), fmt::format("{}", simulation->time()));
      const ParticleFile file(read_file(folder_ / listed("file").at(number)));
      const std::vector<float> points = file.values<float>("Points");
      const std::vector<float> velocity = file.values<float>("velocity");
      ASSERT_EQ(points.size(), 3 * snapshot.fluid.count);
      ASSERT_EQ(velocity.size(), 3 * snapshot.fluid.count);
      for (std::size_t i = 0; i < snapshot.fluid.count; ++i) {
        EXPECT_EQ(glm::vec3(points[3 * i], points[3 * i + 1], points[3 * i + 2]), snapshot.fluid.positions[i]);
        EXPECT_EQ(velocity[3 * i], snapshot.fluid.reals(Quantity::velocity)[2 * i]);
        EXPECT_EQ(velocity[3 * i + 1], snapshot.fluid.reals(Quantity::velocity)[2 * i + 1]);
      }
      EXPECT_EQ(file.values<float>("density"), snapshot.fluid.reals(Quantity::density));
      EXPECT_EQ(file.values<float>("pressure"), snapshot.fluid.reals(Quantity::pressure));
      EXPECT_EQ(file.values<std::int32_t>("id"), snapshot.fluid.integers(Quantity::id));
    }
    if (simulation->finished()) break;
  }
}

TEST_F(ParticleFiles, ChangeNoBitOfTheState) {
  ASSERT_EQ(run_scene().exit, ExitCode::done);
  const std::string without = state_hash();
  scene_.output.particles.emplace();
  scene_.output.particles->every = 0.013;
  ASSERT_EQ(run_scene().exit, ExitCode::done);
  EXPECT_EQ(state_hash(), without);
}

TEST_F(ParticleFiles, WithAnIntervalHaveTheTimesOfTheirSteps) {
  scene_.output.particles.emplace();
  scene_.output.particles->every = 0.05;
  scene_.output.particles->fields = {field_of(Quantity::speed)};
  ASSERT_EQ(run_scene().exit, ExitCode::done);
  const std::vector<std::string> times = listed("timestep");
  ASSERT_EQ(times.size(), 5U);
  for (std::size_t k = 0; k < times.size(); ++k) {
    EXPECT_GE(std::stod(times[k]), 0.05 * static_cast<double>(k) - 1e-9);
    EXPECT_LT(std::stod(times[k]), 0.05 * static_cast<double>(k) + 0.01);
    const ParticleFile file(read_file(folder_ / listed("file")[k]));
    EXPECT_THAT(file.head(), HasSubstr(">" + times[k] + "</DataArray>"));
    EXPECT_THAT(file.head(), Not(HasSubstr("density")));
    EXPECT_EQ(file.values<float>("speed").size(), 300U);
  }
}

TEST_F(ParticleFiles, OfAnEarlierRunAreReplaced) {
  scene_.output.particles.emplace();
  ASSERT_EQ(run_scene().exit, ExitCode::done);
  write_file(folder_ / "particles_notes.vtp", "the user's");
  scene_.duration = 0.08;
  ASSERT_EQ(run_scene().exit, ExitCode::done);
  EXPECT_THAT(listed("file"), ElementsAre("particles_00000.vtp", "particles_00001.vtp", "particles_00002.vtp"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "particles_00003.vtp"));
  scene_.output.particles.reset();
  ASSERT_EQ(run_scene().exit, ExitCode::done);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "particles.pvd"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "particles_notes.vtp"));
}

TEST_F(ParticleFiles, ThatDoNotFitOnTheDiskFailTheRun) {
  scene_.output.particles.emplace();
  const testing::FileSizeLimit limit(8000);  // of 300 particles, 13 kB
  const RunResult result = run_scene();
  EXPECT_EQ(result.exit, ExitCode::output);
  EXPECT_THAT(result.message, HasSubstr("particles_00000.vtp: File too large"));
  EXPECT_TRUE(listed("file").empty());
}

TEST_F(ParticleFiles, AreNamedTogetherInTheClosingLine) {
  scene_.output.particles.emplace();
  EXPECT_THAT(run_scene().message, HasSubstr("log.csv, particles.pvd, particles_*.vtp, manifest.json"));
}

}  // namespace
}  // namespace weir::test
