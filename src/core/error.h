// Errors, one type per exit code of the program. Messages start lower case and name the object, its value and a remedy.
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

// One mistake in a scene. `where` is "file:line:column", or the command-line option that set the value.
struct SceneMistake {
  std::string where;
  std::string message;
};

// All mistakes of a scene at once, in the order in which they stand in the file.
struct SceneError : std::runtime_error {
  explicit SceneError(std::vector<SceneMistake> mistakes);
  std::vector<SceneMistake> mistakes;
};

// The simulation diverged. The message names step, time, particle, the limit that was exceeded and a remedy.
struct SimulationError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// No usable OpenGL; the message has a line for every display and device tried.
struct DeviceError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A file could not be written, or no encoder was found.
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace weir
