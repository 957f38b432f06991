// How far a wall's particles lie behind its face.
#pragma once

#include "scene/scene.h"

namespace weir {

// Distance of a point in the wall's layers from the nearest point of its face, m.
double wall_depth(const WallShape& shape, int dimension, const Vec3& point);

}  // namespace weir
