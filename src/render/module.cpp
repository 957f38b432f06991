// Exported functions of the module, which renderer.cpp loads.
#include <vector>

#include "render/egl_context.h"
#include "render/gl_renderer.h"

extern "C" weir::Renderer* weir_make_renderer(const weir::Scene& scene, const weir::StaticScene& static_scene,
                                              const weir::DeviceChoice& choice, int threads) {
  return new weir::GlRenderer(scene, static_scene, choice, threads);
}

extern "C" void weir_list_devices(std::vector<weir::DeviceTrial>& devices) { devices = weir::EglContext::try_all(); }
