#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/scene_options.h"
#include "cli/terminal.h"
#include "cli/wall_time.h"
#include "core/stopwatch.h"
#include "core/thread_pool.h"
#include "run/run_folder.h"
#include "scene/advice.h"
#include "scene/check.h"
#include "sph/simulation.h"

namespace weir {

namespace {

struct CheckCommand {
  std::vector<std::string> scenes;
  std::vector<std::string> set;
  int threads = 0;
  bool print = false;
};

// The speed of this machine is measured by solving the scene itself for this long, s.
constexpr double trial_time = 0.5;
constexpr std::int64_t least_trial_steps = 2;
// Beyond this even a single step takes too long to wait for.
constexpr std::int64_t most_trial_particles = 2'000'000;

// Estimated time for solving the whole scene, as text.
std::string run_time(const Scene& scene, const Estimate& cost, int threads) {
  if (cost.fluid_particles + cost.wall_particles > most_trial_particles) {
    return fmt::format("not measured: the scene has more than {} particles", most_trial_particles);
  }
  try {
    const std::unique_ptr<Simulation> simulation = make_simulation(scene, threads);
    const Stopwatch watch;
    while (!simulation->finished() && (watch.seconds() < trial_time || simulation->steps() < least_trial_steps)) {
      simulation->step();
    }
    if (simulation->steps() == 0) return "nothing to solve";
    const double seconds_per_step = watch.seconds() / static_cast<double>(simulation->steps());
    return fmt::format("about {} of solving with {} thread{} (measured: {} steps, {:.2e} particle steps/s)",
                       wall_time_text(seconds_per_step * static_cast<double>(cost.steps)), threads,
                       threads == 1 ? "" : "s", simulation->steps(),
                       static_cast<double>(cost.fluid_particles) / seconds_per_step);
  } catch (const SimulationError& error) {
    return fmt::format("unknown: it diverges at once: {}", error.what());
  }
}

std::string pictures(const Scene& scene) {
  if (!draws(scene)) return "none";
  const auto every = scene.output.movie || scene.output.frames ? last_frame(scene) + 1
                                                               : static_cast<std::int64_t>(scene.output.stills.size());
  return fmt::format("{} of {} x {}", every, scene.render.size[0], scene.render.size[1]);
}

void print_facts(const std::string& file, const Scene& scene, int threads) {
  const Estimate cost = estimate(scene);
  fmt::print("{}: the scene is valid\n", file);
  fmt::print("  particles  {} fluid, {} wall\n", cost.fluid_particles, cost.wall_particles);
  fmt::print("  memory     about {:.1f} MB\n", cost.memory / 1e6);
  fmt::print("  mass       {:.6g} kg{}, {:+.3f} % from that of the exact shapes\n", cost.mass,
             scene.dimension == 2 ? " per metre of depth" : "", 100 * cost.mass_error);
  fmt::print("  time step  about {:.3g} s\n", cost.dt);
  fmt::print("  steps      about {}\n", cost.steps);
  fmt::print("  run time   {}\n", run_time(scene, cost, threads));
  fmt::print("  pictures   {}\n", pictures(scene));
  for (const std::string& text : advice(scene)) fmt::print("  advice     {}\n", text);
}

ExitCode check_scenes(const CheckCommand& options) {
  const std::vector<Override> set = overrides(options.set);
  ExitCode exit = ExitCode::done;
  bool first = true;
  for (const std::string& file : options.scenes) {
    try {
      const Scene scene = read_scene(file, set);
      if (options.print) {
        fmt::print("{}{}", first ? "" : "---\n", effective_scene_text(scene));
      } else {
        print_facts(file, scene, thread_count(options.threads));
      }
      first = false;
    } catch (const SceneError& error) {
      say_mistakes(error.what());
      exit = ExitCode::usage;
    }
  }
  return exit;
}

}  // namespace

void add_check(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("check", "Find every mistake in scenes; estimate the cost of runs");
  const auto options = std::make_shared<CheckCommand>();
  command->add_option("scenes", options->scenes, "Scenes, YAML files")->type_name("SCENE.yaml...")->required();
  add_set(*command, options->set);
  add_threads(*command, options->threads);
  command->add_flag("--print", options->print, "Print the effective scene instead, all defaults filled in");
  command->footer("Mistakes are listed as file:line:column: error: message. Nothing is written.");
  command->callback([&action, options] { action = [options] { return check_scenes(*options); }; });
}

}  // namespace weir
