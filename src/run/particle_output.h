// Particle files as an output of a run.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "run/outputs.h"

namespace weir {

std::vector<std::filesystem::path> particle_files(const Scene& scene);
std::vector<std::filesystem::path> particles_left_in(const std::filesystem::path& folder, const Scene& scene);
std::unique_ptr<Observer> observe_particles(const RunContext& run);

inline constexpr OutputKind particle_output{&particle_files, &particles_left_in, &observe_particles};

}  // namespace weir
