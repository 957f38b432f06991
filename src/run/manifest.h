// manifest.json: what a run was, how it ended and what it cost.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/error.h"
#include "sph/simulation.h"

namespace weir {

struct WallTimes {  // s; stages run side by side, so they may add up to more than the total
  double total = 0;
  double setup = 0;
  double neighbours = 0;
  double solve = 0;
  double render = 0;
  double encode = 0;
  double write = 0;
};

struct Manifest {
  std::string version;
  std::string scene;  // its name
  std::string scene_sha256;
  std::string state_hash;
  int dimension = 0;
  std::int64_t fluid_particles = 0;
  std::int64_t wall_particles = 0;
  std::int64_t steps = 0;
  double time = 0;            // run time, s
  double simulated_time = 0;  // s
  std::int64_t frames = 0;    // drawn
  int threads = 0;
  WallTimes wall_time;
  std::string gl_renderer;  // empty: nothing was drawn
  std::string encoder;      // empty: no movie
  std::string movie;        // file name; empty: none
  double max_density_error = 0;
  std::string instruction_set;
  ExitCode exit = ExitCode::done;
  std::string message;  // how it ended, in words
};

std::string to_json(const Manifest& manifest);

// What is needed to know a run again; none if there is no manifest, or one that cannot be read.
struct PastRun {
  std::string version;
  std::string scene_sha256;
  std::string movie;
  int exit = 0;
  std::int64_t steps = 0;
  double wall_time = 0;  // s
};
std::optional<PastRun> read_past_run(const std::filesystem::path& manifest_file);

}  // namespace weir
