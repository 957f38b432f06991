// What can go wrong, one type per exit code of the program. Texts start lower case, name the thing, its value and the
// way out.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace weir {

// The exit codes of the program; scripts rely on them.
enum class ExitCode { done = 0, internal = 1, usage = 2, diverged = 3, no_device = 4, output = 5, stopped = 6 };

// A wrong command line or an unusable combination of options.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// One mistake in a scene. `where` is "file:line:column", or the option that brought the value in.
struct SceneMistake {
  std::string where;
  std::string message;
};

// All mistakes of a scene at once, in the order in which they stand in the file.
struct SceneError : std::runtime_error {
  explicit SceneError(std::vector<SceneMistake> mistakes);
  std::vector<SceneMistake> mistakes;
};

// The state left the range in which the method means anything. The text says which step, time and particle, which
// limit was passed and what to try.
struct SimulationError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// No usable OpenGL; the text has a line for every display and device tried.
struct DeviceError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A file could not be written, or no encoder was found.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace weir
