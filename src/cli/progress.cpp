#include "cli/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/terminal.h"
#include "cli/wall_time.h"

namespace weir {

namespace {

using Json = nlohmann::ordered_json;

// Between two reports, s: a log file of an hour's run keeps readable, a program gets a pulse.
constexpr double line_interval = 10;
constexpr double json_interval = 1;

double fraction_of(const Progress& progress) {
  return progress.duration > 0 ? std::clamp(progress.time / progress.duration, 0.0, 1.0) : 1.0;
}

std::string facts(const Progress& progress) {
  std::string text = fmt::format("{:3.0f} %  {:.3f} of {:.3f} s  step {}", std::floor(100 * fraction_of(progress)),
                                 progress.time, progress.duration, progress.step);
  if (progress.frames > 0) text += fmt::format("  picture {} of {}", progress.frame, progress.frames);
  if (progress.time > 0) text += fmt::format("  {} left", wall_time_text(progress.wall_time_left));
  return text;
}

void print_progress_json(const Json& json) {
  fmt::print(stderr, "{}\n", json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

ProgressReport::ProgressReport(ProgressStyle style) : style_(style) {
  if (style_ == ProgressStyle::automatic) style_ = stderr_is_terminal() ? ProgressStyle::bar : ProgressStyle::lines;
}

void ProgressReport::show(const Progress& progress) {
  if (style_ == ProgressStyle::none) return;
  if (style_ == ProgressStyle::bar) return show_bar(progress);
  const bool last = progress.time >= progress.duration;
  if (since_start_.seconds() < next_ && !last) return;
  next_ = since_start_.seconds() + (style_ == ProgressStyle::json ? json_interval : line_interval);
  if (style_ == ProgressStyle::lines) {
    weir::say(facts(progress));
  } else {
    print_progress_json({{"event", "progress"},
                         {"time_s", progress.time},
                         {"duration_s", progress.duration},
                         {"step", progress.step},
                         {"pictures", progress.frame},
                         {"of_pictures", progress.frames},
                         {"wall_time_left_s", progress.wall_time_left}});
  }
}

void ProgressReport::show_bar(const Progress& progress) {
  const std::string text = facts(progress);
  const int width = terminal_width() - 1;  // the last column would wrap
  const int room = width - static_cast<int>(text.size()) - 4;
  std::string line;
  if (room >= 10) {
    const int length = std::min(room, 40);
    const int full = static_cast<int>(length * fraction_of(progress));
    line = fmt::format("[{}{}]  {}", std::string(full, '#'), std::string(length - full, '-'), text);
  } else {
    line = text.substr(0, static_cast<std::size_t>(std::max(width, 0)));
  }
  fmt::print(stderr, "\r{}\x1b[K", line);
  std::fflush(stderr);
  bar_shown_ = true;
}

void ProgressReport::clear_bar() {
  if (bar_shown_) fmt::print(stderr, "\r\x1b[K");
  bar_shown_ = false;
}

void ProgressReport::say(const std::string& text) {
  clear_bar();
  if (style_ == ProgressStyle::json) {
    print_progress_json({{"event", "message"}, {"text", text}});
  } else {
    weir::say(text);
  }
}

void ProgressReport::end(const RunResult& result) {
  clear_bar();
  if (style_ == ProgressStyle::json) {
    print_progress_json({{"event", "end"},
                         {"exit", static_cast<int>(result.exit)},
                         {"text", result.message},
                         {"folder", result.folder.string()}});
  } else if (result.exit == ExitCode::done) {
    weir::say(result.message);
  } else {
    say_error(result.message);
  }
}

}  // namespace weir
