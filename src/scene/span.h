// Bounding boxes of walls and of a scene.
#pragma once

#include "scene/scene.h"

namespace weir {

Bounds wall_span(const WallShape& shape, int dimension);  // without layers
Bounds scene_span(const Scene& scene);  // fluid volumes and walls without layers; empty_bounds where there is neither

}  // namespace weir
