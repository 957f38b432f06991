// check, batch, info, schema, help and reserved options.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "cli/program.h"
#include "cli/scene_text.h"
#include "pipeline/temporary_folder.h"

namespace weir {

namespace fs = std::filesystem;

namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class Commands : public testing::Test {
 protected:
  Commands() { put_file(scene_, small_scene_text); }

  TemporaryFolder temporary_;
  fs::path scene_ = temporary_ / "small.yaml";
};

TEST_F(Commands, CheckPrintsTheCostOfAScene) {
  const Outcome outcome = weir_program({"check", scene_.string()});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("particles  100 fluid, "));
  EXPECT_THAT(outcome.out, HasSubstr("mass       250 kg per metre of depth, +0.000 %"));  // 1000 kg/m^3 * 0.5 m * 0.5 m
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("memory"), HasSubstr("time step"), HasSubstr("steps")));
  EXPECT_THAT(outcome.out, ContainsRegex("run time   about [0-9.]+ s of solving"));
  EXPECT_THAT(outcome.out, HasSubstr("pictures   6 of 64 x 48"));
  EXPECT_FALSE(fs::exists("out/small"));
}

TEST_F(Commands, CheckReportsEveryMistakeOfEveryScene) {
  const fs::path wrong = temporary_ / "wrong.yaml";
  put_file(wrong, small_scene_text + "first: 1\nsecond: 2\n");
  const Outcome outcome = weir_program({"check", wrong.string(), scene_.string()});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, HasSubstr(wrong.string() + ":12:1: error: "));
  EXPECT_THAT(outcome.err, HasSubstr(wrong.string() + ":13:1: error: "));
  EXPECT_THAT(outcome.out, StartsWith(scene_.string() + ": the scene is valid"));
}

TEST_F(Commands, CheckPrintsTheEffectiveScene) {
  const Outcome outcome = weir_program({"check", scene_.string(), "--print", "--set", "duration=0.3"});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  const fs::path printed = temporary_ / "printed.yaml";
  put_file(printed, outcome.out);
  EXPECT_THAT(outcome.out, HasSubstr("duration: 0.3"));
  EXPECT_THAT(outcome.out, HasSubstr("rest_density: 1000"));  // a default
  EXPECT_EQ(weir_program({"check", printed.string(), "--print"}).out, outcome.out);
}

TEST_F(Commands, BatchRunsEverySceneThoughOneIsInvalid) {
  const fs::path wrong = temporary_ / "wrong.yaml";
  const fs::path other = temporary_ / "other.yaml";
  put_file(wrong, small_scene_text + "colour: red\n");
  put_file(other, small_scene_text);
  const std::vector<std::string> arguments{
      "batch", scene_.string(), wrong.string(), other.string(), "-o", temporary_.path().string(), "-j", "2"};
  const Outcome outcome = weir_program(arguments);
  EXPECT_EQ(outcome.exit, 2) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("[wrong] " + wrong.string() + ":12:1: error: "));
  EXPECT_THAT(outcome.out, ContainsRegex("scene +exit +seconds +steps +folder\n"));
  EXPECT_THAT(outcome.out, ContainsRegex("small +0 +[0-9.]+ +[0-9]+ +.*/small\n"));
  EXPECT_THAT(outcome.out, ContainsRegex("wrong +2 +[0-9.]+ +- +-\n"));
  EXPECT_THAT(outcome.out, ContainsRegex("other +0 +[0-9.]+ +[0-9]+ +.*/other\n"));
  const auto manifest = nlohmann::json::parse(file_text(temporary_ / "small" / "manifest.json"));
  EXPECT_TRUE(fs::exists(temporary_ / "other" / "other.mp4"));
  EXPECT_FALSE(fs::exists(temporary_ / "wrong"));

  const Outcome again = weir_program(arguments);
  EXPECT_EQ(again.exit, 2);
  EXPECT_THAT(again.out, ContainsRegex("small +0 +was there +" + manifest["steps"].dump() + " "));
}

