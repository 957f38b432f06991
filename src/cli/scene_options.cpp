#include "cli/scene_options.h"

namespace weir {

CLI::Option* add_set(CLI::App& command, std::vector<std::string>& values) {
  return command
      .add_option("--set", values,
                  "Change the scene: a.b.c=value, value in YAML; list elements by number (walls.0.tank.open=[top])")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);  // else it would swallow the scene's name
}

CLI::Option* add_threads(CLI::App& command, int& threads) {
  return command
      .add_option("--threads", threads,
                  "Threads to solve with; default: OMP_NUM_THREADS, else the processors this process may use")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
}

CLI::Option* add_gl_device(CLI::App& command, std::string& device) {
  return command
      .add_option("--gl-device", device,
                  "OpenGL device: auto, software, or a number from `weir info`; default: WEIR_GL_DEVICE, else auto")
      ->type_name("DEVICE");
}

std::vector<Override> overrides(const std::vector<std::string>& values) {
  std::vector<Override> parsed;
  parsed.reserve(values.size());
  for (const std::string& value : values) parsed.push_back(parse_override(value));
  return parsed;
}

}  // namespace weir
