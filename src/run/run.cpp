#include "run/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <vector>

#include "core/sha256.h"
#include "core/stopwatch.h"
#include "core/thread_pool.h"
#include "core/trace.h"
#include "output/file.h"
#include "output/log.h"
#include "output/manifest.h"
#include "run/log_schedule.h"
#include "run/pictures.h"
#include "run/run_folder.h"
#include "scene/advice.h"
#include "scene/check.h"

namespace weir {

namespace {

constexpr double progress_interval = 0.1;  // s

void refuse_wrong_scene(const Scene& scene) {
  std::vector<SceneMistake> mistakes;
  for (Violation& violation : check(scene)) mistakes.push_back({violation.path, std::move(violation.message)});
  if (!mistakes.empty()) throw SceneError(std::move(mistakes));
}

std::string_view unit_of(ColorBy quantity) {
  switch (quantity) {
    case ColorBy::speed:
      return "speed [m/s]";
    case ColorBy::density:
      return "density [kg/m^3]";
    case ColorBy::pressure:
      return "pressure [Pa]";
  }
  return "";
}

// One run from its first step to its manifest.
class Session {
 public:
  Session(const Scene& scene, const RunOptions& options, RunFolder& folder, std::string scene_text,
          Provenance provenance)
      : scene_(scene),
        options_(options),
        folder_(folder),
        scene_text_(std::move(scene_text)),
        provenance_(std::move(provenance)),
        threads_(thread_count(options.threads)),
        log_schedule_(scene.output.log.every) {}

  // Everything that can fail for lack of something: device, folder, encoder. Nothing stays behind when it throws.
  void open();
  // Steps to the end of the scene. Never throws: what went wrong is in the result.
  RunResult play();

 private:
  void step_ahead();
  void open_files();
  void step_through();
  void look();
  void log_row();
  void report_progress();
  std::string reason_to_stop() const;
  void note(ExitCode exit, const std::string& message);
  template <class Work>
  void attempt(Work work);
  Manifest opening_manifest() const;  // what is known from the start
  Manifest manifest() const;
  std::string what_was_written() const;
  void say(const std::string& text) const {
    if (options_.message) options_.message(text);
  }

