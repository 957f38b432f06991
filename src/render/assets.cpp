#include "render/assets.h"

// .incbin takes a file into the object as it is; CMake names the files and rebuilds this one when they change.
#define WEIR_INCBIN(symbol, file)                                                                                \
  asm(".pushsection .rodata\n"                                                                                   \
      ".global weir_asset_" #symbol "\n.hidden weir_asset_" #symbol "\nweir_asset_" #symbol ":\n.incbin \"" file \
      "\"\n.global weir_asset_" #symbol "_end\n.hidden weir_asset_" #symbol "_end\nweir_asset_" #symbol          \
      "_end:\n.byte 0\n.popsection\n");                                                                          \
  extern "C" const char weir_asset_##symbol[];                                                                   \
  extern "C" const char weir_asset_##symbol##_end[];

WEIR_INCBIN(font, WEIR_FONT)
WEIR_INCBIN(font_bold, WEIR_FONT_BOLD)
WEIR_INCBIN(disc_vert, WEIR_SHADERS "/disc.vert")
WEIR_INCBIN(disc_frag, WEIR_SHADERS "/disc.frag")

namespace weir::assets {

namespace {

std::string_view between(const char* begin, const char* end) { return {begin, static_cast<std::size_t>(end - begin)}; }

}  // namespace

const std::string_view font = between(weir_asset_font, weir_asset_font_end);
const std::string_view font_bold = between(weir_asset_font_bold, weir_asset_font_bold_end);
const std::string_view disc_vert = between(weir_asset_disc_vert, weir_asset_disc_vert_end);
const std::string_view disc_frag = between(weir_asset_disc_frag, weir_asset_disc_frag_end);

}  // namespace weir::assets
