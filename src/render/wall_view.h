// Culling of wall particles in 3D, so that the inside of containers is visible.
#pragma once

#include "core/types.h"
#include "scene/scene.h"

namespace weir {

// True if a wall particle lies between the eye and the inside of a container: every side that it belongs to faces the
// eye with its outside. Floors seen from above, far sides and obstacles are kept.
bool hides_inside(const Scene& scene, const Vec3& particle, const Vec3& eye);

}  // namespace weir
