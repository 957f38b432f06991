// One run from its first step to its manifest.
#pragma once

#include <exception>
#include <memory>
#include <string>

#include "core/stopwatch.h"
#include "output/sink.h"
#include "run/observer.h"
#include "run/outcome.h"
#include "run/run.h"
#include "run/run_context.h"
#include "run/run_folder.h"
#include "sph/simulation.h"

namespace weir {

class Session {
 public:
  Session(const Scene& scene, const RunOptions& options, RunFolder& folder, std::string scene_text,
          Provenance provenance);

  // Takes device, folder and encoder. Leaves no file behind when one of them fails. Throws.
  void open();
  // Steps to the end of the scene. Never throws: errors are in the result.
  RunResult play();

 private:
  void step_ahead();
  void open_files();
  void step_through();
  void report_progress();
  std::string reason_to_stop() const;
  std::string what_was_written() const;
  std::int64_t pictures() const;
  void write_closing_manifest() const;

  const Scene& scene_;
  const RunOptions& options_;
  RunFolder& folder_;
  std::string scene_text_;
  Provenance provenance_;
  Stopwatch since_start_;
  double setup_seconds_ = 0;
  double next_progress_ = 0;  // s since the start
  std::unique_ptr<Simulation> simulation_;
  RunContext context_;
  Observers observers_;
  std::exception_ptr failed_ahead_;  // by a step ahead of the files
  Outcome outcome_;
};

}  // namespace weir
