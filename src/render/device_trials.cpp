#include "render/device_trials.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <utility>

namespace weir {

namespace {

// The codes of the EGL 1.5 specification, table 3.1, from EGL_SUCCESS = 0x3000 on.
constexpr std::array<const char*, 15> error_names = {
    "EGL_SUCCESS",           "EGL_NOT_INITIALIZED",   "EGL_BAD_ACCESS",          "EGL_BAD_ALLOC",   "EGL_BAD_ATTRIBUTE",
    "EGL_BAD_CONFIG",        "EGL_BAD_CONTEXT",       "EGL_BAD_CURRENT_SURFACE", "EGL_BAD_DISPLAY", "EGL_BAD_MATCH",
    "EGL_BAD_NATIVE_PIXMAP", "EGL_BAD_NATIVE_WINDOW", "EGL_BAD_PARAMETER",       "EGL_BAD_SURFACE", "EGL_CONTEXT_LOST"};

const char* hint(const std::string& call, int code) {
  if (call == "eglCreateContext") return "the driver has no OpenGL 4.5 core profile; update it, or use another device";
  if (call == "eglInitialize")
    return "the driver could not start; is it installed, and may you open /dev/dri/renderD* (group render)?";
  if (call == "eglMakeCurrent") return "the driver cannot draw without a surface (EGL_KHR_surfaceless_context)";
  if (code == 0x3003) return "out of memory";
  return "the driver does not support this platform";
}

}  // namespace

std::string egl_error_name(int code) {
  const int index = code - 0x3000;
  if (index >= 0 && index < static_cast<int>(error_names.size())) return error_names[index];
  return fmt::format("EGL error 0x{:04x}", code);
}

std::string egl_failure(const std::string& call, int code) {
  return fmt::format("{} failed with {}: {}", call, egl_error_name(code), hint(call, code));
}

std::string no_device_text(const std::string& requested, const std::vector<DeviceTrial>& trials) {
  std::string text = fmt::format("no usable OpenGL 4.5 for device \"{}\"; tried:", requested);
  for (std::size_t k = 0; k < trials.size(); ++k)
    text += fmt::format("\n  {}: {}: {}", k, trials[k].name, trials[k].usable ? "usable" : trials[k].detail);
  if (trials.empty()) text += "\n  nothing: no display or device was found";
  text +=
      "\nwithout a GPU, Mesa's software renderer draws: install libegl1 and libgl1-mesa-dri, and ask for device "
      "\"software\"";
  return text;
}

bool library_is_there(const std::vector<std::string>& names, std::string& problem) {
  problem.clear();
  for (const std::string& name : names) {
    // The handle stays open: the library is used until the process ends.
    if (dlopen(name.c_str(), RTLD_LAZY | RTLD_LOCAL) != nullptr) return true;
    problem += fmt::format("{}{}", problem.empty() ? "" : "; ", dlerror());
  }
  return false;
}

}  // namespace weir
