// weir: from a YAML scene to a movie of a fluid, without a screen.
#include <exception>
#include <new>

#include "cli/commands.h"
#include "cli/terminal.h"

namespace weir {

namespace {

ExitCode perform(const Action& action) {
  try {
    return action();
  } catch (const SceneError& error) {
    say_mistakes(error.what());
    return ExitCode::usage;
  } catch (const UsageError& error) {
    say_error(error.what());
    return ExitCode::usage;
  } catch (const SimulationError& error) {
    say_error(error.what());
    return ExitCode::diverged;
  } catch (const DeviceError& error) {
    say_error(error.what());
    return ExitCode::no_device;
  } catch (const OutputError& error) {
    say_error(error.what());
    return ExitCode::output;
  } catch (const std::bad_alloc&) {
    say_error("out of memory: a coarser particles.spacing needs less");
    return ExitCode::internal;
  } catch (const std::exception& error) {
    say_error(error.what());
    return ExitCode::internal;
  }
}

ExitCode main_program(int argc, char** argv) {
  CLI::App program(
      "weir turns a YAML scene into a movie of a fluid (smoothed particle hydrodynamics), without a screen.", "weir");
  program.set_version_flag("--version", "weir " WEIR_VERSION);
  program.require_subcommand(1);
  program.footer(
      "First steps:\n"
      "  weir check scenes/dam_break.yaml     what is in it, and how long it will take\n"
      "  weir run scenes/dam_break.yaml       the movie: out/dam_break/dam_break.mp4\n"
      "  weir COMMAND --help                  the options of a command\n"
      "Exit: 0 done, 1 internal failure (compare: different), 2 usage or wrong scene, 3 diverged,\n"
      "      4 no OpenGL, 5 output failed, 6 stopped");
  Action action;
  add_run(program, action);
  add_check(program, action);
  add_batch(program, action);
  add_compare(program, action);
  add_report(program, action);
  add_info(program, action);
  add_schema(program, action);
  add_unbuilt(program, action);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    program.exit(asked);
    return ExitCode::done;
  } catch (const CLI::RequiredError& error) {
    const bool unknown = program.get_subcommands().empty() && argc > 1;
    say_error(unknown ? std::string("no such command: ") + argv[1] : error.what());
    say("weir --help, or weir COMMAND --help, shows what there is");
    return ExitCode::usage;
  } catch (const CLI::ParseError& error) {
    say_error(error.what());
    say("weir --help, or weir COMMAND --help, shows what there is");
    return ExitCode::usage;
  } catch (const UsageError& error) {
    say_error(error.what());
    return ExitCode::usage;
  }
  return perform(action);
}

}  // namespace

}  // namespace weir

int main(int argc, char** argv) {
  try {
    return static_cast<int>(weir::main_program(argc, argv));
  } catch (const std::exception& error) {
    weir::say_error(error.what());
    return static_cast<int>(weir::ExitCode::internal);
  }
}
