// The words of a device that would not do: EGL's errors by name, and what to try.
#pragma once

#include <string>
#include <vector>

#include "render/renderer.h"

namespace weir {

// "EGL_BAD_MATCH" for 0x3009; an unknown code in hexadecimal.
std::string egl_error_name(int code);

// "eglInitialize failed with EGL_NOT_INITIALIZED: <hint>".
std::string egl_failure(const std::string& call, int code);

// What DeviceError says: the request, a line for each trial, and the way out.
std::string no_device_text(const std::string& requested, const std::vector<DeviceTrial>& trials);

// Whether the loader finds any of the libraries; if not, `problem` says which were tried. libepoxy aborts the process
// over a missing library, so it may be called only after this.
bool library_is_there(const std::vector<std::string>& names, std::string& problem);

}  // namespace weir
