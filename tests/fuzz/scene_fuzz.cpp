// Any bytes as a scene: read them, and write and read again what was right.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/error.h"
#include "scene/reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const std::string written = weir::write_scene(weir::read_scene_text(text, "s.yaml"));
    if (weir::write_scene(weir::read_scene_text(written, "s.yaml")) != written) std::abort();
  } catch (const weir::SceneError&) {  // the answer to most bytes
  }
  return 0;
}
