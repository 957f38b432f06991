// A scene becomes its run folder: steps, pictures, movie, log and manifest, side by side on their own threads.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/error.h"
#include "render/renderer.h"
#include "scene/scene.h"
#include "simd/instruction_set.h"

namespace weir {

struct Progress {
  double time = 0;      // run time, s
  double duration = 0;  // s
  std::int64_t step = 0;
  std::int64_t frame = 0;
  std::int64_t frames = 0;
  double wall_time_left = 0;  // s, estimate
};

struct RunOptions {
  std::filesystem::path folder;                   // empty: out/<scene name>
  int threads = 0;                                // as for thread_count()
  std::optional<InstructionSet> instruction_set;  // none: default_instruction_set()
  bool trace = false;                             // write where the time went
  bool force = false;                             // overwrite another run
  bool checked = false;                           // the scene comes from read_scene(), which has checked it
  double max_wall_time = 0;                       // s; 0: none
  DeviceChoice device;
  std::function<void(const Progress&)> progress;    // about ten times a second, on the solver's thread
  std::function<void(const std::string&)> message;  // one line for the user
  const std::atomic<bool>* stop = nullptr;          // set by a signal: finish the step, close everything
};

struct RunResult {
  ExitCode exit = ExitCode::done;
  std::string message;  // the error, or the files written
  std::filesystem::path folder;
  bool was_there = false;  // the folder already held the identical finished run
};

// Throws SceneError, UsageError (folder holds a different run), DeviceError and OutputError before anything is written;
// later errors are in the result, with movie, log and manifest closed and readable.
RunResult run(const Scene& scene, const RunOptions& options);

}  // namespace weir
