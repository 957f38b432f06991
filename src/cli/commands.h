// The commands of the program, one file each. Data goes to standard output, everything said to the user to standard
// error.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

#include "core/error.h"

namespace weir {

// The action that the parsed command line asks for. Errors are thrown; main() turns them into text and exit code.
using Action = std::function<ExitCode()>;

// Each adds its command to the program; `action` is set once the command has been parsed.
void add_run(CLI::App& program, Action& action);
void add_check(CLI::App& program, Action& action);
void add_batch(CLI::App& program, Action& action);
void add_compare(CLI::App& program, Action& action);
void add_report(CLI::App& program, Action& action);
void add_info(CLI::App& program, Action& action);
void add_schema(CLI::App& program, Action& action);
// Reserved options, refused by name until they are built.
void add_unbuilt(CLI::App& program, Action& action);

// A flag that is refused by name; not shown in the help.
void add_unbuilt_flag(CLI::App& command, const std::string& name);

}  // namespace weir