TEST_F(Commands, BatchDividesTheThreads) {
  const fs::path other = temporary_ / "other.yaml";
  put_file(other, small_scene_text);
  ASSERT_EQ(weir_program({"batch", scene_.string(), other.string(), "-o", temporary_.path().string(), "-j", "2",
                          "--threads", "6", "--set", "output.movie=false"})
                .exit,
            0);
  const auto manifest = nlohmann::json::parse(file_text(temporary_ / "small" / "manifest.json"));
  EXPECT_EQ(manifest["threads"], 3);
}

TEST_F(Commands, BatchRefusesTwoScenesOfOneName) {
  const fs::path twin = temporary_ / "twin" / "small.yaml";
  put_file(twin, small_scene_text);
  const Outcome outcome = weir_program({"batch", scene_.string(), twin.string(), "-o", (temporary_ / "out").string()});
  EXPECT_EQ(outcome.exit, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr(scene_.string()), HasSubstr(twin.string())));
  EXPECT_FALSE(fs::exists(temporary_ / "out"));
}

TEST_F(Commands, BatchNamesFoldersAfterScenes) {
  const fs::path twin = temporary_ / "twin" / "small.yaml";
  put_file(twin, small_scene_text + "name: twin_2\n");
  const fs::path out = temporary_ / "out";
  ASSERT_EQ(weir_program({"batch", scene_.string(), twin.string(), "-o", out.string()}).exit, 0);
  EXPECT_TRUE(fs::exists(out / "small" / "small.mp4"));
  EXPECT_TRUE(fs::exists(out / "twin_2" / "twin_2.mp4"));
}

TEST_F(Commands, BatchPassesASignalOn) {
  const fs::path other = temporary_ / "other.yaml";
  put_file(other, small_scene_text);
  const fs::path never = temporary_ / "never.yaml";
  put_file(never, small_scene_text);
  Program program({"batch", scene_.string(), other.string(), never.string(), "-o", temporary_.path().string(), "-j",
                   "2", "--set", "duration=100000"});
  ASSERT_TRUE(program.says("[small] weir: encoding"));
  ASSERT_TRUE(program.says("[other] weir: encoding"));
  program.signal(SIGTERM);
  const Outcome outcome = program.wait();
  EXPECT_EQ(outcome.exit, 6) << outcome.err;
  for (const char* name : {"small", "other"}) {
    const auto manifest = nlohmann::json::parse(file_text(temporary_ / name / "manifest.json"), nullptr, false);
    ASSERT_TRUE(manifest.is_object()) << name;
    EXPECT_EQ(manifest["exit"], 6) << name;
  }
  EXPECT_FALSE(fs::exists(temporary_ / "never"));
  EXPECT_THAT(outcome.out, ContainsRegex("never +- +- +- +-\n"));
}

TEST_F(Commands, InfoListsDevicesAndEncoders) {
  const Outcome outcome = weir_program({"info", "--json"});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  const auto facts = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(facts["version"], WEIR_VERSION);
  EXPECT_GE(facts["threads"], 1);
  EXPECT_GE(facts["devices"].size(), 1U);
  EXPECT_TRUE(facts["chosen_device"].is_number());
  EXPECT_FALSE(facts["gl_renderer"].get<std::string>().empty());
  EXPECT_THAT(facts["encoders"].dump(), HasSubstr("libx264"));
  const Outcome text = weir_program({"info"});
  EXPECT_THAT(text.out, AllOf(StartsWith("weir "), HasSubstr("libx264"), HasSubstr("device 0")));
}

