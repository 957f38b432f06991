// manifest.json: scene, machine, end and cost of a run.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/error.h"

namespace weir {

struct Manifest {
  struct Particles {
    std::int64_t fluid = 0;
    std::int64_t wall = 0;
    bool operator==(const Particles&) const = default;
  };
  struct WallTime {  // s; stages overlap, so that their sum may pass the total
    double total = 0;
    double setup = 0;
    double neighbours = 0;
    double solve = 0;  // neighbours included
    double render = 0;
    double encode = 0;
    double write = 0;
    bool operator==(const WallTime&) const = default;
  };

  std::string version;
  std::string scene_sha256;
  std::string state_hash;  // empty until the end
  int dimension = 2;
  Particles particles;
  std::int64_t steps = 0;
  double simulated_time_s = 0;
  std::int64_t frames = 0;
  int threads = 0;
  WallTime wall_time_s;
  double particle_steps_per_second = 0;  // fluid particles * steps / wall time of solving
  std::string gl_renderer;               // empty: nothing was drawn
  std::string encoder;                   // empty: no movie
  double max_density_error = 0;          // over all log rows
  std::string instruction_set;
  std::optional<ExitCode> exit;  // none (null in the file): running, or killed
  bool operator==(const Manifest&) const = default;
};

void write_manifest(const std::filesystem::path& file, const Manifest& manifest);  // throws OutputError
// Unknown fields are passed over, missing ones keep their defaults. Throws OutputError for any other file.
Manifest read_manifest(const std::filesystem::path& file);

}  // namespace weir
