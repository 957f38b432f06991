#include "render/assets.h"

#include "core/embed.h"

WEIR_EMBED(disc_vert, WEIR_SHADERS "/disc.vert")
WEIR_EMBED(disc_frag, WEIR_SHADERS "/disc.frag")

namespace weir::assets {

std::string_view disc_vert() { return embedded_disc_vert(); }
std::string_view disc_frag() { return embedded_disc_frag(); }

}  // namespace weir::assets
