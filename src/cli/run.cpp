#include <fmt/format.h>

#include <map>

#include "cli/commands.h"
#include "cli/progress.h"
#include "cli/scene_options.h"
#include "cli/signals.h"
#include "cli/wall_time.h"
#include "run/run.h"

namespace weir {

namespace {

struct RunCommand {
  std::string scene;
  std::string folder;
  std::vector<std::string> set;
  int threads = 0;
  bool force = false;
  bool trace = false;
  std::string progress = "auto";
  std::string max_wall_time;
  std::string device;
  std::string instruction_set;
};

const std::map<std::string, ProgressStyle>& progress_styles() {
  static const std::map<std::string, ProgressStyle> styles{{"auto", ProgressStyle::automatic},
                                                           {"bar", ProgressStyle::bar},
                                                           {"lines", ProgressStyle::lines},
                                                           {"json", ProgressStyle::json},
                                                           {"none", ProgressStyle::none}};
  return styles;
}

ExitCode run_scene(const RunCommand& options) {
  RunOptions run_options;
  run_options.folder = options.folder;
  run_options.threads = options.threads;
  run_options.force = options.force;
  run_options.trace = options.trace;
  if (!options.max_wall_time.empty()) run_options.max_wall_time = parse_wall_time(options.max_wall_time);
  run_options.device = device_choice(options.device);
  if (!options.instruction_set.empty()) run_options.instruction_set = instruction_set_by_name(options.instruction_set);
  run_options.stop = &catch_stop_signals();

  ProgressReport report(progress_styles().at(options.progress));
  run_options.progress = [&report](const Progress& progress) { report.show(progress); };
  run_options.message = [&report](const std::string& text) { report.say(text); };

  const Scene scene = read_scene(options.scene, overrides(options.set));
  run_options.checked = true;
  const RunResult result = run(scene, run_options);
  report.end(result);
  fmt::print("{}\n", result.folder.string());
  return result.exit;
}

}  // namespace

void add_run(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("run", "Simulate a scene and write all that it asks for");
  const auto options = std::make_shared<RunCommand>();
  command->add_option("scene", options->scene, "The scene, a YAML file")->type_name("SCENE.yaml")->required();
  command->add_option("-o,--output", options->folder, "Folder to write; default: out/<scene name>")->type_name("DIR");
  add_set(*command, options->set);
  add_threads(*command, options->threads);
  command->add_flag("--force", options->force, "Overwrite another run in the folder");
  command
      ->add_option("--progress", options->progress,
                   "auto (a bar on a terminal, else lines), bar, lines, json (an object a line) or none")
      ->type_name("STYLE")
      ->check(CLI::IsMember(&progress_styles()).description(""));
  command
      ->add_option("--max-wall-time", options->max_wall_time, "Stop in good order after this time: 90, 90s, 15m or 2h")
      ->type_name("TIME");
  add_gl_device(*command, options->device);
  command
      ->add_option(
          "--instruction-set", options->instruction_set,
          "Instructions to solve with: baseline, avx2 or avx512; by default WEIR_INSTRUCTION_SET, else the best here")
      ->type_name("NAME");
  command->add_flag("--trace", options->trace, "Also write trace.json: where the time went, for a trace viewer");
  add_unbuilt_flag(*command, "--resume");
  command->footer(
      "The run folder is printed to standard output; everything else goes to standard error.\n"
      "Example: weir run scenes/dam_break.yaml -o out/try --set particles.spacing=0.02");
  command->callback([&action, options] { action = [options] { return run_scene(*options); }; });
}

}  // namespace weir
