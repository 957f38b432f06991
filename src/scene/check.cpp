#include "scene/check.h"

namespace weir {

std::vector<Violation> check(const Scene& scene) {
  return check(scene, [](const std::string&) { return false; });
}

std::vector<Violation> check(const Scene&, const Unread&) { return {}; }

}  // namespace weir
