#include "report/scenes.h"

#include <string>

#include "scene/reader.h"

#define WEIR_EMBED(symbol, file)                             \
  asm(".pushsection .rodata\n"                               \
      ".hidden " #symbol "\n.hidden " #symbol                \
      "_end\n"                                               \
      ".globl " #symbol "\n.globl " #symbol "_end\n" #symbol \
      ":\n"                                                  \
      ".incbin \"" file "\"\n" #symbol                       \
      "_end:\n"                                              \
      ".popsection\n")

WEIR_EMBED(weir_scene_dam_break, WEIR_SCENES "/dam_break.yaml");
WEIR_EMBED(weir_scene_tower, WEIR_SCENES "/tower.yaml");

extern "C" {
extern const char weir_scene_dam_break[] __attribute__((visibility("hidden")));
extern const char weir_scene_dam_break_end[] __attribute__((visibility("hidden")));
extern const char weir_scene_tower[] __attribute__((visibility("hidden")));
extern const char weir_scene_tower_end[] __attribute__((visibility("hidden")));
}

namespace weir {

Scene shipped_dam_break() {
  return read_scene_text(std::string(weir_scene_dam_break, weir_scene_dam_break_end), "dam_break.yaml");
}

Scene shipped_tower() { return read_scene_text(std::string(weir_scene_tower, weir_scene_tower_end), "tower.yaml"); }

}  // namespace weir
