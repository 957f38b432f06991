#include "run/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/thread_pool.h"
#include "core/trace.h"
#include "output/file.h"
#include "run/manifest_facts.h"
#include "run/outputs.h"
#include "scene/advice.h"

namespace weir {

namespace {

constexpr double progress_interval = 0.1;  // s

}  // namespace

Session::Session(const Scene& scene, const RunOptions& options, RunFolder& folder, std::string scene_text,
                 Provenance provenance)
    : scene_(scene),
      options_(options),
      folder_(folder),
      scene_text_(std::move(scene_text)),
      provenance_(std::move(provenance)),
      simulation_(make_simulation(scene, thread_count(options.threads),
                                  options.instruction_set ? *options.instruction_set : default_instruction_set())),
      context_{scene_, options_, provenance_, thread_count(options.threads), *simulation_} {}

void Session::open() {
  observers_ = make_observers(context_);
  step_ahead();
  for (const auto& observer : observers_) observer->await_start();
  try {
    open_files();
  } catch (...) {
    observers_.clear();
    folder_.withdraw();
    throw;
  }
  for (const std::string& text : advice(scene_)) context_.say(text);
  setup_seconds_ = since_start_.seconds();
}

// While an observer starts. Nothing is written yet, and an error is reported when the run begins.
void Session::step_ahead() {
  const auto starting = [](const auto& observer) { return observer->starting(); };
  const auto has_room = [](const auto& observer) { return observer->has_room(); };
  try {
    while (std::any_of(observers_.begin(), observers_.end(), starting) &&
           std::all_of(observers_.begin(), observers_.end(), has_room) && !simulation_->finished() &&
           reason_to_stop().empty()) {
      look(observers_, *simulation_);
      simulation_->step();
    }
  } catch (...) {
    failed_ahead_ = std::current_exception();
  }
}

void Session::open_files() {
  folder_.prepare();
  write_file(folder_.scene_file(), scene_text_);
  for (const auto& observer : observers_) observer->open(folder_.path());
  write_manifest(folder_.manifest_file(), opening_facts(context_, observers_));
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
  const auto failed = [](const auto& observer) { return observer->failed(); };
  for (;;) {
    look(observers_, *simulation_);
    report_progress();
    if (simulation_->finished() || std::any_of(observers_.begin(), observers_.end(), failed)) return;
    if (const std::string reason = reason_to_stop(); !reason.empty()) {
      outcome_.note(ExitCode::stopped,
                    fmt::format("{} at {:.6g} s of {:.6g} s", reason, simulation_->time(), scene_.duration));
      return;
    }
    simulation_->step();
  }
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
  progress.frame = pictures();
  progress.frames = scene_.output.movie || scene_.output.frames
                        ? last_frame(scene_) + 1
                        : static_cast<std::int64_t>(scene_.output.stills.size());
  progress.wall_time_left =
      progress.time > 0 ? (now - setup_seconds_) * (scene_.duration - progress.time) / progress.time : 0;
  options_.progress(progress);
}

RunResult Session::play() {
  outcome_.attempt([this] { step_through(); });
  for (auto observer = observers_.rbegin(); observer != observers_.rend(); ++observer) {
    outcome_.attempt([&] { (*observer)->finish(*simulation_, outcome_.exit() != ExitCode::diverged); });
  }
  if (outcome_.exit() == ExitCode::done) outcome_.append(what_was_written());
  if (outcome_.exit() == ExitCode::stopped) {
    outcome_.append(fmt::format(
        "; {}. No checkpoint was written, as this version has none: the run starts again from the beginning",
        what_was_written()));
  }
  if (options_.trace) outcome_.attempt([this] { write_file(folder_.trace_file(), Trace::finish()); });
  outcome_.attempt([this] { write_closing_manifest(); });
  RunResult result;
  result.exit = outcome_.exit();
  result.message = outcome_.message();
  result.folder = folder_.path();
  return result;
}

void Session::write_closing_manifest() const {
  Manifest facts = closing_facts(context_, observers_);
  facts.exit = outcome_.exit();
  facts.wall_time_s.setup = setup_seconds_;
  facts.wall_time_s.total = since_start_.seconds();
  write_manifest(folder_.manifest_file(), facts);
}

std::int64_t Session::pictures() const {
  std::int64_t sum = 0;
  for (const auto& observer : observers_) sum += observer->pictures();
  return sum;
}

std::string Session::what_was_written() const {
  std::string text = "wrote " + folder_.path().string() + "/: ";
  for (const std::string& name : folder_.top_names_of_outputs()) text += name + ", ";
  if (options_.trace) text += "trace.json, ";
  return text + fmt::format("manifest.json ({} steps, {} pictures, {:.1f} s)", simulation_->steps(), pictures(),
                            since_start_.seconds());
}

}  // namespace weir
