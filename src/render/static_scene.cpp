#include <utility>

#include "render/renderer.h"

namespace weir {

StaticScene make_static_scene(const Scene& scene, SetSnapshot walls) {
  return {std::move(walls.positions), scene.particle_spacing, max_speed_estimate(scene)};
}

}  // namespace weir
