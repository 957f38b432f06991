// log.csv as an output of a run.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "run/outputs.h"

namespace weir {

std::vector<std::filesystem::path> log_files(const Scene& scene);
std::vector<std::filesystem::path> log_left_in(const std::filesystem::path& folder, const Scene& scene);
std::unique_ptr<Observer> observe_log(const RunContext& run);

inline constexpr OutputKind log_output{&log_files, &log_left_in, &observe_log};

}  // namespace weir
