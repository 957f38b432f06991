#include "report/scenes.h"

#include <string>

#include "core/embed.h"
#include "scene/reader.h"

WEIR_EMBED(dam_break, WEIR_SCENES "/dam_break.yaml")
WEIR_EMBED(tower, WEIR_SCENES "/tower.yaml")

namespace weir {

Scene shipped_dam_break() { return read_scene_text(std::string(embedded_dam_break()), "dam_break.yaml"); }

Scene shipped_tower() { return read_scene_text(std::string(embedded_tower()), "tower.yaml"); }

}  // namespace weir
