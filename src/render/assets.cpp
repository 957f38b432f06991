#include "render/assets.h"

#include "core/embed.h"

WEIR_EMBED(compose_vert, WEIR_SHADERS "/compose.vert")
WEIR_EMBED(compose_frag, WEIR_SHADERS "/compose.frag")

namespace weir::assets {

std::string_view compose_vert() { return embedded_compose_vert(); }
std::string_view compose_frag() { return embedded_compose_frag(); }

}  // namespace weir::assets
