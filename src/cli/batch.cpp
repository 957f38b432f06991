#include <fmt/format.h>
#include <poll.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "cli/child.h"
#include "cli/commands.h"
#include "cli/scene_options.h"
#include "cli/signals.h"
#include "cli/wall_time.h"
#include "core/error.h"
#include "core/stopwatch.h"
#include "core/thread_pool.h"
#include "run/run_folder.h"
#include "scene/reader.h"

namespace weir {

namespace fs = std::filesystem;

namespace {

struct BatchCommand {
  std::vector<std::string> scenes;
  std::string folder = "out";
  std::vector<std::string> set;
  int jobs = 1;
  int threads = 0;
  bool force = false;
  std::string device;
};

struct Job {
  fs::path scene;
  std::string name;
  fs::path folder;
  std::optional<Child> child;
  std::optional<fs::file_time_type> manifest_before;
  Stopwatch watch;
  std::optional<int> exit;  // none: not run
  double seconds = 0;
  bool was_there = false;
};

std::optional<fs::file_time_type> manifest_time(const fs::path& folder) {
  std::error_code missing;
  const fs::file_time_type time = fs::last_write_time(folder / "manifest.json", missing);
  return missing ? std::nullopt : std::optional(time);
}

// An invalid scene, which its own process reports, is named after its file.
std::string name_of(const fs::path& scene, const std::vector<Override>& settings) {
  try {
    return read_scene(scene, settings).name;
  } catch (const SceneError&) {
    return scene.stem().string();
  }
}

class Batch {
 public:
  explicit Batch(const BatchCommand& options);
  ExitCode run();

 private:
  void start(Job& job);
  void listen(std::vector<Job*>& running);
  void end(Job& job);
  void print_table() const;
  ExitCode worst_exit() const;

  const BatchCommand& options_;
  std::vector<Job> jobs_;
  bool stopping_ = false;
};

Batch::Batch(const BatchCommand& options) : options_(options) {
  const std::vector<Override> settings = overrides(options.set);  // refused here once instead of by every scene
  std::map<std::string, fs::path> names;
  for (const std::string& scene : options.scenes) {
    Job job;
    job.scene = scene;
    job.name = name_of(job.scene, settings);
    job.folder = fs::path(options.folder) / job.name;
    const auto [other, is_new] = names.emplace(job.name, job.scene);
    if (!is_new) {
      throw UsageError(fmt::format("{} and {} would both write {}: rename one, or run them in two batches",
                                   other->second.string(), scene, job.folder.string()));
    }
    jobs_.push_back(std::move(job));
  }
}

void Batch::start(Job& job) {
  const int at_once = std::min(options_.jobs, static_cast<int>(jobs_.size()));
  const int threads = std::max(1, thread_count(options_.threads) / at_once);
  std::vector<std::string> arguments{
      "run", job.scene.string(), "-o", job.folder.string(), "--progress", "none", "--threads", std::to_string(threads)};
  if (options_.force) arguments.emplace_back("--force");
  if (!options_.device.empty()) arguments.insert(arguments.end(), {"--gl-device", options_.device});
  for (const std::string& value : options_.set) arguments.insert(arguments.end(), {"--set", value});
  job.manifest_before = manifest_time(job.folder);
  job.watch = Stopwatch();
  job.child.emplace(arguments);
}

void Batch::end(Job& job) {
  job.exit = job.child->wait();
  job.child.reset();
  job.seconds = job.watch.seconds();
  job.was_there = job.exit == 0 && job.manifest_before && manifest_time(job.folder) == job.manifest_before;
}

void Batch::listen(std::vector<Job*>& running) {
  std::vector<pollfd> outputs;
  outputs.reserve(running.size());
  for (const Job* job : running) outputs.push_back({job->child->output(), POLLIN, 0});
  constexpr int patience = 200;  // ms, until signals are looked at again
  if (poll(outputs.data(), outputs.size(), patience) <= 0) return;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].revents == 0) continue;
    Job& job = *running[i];
    for (const std::string& line : job.child->read_lines()) fmt::print(stderr, "[{}] {}\n", job.name, line);
    if (job.child->ended()) end(job);
  }
  std::erase_if(running, [](const Job* job) { return !job->child; });
}

ExitCode Batch::run() {
  const std::atomic<bool>& stop = catch_stop_signals();
  std::vector<Job*> running;
  std::size_t next = 0;
  for (;;) {
    if (stop && !stopping_) {
      stopping_ = true;
      for (const Job* job : running) job->child->stop(SIGTERM);
    }
    while (!stopping_ && next < jobs_.size() && running.size() < static_cast<std::size_t>(options_.jobs)) {
      start(jobs_[next]);
      running.push_back(&jobs_[next++]);
    }
    if (running.empty()) break;
    listen(running);
  }
  print_table();
  return worst_exit();
}

void Batch::print_table() const {
  std::size_t width = std::string_view("scene").size();
  for (const Job& job : jobs_) width = std::max(width, job.name.size());
  fmt::print("{:<{}}  {:>4}  {:>9}  {:>9}  {}\n", "scene", width, "exit", "seconds", "steps", "folder");
  for (const Job& job : jobs_) {
    // An invalid or refused scene wrote nothing; its folder holds another run's files.
    const bool wrote = job.exit && *job.exit != static_cast<int>(ExitCode::usage);
    const std::optional<Manifest> past = wrote ? past_run(job.folder / "manifest.json") : std::nullopt;
    fmt::print("{:<{}}  {:>4}  {:>9}  {:>9}  {}\n", job.name, width, job.exit ? std::to_string(*job.exit) : "-",
               job.was_there ? "was there"
               : job.exit    ? fmt::format("{:.1f}", job.seconds)
                             : "-",
               past ? std::to_string(past->steps) : "-", wrote ? job.folder.string() : "-");
  }
}

ExitCode Batch::worst_exit() const {
  int worst = stopping_ ? static_cast<int>(ExitCode::stopped) : 0;
  for (const Job& job : jobs_) {
    if (!job.exit) continue;
    // A process that crashed has no exit code of ours.
    worst = std::max(
        worst, *job.exit <= static_cast<int>(ExitCode::stopped) ? *job.exit : static_cast<int>(ExitCode::internal));
  }
  return static_cast<ExitCode>(worst);
}

}  // namespace

void add_batch(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("batch", "Run many scenes, each in a process of its own");
  const auto options = std::make_shared<BatchCommand>();
  command->add_option("scenes", options->scenes, "Scenes, YAML files")->type_name("SCENE.yaml...")->required();
  command->add_option("-o,--output", options->folder, "Folder of the run folders, DIR/<scene name>; default: out")
      ->type_name("DIR");
  command->add_option("-j,--jobs", options->jobs, "Scenes at a time, dividing the threads; default: 1")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  add_set(*command, options->set);
  add_threads(*command, options->threads);
  command->add_flag("--force", options->force, "Overwrite other runs in the folders");
  add_gl_device(*command, options->device);
  add_unbuilt_flag(*command, "--slurm");
  command->footer(
      "One that fails does not stop the others; those already finished are skipped, so the same command goes on\n"
      "where it was stopped. A table is printed at the end; the exit code is the largest of all scenes.");
  command->callback([&action, options] { action = [options] { return Batch(*options).run(); }; });
}

}  // namespace weir
