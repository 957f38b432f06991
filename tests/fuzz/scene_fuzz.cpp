// Any bytes as a scene: read them; judge, write and read again what was right.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>

#include "core/error.h"
#include "scene/advice.h"
#include "scene/check.h"
#include "scene/reader.h"

namespace {

std::optional<weir::Scene> read(const std::string& text) {
  try {
    return weir::read_scene_text(text, "s.yaml");
  } catch (const weir::SceneError&) {  // the answer to most bytes
    return std::nullopt;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::optional<weir::Scene> scene = read(std::string(reinterpret_cast<const char*>(data), size));
  if (!scene) return 0;
  weir::estimate(*scene);
  weir::advice(*scene);
  const std::string written = weir::write_scene(*scene);
  const std::optional<weir::Scene> again = read(written);
  if (!again || weir::write_scene(*again) != written) std::abort();
  return 0;
}
