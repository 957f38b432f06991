#include "core/embed.h"
#include "font/font.h"

WEIR_EMBED(font_dejavu_sans_bold, WEIR_FONT_FILE)

namespace weir {

std::string_view font_dejavu_sans_bold() { return embedded_font_dejavu_sans_bold(); }

}  // namespace weir
