#include "render/renderer.h"

#include <cstdlib>
#include <stdexcept>

#include "core/error.h"
#include "core/module.h"

namespace weir {

namespace {

// A module that cannot be loaded, for lack of a system library, is a DeviceError.
template <class Function>
Function* render_function(const char* symbol) {
  try {
    return module_function<Function>("weir_render", symbol);
  } catch (const std::runtime_error& error) {
    throw DeviceError(std::string("no usable OpenGL: ") + error.what());
  }
}

}  // namespace

DeviceChoice device_choice(const std::string& requested) {
  if (!requested.empty()) return {.device = requested};
  // Read at start-up, before any other thread exists.
  if (const char* from_environment = std::getenv("WEIR_GL_DEVICE"))  // NOLINT(concurrency-mt-unsafe)
    if (*from_environment != '\0') return {.device = from_environment};
  return {};
}

std::unique_ptr<Renderer> make_renderer(const Scene& scene, const StaticScene& static_scene, const DeviceChoice& choice,
                                        int threads) {
  using Make = Renderer*(const Scene&, const StaticScene&, const DeviceChoice&, int);
  return std::unique_ptr<Renderer>(render_function<Make>("weir_make_renderer")(scene, static_scene, choice, threads));
}

void draw_on_calling_thread() {
  setenv("LP_NUM_THREADS", "0", 0);  // NOLINT(concurrency-mt-unsafe)
}

std::vector<DeviceTrial> list_devices() {
  std::vector<DeviceTrial> devices;
  try {
    render_function<void(std::vector<DeviceTrial>&)>("weir_list_devices")(devices);
  } catch (const DeviceError& error) {
    devices.push_back({"module weir_render", false, error.what()});
  }
  return devices;
}

}  // namespace weir
