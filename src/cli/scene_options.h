// The options that every command with a scene takes.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "scene/reader.h"

namespace weir {

// `--set KEY=VALUE`, any number of times; values are kept as written.
CLI::Option* add_set(CLI::App& command, std::vector<std::string>& values);
CLI::Option* add_threads(CLI::App& command, int& threads);
CLI::Option* add_gl_device(CLI::App& command, std::string& device);

std::vector<Override> overrides(const std::vector<std::string>& values);  // throws UsageError

}  // namespace weir
