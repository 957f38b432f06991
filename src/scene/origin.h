// Positions relative to an origin of the scene's own: far from zero (map coordinates) single precision and tile numbers
// would not suffice.
#pragma once

#include "scene/scene.h"

namespace weir {

// The lower corner of what fluid volumes, walls' shapes and the domain span. Zero where the scene lies no farther from
// zero than it is long, so that such scenes keep their bits.
Vec3 scene_origin(const Scene& scene);

// The same scene with all positions moved by -origin. Exact where coordinates are multiples of a common power of two.
Scene relative_to(const Scene& scene, const Vec3& origin);

}  // namespace weir
