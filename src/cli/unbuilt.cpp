#include "cli/commands.h"

namespace weir {

namespace {

[[noreturn]] void refuse(const std::string& name) { throw UsageError(name + " is not built yet"); }

}  // namespace

void add_unbuilt_flag(CLI::App& command, const std::string& name) {
  command.add_flag_callback(name, [name] { refuse(name); })->group("")->trigger_on_parse();
}

void add_unbuilt(CLI::App& program, Action& action) {
  for (const std::string name : {"sweep", "render"}) {
    CLI::App* command = program.add_subcommand(name)->group("")->allow_extras();
    command->callback([&action, name] { action = [name]() -> ExitCode { refuse("weir " + name); }; });
  }
}

}  // namespace weir
