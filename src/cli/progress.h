// How far a run is: a bar for people, lines for log files, JSON for programs.
#pragma once

#include <string>

#include "core/stopwatch.h"
#include "run/run.h"

namespace weir {

enum class ProgressStyle { automatic, bar, lines, json, none };

class ProgressReport {
 public:
  // automatic: a bar on a terminal, else lines.
  explicit ProgressReport(ProgressStyle style);

  void show(const Progress& progress);
  // A message for the user, among the progress.
  void say(const std::string& text);
  void end(const RunResult& result);

 private:
  void show_bar(const Progress& progress);
  void clear_bar();

  ProgressStyle style_;
  Stopwatch since_start_;
  double next_ = 0;  // s since the start
  bool bar_shown_ = false;
};

}  // namespace weir
