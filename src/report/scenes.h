// Shipped scenes, as this program was built with them.
#pragma once

#include "scene/scene.h"

namespace weir {

Scene shipped_dam_break();
Scene shipped_tower();

}  // namespace weir
