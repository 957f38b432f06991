#include "render/egl_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "core/error.h"
#include "render/device_trials.h"

namespace weir {

struct EglContext::Candidate {
  std::string name;
  EGLenum platform;
  void* native;   // the EGLDeviceEXT; EGL_DEFAULT_DISPLAY for the surfaceless platform
  bool software;  // Mesa's software device
};

namespace {

bool has_extension(const char* list, const std::string& name) {
  if (list == nullptr) return false;
  const std::string spaced = fmt::format(" {} ", list);
  return spaced.find(fmt::format(" {} ", name)) != std::string::npos;
}

// Restores the current context at the end of its scope: trying devices must not replace the context of a renderer.
class CurrentContextKeeper {
 public:
  CurrentContextKeeper() : display_(eglGetCurrentDisplay()), context_(eglGetCurrentContext()) {}
  ~CurrentContextKeeper() {
    if (display_ != EGL_NO_DISPLAY) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_);
  }
  CurrentContextKeeper(const CurrentContextKeeper&) = delete;
  CurrentContextKeeper& operator=(const CurrentContextKeeper&) = delete;

 private:
  EGLDisplay display_;
  EGLContext context_;
};

bool libraries_are_there(std::vector<DeviceTrial>& trials) {
  std::string problem;
  if (!library_is_there({"libEGL.so.1"}, problem)) {
    trials.push_back({"EGL", false, problem + ": install libegl1"});
    return false;
  }
  // libepoxy takes the oldest OpenGL functions from one of these and aborts the process if both are missing.
  if (!library_is_there({"libOpenGL.so.0", "libGL.so.1"}, problem)) {
    trials.push_back({"OpenGL", false, problem + ": install libopengl0"});
    return false;
  }
  return true;
}

std::optional<std::size_t> device_number(const std::string& text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

std::vector<EglContext::Candidate> EglContext::candidates(std::vector<DeviceTrial>& trials) {
  std::vector<Candidate> all;
  if (!libraries_are_there(trials)) return all;
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (client == nullptr) {
    trials.push_back({"EGL", false,
                      fmt::format("eglQueryString(EGL_EXTENSIONS) failed with {}: the EGL library is older than 1.5",
                                  egl_error_name(eglGetError()))});
    return all;
  }
  std::vector<Candidate> software;
  if (has_extension(client, "EGL_EXT_device_enumeration") || has_extension(client, "EGL_EXT_device_base")) {
    EGLint count = 0;
    std::array<EGLDeviceEXT, 32> devices{};
    if (!eglQueryDevicesEXT(devices.size(), devices.data(), &count)) {
      trials.push_back({"EGL devices", false, egl_failure("eglQueryDevicesEXT", eglGetError())});
      count = 0;
    } else if (count == 0) {
      trials.push_back({"EGL devices", false, "eglQueryDevicesEXT found none: no EGL driver; install libegl-mesa0"});
    }
    for (int k = 0; k < count; ++k) {
      const char* extensions = eglQueryDeviceStringEXT(devices[k], EGL_EXTENSIONS);
      if (has_extension(extensions, "EGL_MESA_device_software")) {
        software.push_back({"software device", EGL_PLATFORM_DEVICE_EXT, devices[k], true});
        continue;
      }
      const char* file = has_extension(extensions, "EGL_EXT_device_drm")
                             ? eglQueryDeviceStringEXT(devices[k], EGL_DRM_DEVICE_FILE_EXT)
                             : nullptr;
      all.push_back({file != nullptr ? fmt::format("device {}", file) : fmt::format("device {}", k),
                     EGL_PLATFORM_DEVICE_EXT, devices[k], false});
    }
  } else {
    trials.push_back(
        {"EGL devices", false,
         "the EGL library cannot list devices (EGL_EXT_device_enumeration), as without any driver; Mesa's is "
         "libegl-mesa0"});
  }
  if (has_extension(client, "EGL_MESA_platform_surfaceless"))
    all.push_back({"Mesa without surface", EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, false});
  all.insert(all.end(), software.begin(), software.end());
  return all;
}

std::unique_ptr<EglContext> EglContext::try_candidate(const Candidate& candidate, DeviceTrial& trial) {
  trial = {candidate.name, false, ""};
  const auto refuse = [&](const char* call) {
    trial.detail = egl_failure(call, eglGetError());
    return nullptr;
  };
  EGLDisplay display = eglGetPlatformDisplayEXT(candidate.platform, candidate.native, nullptr);
  if (display == EGL_NO_DISPLAY) return refuse("eglGetPlatformDisplayEXT");
  // Displays are never terminated: a device has one display per process, and eglTerminate would invalidate it for every
  // renderer.
  EGLint major = 0;
  EGLint minor = 0;
  if (!eglInitialize(display, &major, &minor)) return refuse("eglInitialize");
  if (!eglBindAPI(EGL_OPENGL_API)) return refuse("eglBindAPI");
  const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
  if (!has_extension(extensions, "EGL_KHR_surfaceless_context")) {
    trial.detail = "the driver cannot draw without a surface (EGL_KHR_surfaceless_context)";
    return nullptr;
  }

  EGLConfig config = EGL_NO_CONFIG_KHR;
  if (!has_extension(extensions, "EGL_KHR_no_config_context")) {
    const std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE,
                                          0,  // no window, pixmap or pbuffer is needed: rendering is to framebuffers
                                          EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,  // desktop OpenGL, not ES
                                          EGL_NONE};
    EGLint found = 0;
    if (!eglChooseConfig(display, wanted.data(), &config, 1, &found)) return refuse("eglChooseConfig");
    if (found == 0) {
      trial.detail = "eglChooseConfig found no configuration for desktop OpenGL: the driver has OpenGL ES only";
      return nullptr;
    }
  }
  const std::array<EGLint, 7> attributes = {
      EGL_CONTEXT_MAJOR_VERSION,
      4,  // 4.5: direct state access
      EGL_CONTEXT_MINOR_VERSION,
      5,
      EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,  // Mesa gives versions above 3.1 in core only
      EGL_NONE};
  EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
  if (context == EGL_NO_CONTEXT) return refuse("eglCreateContext");
  std::unique_ptr<EglContext> opened(new EglContext(display, context));
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return refuse("eglMakeCurrent");

  const auto text = [](GLenum name) {
    const GLubyte* bytes = glGetString(name);
    return std::string(bytes != nullptr ? reinterpret_cast<const char*>(bytes) : "");
  };
  opened->gl_renderer_ = text(GL_RENDERER);
  trial.detail = fmt::format("{}, OpenGL {}", opened->gl_renderer_, text(GL_VERSION));
  if (epoxy_gl_version() < 45) {
    trial.detail += ": 4.5 is needed";
    return nullptr;
  }
  if (candidate.software && opened->gl_renderer_.find("llvmpipe") == std::string::npos) {
    trial.detail += ": not Mesa's llvmpipe; is GALLIUM_DRIVER or MESA_LOADER_DRIVER_OVERRIDE set?";
    return nullptr;
  }
  trial.usable = true;
  return opened;
}

std::unique_ptr<EglContext> EglContext::open(const DeviceChoice& choice) {
  std::vector<DeviceTrial> trials;
  const std::vector<Candidate> all = candidates(trials);
  const std::optional<std::size_t> number = device_number(choice.device);
  if (!number && choice.device != "auto" && choice.device != "software")
    throw UsageError(
        fmt::format("no device \"{}\": say auto, software, or a number that `weir info` lists", choice.device));
  if (number && *number >= all.size()) {
    for (const Candidate& candidate : all) trials.push_back({candidate.name, false, "not tried"});
    throw DeviceError(no_device_text(choice.device, trials));
  }
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (number ? k != *number : choice.device == "software" && !all[k].software) continue;
    trials.emplace_back();
    if (auto opened = try_candidate(all[k], trials.back())) return opened;
  }
  throw DeviceError(no_device_text(choice.device, trials));
}

std::vector<DeviceTrial> EglContext::try_all() {
  std::vector<DeviceTrial> general;
  const std::vector<Candidate> all = candidates(general);
  std::vector<DeviceTrial> trials;
  if (!all.empty()) {
    const CurrentContextKeeper keeper;
    for (const Candidate& candidate : all) {
      trials.emplace_back();
      try_candidate(candidate, trials.back());
    }
  }
  // After the devices, so that a device's index in the list is its number.
  trials.insert(trials.end(), general.begin(), general.end());
  return trials;
}

void EglContext::make_current() const {
  if (eglGetCurrentContext() == context_) return;
  if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
    throw DeviceError(egl_failure("eglMakeCurrent", eglGetError()));
}

bool EglContext::is_processor() const {
  return std::ranges::any_of(std::array{"llvmpipe", "softpipe", "SwiftShader"},
                             [&](const char* name) { return gl_renderer_.find(name) != std::string::npos; });
}

EglContext::~EglContext() {
  if (eglGetCurrentContext() == context_) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display_, context_);
}

}  // namespace weir