  const Scene& scene_;
  const RunOptions& options_;
  RunFolder& folder_;
  std::string scene_text_;
  Provenance provenance_;
  int threads_;
  Stopwatch since_start_;
  double setup_seconds_ = 0;
  double log_seconds_ = 0;
  double next_progress_ = 0;  // s since the start
  std::unique_ptr<Simulation> simulation_;
  LogSchedule log_schedule_;
  std::optional<LogWriter> log_;
  std::vector<Diagnostics> early_rows_;  // of steps before there was a file
  std::exception_ptr failed_ahead_;      // by such a step
  double max_density_error_ = 0;         // over all rows of the log
  std::optional<Pictures> pictures_;
  ExitCode exit_ = ExitCode::done;
  std::string message_;
};

void Session::open() {
  simulation_ = make_simulation(scene_, threads_,
                                options_.instruction_set ? *options_.instruction_set : default_instruction_set());
  if (draws(scene_)) {
    const StaticScene static_scene = simulation_->static_scene();
    pictures_.emplace(scene_, static_scene, simulation_->fluid_particles(), options_.device);
    simulation_->give_way_to(pictures_->at_work());
    step_ahead();
    try {
      pictures_->await_device();
    } catch (...) {
      pictures_.reset();
      throw;
    }
    say(fmt::format("drawing with {}", pictures_->gl_renderer()));
    if (!scene_.render.color.range) {
      const auto [low, high] = color_range(scene_, static_scene);
      say(fmt::format("colour range of {}: {:.4g} to {:.4g}, estimated from the scene", unit_of(scene_.render.color.by),
                      low, high));
    }
  }
  try {
    open_files();
  } catch (...) {
    pictures_.reset();
    folder_.withdraw();
    throw;
  }
  for (const std::string& text : advice(scene_)) say(text);
  setup_seconds_ = since_start_.seconds();
}

// While the device starts. Nothing is written yet, and what goes wrong is told when the run begins.
void Session::step_ahead() {
  try {
    while (pictures_->device_starts() && pictures_->has_room() && !simulation_->finished() &&
           reason_to_stop().empty()) {
      look();
      simulation_->step();
    }
  } catch (...) {
    failed_ahead_ = std::current_exception();
  }
}

void Session::open_files() {
  folder_.prepare();
  if (pictures_) {
    pictures_->open(folder_, provenance_, threads_);
    if (scene_.output.movie) say(fmt::format("encoding with {}", pictures_->encoder()));
  }
  write_file(folder_.scene_file(), scene_text_);
  log_.emplace(folder_.log_file(), scene_.dimension);
  for (const Diagnostics& row : early_rows_) log_->write(row);
  write_manifest(folder_.manifest_file(), opening_manifest());  // without exit: this run has not ended
}

void Session::note(ExitCode exit, const std::string& message) {
  if (exit_ == ExitCode::done) {
    exit_ = exit;
    message_ = message;
  } else if (message_.find(message) == std::string::npos) {  // the same disk is full for every file
    message_ += "\n" + message;
  }
}

template <class Work>
void Session::attempt(Work work) {
  try {
    work();
  } catch (const SimulationError& error) {
    note(ExitCode::diverged, error.what());
  } catch (const OutputError& error) {
    note(ExitCode::output, error.what());
  } catch (const DeviceError& error) {
    note(ExitCode::no_device, error.what());
  } catch (const std::exception& error) {
    note(ExitCode::internal, error.what());
  }
}

std::string Session::reason_to_stop() const {
  if (options_.stop != nullptr && *options_.stop) return "stopped by a signal";
  if (options_.max_wall_time > 0 && since_start_.seconds() >= options_.max_wall_time) {
    return fmt::format("stopped after --max-wall-time of {} s", options_.max_wall_time);
  }
  return {};
}

void Session::step_through() {
  if (failed_ahead_) std::rethrow_exception(failed_ahead_);
  for (;;) {
    look();
    report_progress();
    if (simulation_->finished() || (pictures_ && pictures_->failed())) return;
    if (const std::string reason = reason_to_stop(); !reason.empty()) {
      note(ExitCode::stopped, fmt::format("{} at {:.6g} s of {:.6g} s", reason, simulation_->time(), scene_.duration));
      return;
    }
    simulation_->step();
  }
}

// At what the last step has led to.
void Session::look() {
  const std::int64_t frame = simulation_->frame_index();
  if (pictures_ && frame >= 0 && pictures_->wants(frame)) pictures_->add(*simulation_);
  if (simulation_->finished() || log_schedule_.due(simulation_->time())) log_row();
}

void Session::log_row() {
  const Stopwatch watch;
  const Diagnostics row = simulation_->diagnostics();
  if (log_)
    log_->write(row);
  else
    early_rows_.push_back(row);
  log_schedule_.written(row.time);
  max_density_error_ = std::max(max_density_error_, row.max_density_error);
  log_seconds_ += watch.seconds();
}

void Session::report_progress() {
  if (!options_.progress) return;
  const double now = since_start_.seconds();
  if (now < next_progress_ && !simulation_->finished()) return;
  next_progress_ = now + progress_interval;
  Progress progress;
  progress.time = simulation_->time();
  progress.duration = scene_.duration;
  progress.step = simulation_->steps();
  progress.frame = pictures_ ? pictures_->drawn() : 0;
  progress.frames = scene_.output.movie || scene_.output.frames
                        ? last_frame(scene_) + 1
                        : static_cast<std::int64_t>(scene_.output.stills.size());
  progress.wall_time_left =
      progress.time > 0 ? (now - setup_seconds_) * (scene_.duration - progress.time) / progress.time : 0;
  options_.progress(progress);
}

RunResult Session::play() {
  attempt([this] { step_through(); });
  attempt([this] {
    // The row of the last step when the run ended early, unless its state means nothing any more.
    if (exit_ != ExitCode::diverged && log_schedule_.last() != simulation_->time()) log_row();
    log_->close();
  });
  if (pictures_) attempt([this] { pictures_->finish(); });
  if (exit_ == ExitCode::done) message_ = what_was_written();
  if (exit_ == ExitCode::stopped) {
    message_ += fmt::format(
        "; {}. No checkpoint was written, as this version has none: the run starts again from the beginning",
        what_was_written());
  }
  if (options_.trace) attempt([this] { write_file(folder_.trace_file(), Trace::finish()); });
  attempt([this] {
    Manifest facts = manifest();
    facts.exit = exit_;
    write_manifest(folder_.manifest_file(), facts);
  });
  RunResult result;
  result.exit = exit_;
  result.message = message_;
  result.folder = folder_.path();
  return result;
}

std::string Session::what_was_written() const {
  std::string text = "wrote " + folder_.path().string() + "/: ";
  if (scene_.output.movie) text += folder_.movie_file().filename().string() + ", ";
  if (scene_.output.frames) text += "frames/, ";
  if (!scene_.output.stills.empty()) text += "stills/, ";
  if (options_.trace) text += "trace.json, ";
  return text + fmt::format("log.csv, manifest.json ({} steps, {} pictures, {:.1f} s)", simulation_->steps(),
                            pictures_ ? pictures_->drawn() : 0, since_start_.seconds());
}

Manifest Session::opening_manifest() const {
  Manifest facts;
  facts.version = provenance_.version;
  facts.scene_sha256 = provenance_.scene_sha256;
  facts.dimension = scene_.dimension;
  facts.particles = {.fluid = simulation_->fluid_particles(), .wall = simulation_->wall_particles()};
  facts.threads = threads_;
  facts.instruction_set = name_of(simulation_->instruction_set());
  if (pictures_) {
    facts.gl_renderer = pictures_->gl_renderer();
    facts.encoder = pictures_->encoder();
  }
  return facts;
}

Manifest Session::manifest() const {
  Manifest facts = opening_manifest();
  facts.state_hash = simulation_->state_hash();
  facts.steps = simulation_->steps();
  facts.simulated_time_s = simulation_->simulated_time();
  const StageTimes solver = simulation_->stage_times();
  facts.wall_time_s.setup = setup_seconds_;
  facts.wall_time_s.neighbours = solver.neighbours;
  facts.wall_time_s.solve = solver.neighbours + solver.solve;
  facts.wall_time_s.write = log_seconds_;
  if (facts.wall_time_s.solve > 0) {
    facts.particle_steps_per_second =
        static_cast<double>(facts.particles.fluid) * static_cast<double>(facts.steps) / facts.wall_time_s.solve;
  }
  if (pictures_) {
    const PictureTimes times = pictures_->times();
    facts.frames = pictures_->drawn();
    facts.wall_time_s.render = times.render;
    facts.wall_time_s.encode = times.encode;
    facts.wall_time_s.write += times.write;
  }
  facts.max_density_error = max_density_error_;
  facts.wall_time_s.total = since_start_.seconds();
  return facts;
}

}  // namespace

RunResult run(const Scene& scene, const RunOptions& options) {
  if (!options.checked) refuse_wrong_scene(scene);
  RunFolder folder(options.folder.empty() ? std::filesystem::path("out") / scene.name : options.folder, scene);
  std::string text = effective_scene_text(scene);
  const Provenance provenance{sha256(text), WEIR_VERSION};
  if (!options.force && folder.holds_finished(provenance)) {
    RunResult result;
    result.folder = folder.path();
    result.was_there = true;
    result.message = fmt::format("{} holds the identical finished run already", folder.path().string());
    return result;
  }
  folder.refuse_other_run(options.force);
  std::optional<Recording> recording;
  if (options.trace) {
    recording.emplace();
    Trace::name_thread("solver");
  }
  Session session(scene, options, folder, std::move(text), provenance);
  session.open();
  return session.play();
}

}  // namespace weir
