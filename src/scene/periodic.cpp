// Periodic axes and their period.
#include <algorithm>

#include "scene/scene.h"
#include "scene/span.h"

namespace weir {

bool is_periodic(const Scene& scene, int axis) {
  return std::find(scene.periodic.begin(), scene.periodic.end(), static_cast<Axis>(axis)) != scene.periodic.end();
}

Bounds periodic_extent(const Scene& scene) { return scene.domain ? *scene.domain : scene_span(scene); }

}  // namespace weir
