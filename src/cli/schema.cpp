#include <fmt/format.h>

#include "cli/commands.h"
#include "scene/reader.h"

namespace weir {

void add_schema(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("schema", "Print the JSON Schema (draft-07) of the scene format");
  command->callback([&action] {
    action = [] {
      fmt::print("{}", scene_schema());
      return ExitCode::done;
    };
  });
}

}  // namespace weir
