// Which walls a picture in 3D leaves out, so that one sees into what they hold.
#pragma once

#include "core/types.h"
#include "scene/scene.h"

namespace weir {

// Whether a wall's particle stands between the eye and what a container of the scene holds: it belongs to sides that all
// turn their outside to the eye. Floors seen from above, far sides and obstacles do not.
bool hides_inside(const Scene& scene, const Vec3& particle, const Vec3& eye);

}  // namespace weir
