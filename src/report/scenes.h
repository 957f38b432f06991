// Shipped scenes, embedded in the program at build time.
#pragma once

#include "scene/scene.h"

namespace weir {

Scene shipped_dam_break();
Scene shipped_tower();

}  // namespace weir
