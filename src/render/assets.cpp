#include "render/assets.h"

#include "core/embed.h"

WEIR_EMBED(gather_vert, WEIR_SHADERS "/gather.vert")
WEIR_EMBED(gather_frag, WEIR_SHADERS "/gather.frag")

namespace weir::assets {

std::string_view gather_vert() { return embedded_gather_vert(); }
std::string_view gather_frag() { return embedded_gather_frag(); }

}  // namespace weir::assets
