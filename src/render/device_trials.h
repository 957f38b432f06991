// Messages about unusable devices: names of EGL errors, and remedies.
#pragma once

#include <string>
#include <vector>

#include "render/renderer.h"

namespace weir {

// "EGL_BAD_MATCH" for 0x3009; an unknown code in hexadecimal.
std::string egl_error_name(int code);

// "eglInitialize failed with EGL_NOT_INITIALIZED: <hint>".
std::string egl_failure(const std::string& call, int code);

// Message of DeviceError: the request, a line per trial, a remedy.
std::string no_device_text(const std::string& requested, const std::vector<DeviceTrial>& trials);

// True if the loader finds any of the libraries; otherwise `problem` names the libraries tried. libepoxy aborts the
// process if a library is missing, so this must be checked before any of its functions is called.
bool library_is_there(const std::vector<std::string>& names, std::string& problem);

}  // namespace weir