TEST_F(Commands, InfoSaysSoWithoutOpenGl) {
  const Outcome outcome =
      weir_program({"info"}, {.environment = {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere.json"}}});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("OpenGL      none usable"));
}

TEST_F(Commands, InfoFollowsTheThreadsOfTheEnvironment) {
  const auto facts =
      nlohmann::json::parse(weir_program({"info", "--json"}, {.environment = {{"OMP_NUM_THREADS", "5"}}}).out);
  EXPECT_EQ(facts["threads"], 5);
}

TEST_F(Commands, SchemaIsJsonSchemaDraft7) {
  const Outcome outcome = weir_program({"schema"});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
  const auto schema = nlohmann::json::parse(outcome.out);
  EXPECT_THAT(schema["$schema"].get<std::string>(), HasSubstr("draft-07"));
  EXPECT_TRUE(schema["properties"].contains("fluid"));
}

TEST_F(Commands, RefuseAWrongCommandLine) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{},
                                                    {"fly"},
                                                    {"run"},
                                                    {"run", scene_.string(), "--fast"},
                                                    {"check"},
                                                    {"batch"},
                                                    {"run", scene_.string(), "--threads", "0"},
                                                    {"run", scene_.string(), "--threads", "many"},
                                                    {"run", scene_.string(), "--progress", "loud"},
                                                    {"batch", scene_.string(), "-j", "0"},
                                                    {"compare", "a"}}) {
    const Outcome outcome = weir_program(arguments);
    EXPECT_EQ(outcome.exit, 2) << testing::PrintToString(arguments) << outcome.err;
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(outcome.err, StartsWith("weir: error: "));
  }
}

TEST_F(Commands, RefuseReservedOptionsByName) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> unbuilt{
      {{"sweep", scene_.string(), "--vary", "a=1,2"}, "weir sweep is not built yet"},
      {{"render", temporary_.path().string()}, "weir render is not built yet"},
      {{"batch", scene_.string(), "--slurm"}, "--slurm is not built yet"}};
  for (const auto& [arguments, message] : unbuilt) {
    const Outcome outcome = weir_program(arguments);
    EXPECT_EQ(outcome.exit, 2);
    EXPECT_THAT(outcome.err, HasSubstr(message));
  }
}

TEST_F(Commands, NameUnknownCommands) { EXPECT_THAT(weir_program({"fly"}).err, HasSubstr("no such command: fly")); }

TEST_F(Commands, PrintTheVersion) {
  const Outcome outcome = weir_program({"--version"});
  EXPECT_EQ(outcome.exit, 0);
  EXPECT_EQ(outcome.out, "weir " WEIR_VERSION "\n");
}

// ---- help, man page, completions ----------------------------------------------------------------------------------

std::string without_backslashes(std::string text) {
  std::erase(text, '\\');
  return text;
}

TEST_F(Commands, ManPageAndCompletionsKnowEveryCommandAndOption) {
  const std::string man = without_backslashes(file_text("src/cli/weir.1"));
  const std::string completions = file_text("src/cli/weir.bash");
  const Outcome help = weir_program({"--help"});
  ASSERT_EQ(help.exit, 0);
  EXPECT_THAT(help.out, HasSubstr("weir run scenes/dam_break.yaml"));

  std::set<std::string> words;
  for (const char* command : {"run", "check", "batch", "compare", "report", "info", "schema"}) {
    EXPECT_THAT(help.out, HasSubstr(std::string("  ") + command + " "));
    words.insert(command);
    const Outcome of_command = weir_program({command, "--help"});
    ASSERT_EQ(of_command.exit, 0) << command;
    const std::regex option("(^|[ ,])(--?[a-z][a-z-]*)");
    for (std::sregex_iterator match(of_command.out.begin(), of_command.out.end(), option), end; match != end; ++match) {
      words.insert((*match)[2]);
    }
  }
  EXPECT_GT(words.size(), 15U);
  EXPECT_TRUE(words.contains("--max-wall-time"));
  for (const std::string& word : words) {
    const std::regex whole("(^|[^a-z-])" + word + "($|[^a-z-])");
    EXPECT_TRUE(std::regex_search(man, whole)) << word << " is not in the man page";
    EXPECT_TRUE(std::regex_search(completions, whole)) << word << " is not in the completions";
  }
  EXPECT_THAT(help.out, Not(HasSubstr("sweep")));
}

}  // namespace

}  // namespace weir
