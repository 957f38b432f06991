// The choice of instructions, by option and by environment.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/program.h"
#include "cli/scene_text.h"
#include "pipeline/temporary_folder.h"
#include "simd/instruction_set.h"

namespace weir {

namespace fs = std::filesystem;

namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> usable_names() {
  std::vector<std::string> names;
  for (const InstructionSet set : usable_instruction_sets()) names.emplace_back(name_of(set));
  return names;
}

// An unknown one, and those that this processor lacks.
std::vector<std::string> names_that_are_not_usable() {
  std::vector<std::string> names{"sse9"};
  const auto usable = usable_instruction_sets();
  for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
    if (std::find(usable.begin(), usable.end(), set) == usable.end()) names.emplace_back(name_of(set));
  }
  return names;
}

class ChosenInstructionSet : public testing::Test {
 protected:
  ChosenInstructionSet() { put_file(scene_, small_scene_text); }

  Outcome run(std::vector<std::string> more, const std::string& wanted = "") {
    std::vector<std::string> arguments{"run",  scene_.string(), "-o",    folder_.string(),    "--progress",
                                       "none", "--force",       "--set", "output.movie=false"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return weir_program(arguments, {.environment = {{"WEIR_INSTRUCTION_SET", wanted}}});
  }
  std::string in_manifest() const {
    return nlohmann::json::parse(file_text(folder_ / "manifest.json")).at("instruction_set");
  }
  void expect_refused(const Outcome& outcome, const std::string& name) const {
    EXPECT_EQ(outcome.exit, 2) << name;
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(outcome.err, HasSubstr("'" + name + "'"));
    for (const std::string& usable : usable_names()) EXPECT_THAT(outcome.err, HasSubstr(usable));
    EXPECT_FALSE(fs::exists(folder_)) << name;
  }

  TemporaryFolder temporary_;
  fs::path scene_ = temporary_ / "small.yaml";
  fs::path folder_ = temporary_ / "run";
};

TEST_F(ChosenInstructionSet, IsNamedByOptionOrEnvironment) {
  for (const std::string& name : usable_names()) {
    ASSERT_EQ(run({"--instruction-set", name}).exit, 0) << name;
    EXPECT_EQ(in_manifest(), name);
    ASSERT_EQ(run({}, name).exit, 0) << name;
    EXPECT_EQ(in_manifest(), name) << "by the environment";
  }
}

TEST_F(ChosenInstructionSet, IsTheLastUsableOneByDefault) {
  ASSERT_EQ(run({}).exit, 0);
  EXPECT_EQ(in_manifest(), usable_names().back());
}

TEST_F(ChosenInstructionSet, IsTheOptionsBeforeTheEnvironments) {
  ASSERT_EQ(run({"--instruction-set", "baseline"}, usable_names().back()).exit, 0);
  EXPECT_EQ(in_manifest(), "baseline");
}

TEST_F(ChosenInstructionSet, MustBeUsableOrNothingIsWritten) {
  for (const std::string& name : names_that_are_not_usable()) {
    expect_refused(run({"--instruction-set", name}), name);
    expect_refused(run({}, name), name);
  }
}

TEST_F(ChosenInstructionSet, IsListedByInfo) {
  const auto info = [](const std::string& wanted, std::vector<std::string> arguments) {
    return weir_program(std::move(arguments), {.environment = {{"WEIR_INSTRUCTION_SET", wanted}}});
  };
  for (const std::string& name : usable_names()) {
    const auto facts = nlohmann::json::parse(info(name, {"info", "--json"}).out);
    EXPECT_EQ(facts["instruction_sets"], nlohmann::json(usable_names()));
    EXPECT_EQ(facts["instruction_set"], name);
  }
  const std::string text = info("", {"info"}).out;
  for (const std::string& name : usable_names()) EXPECT_THAT(text, HasSubstr(name));
  EXPECT_EQ(info("sse9", {"info"}).exit, 2);
}

}  // namespace

}  // namespace weir
