#include "font/font.h"

#include "core/embed.h"

WEIR_EMBED(font_dejavu_sans, WEIR_FONT_FILE)

namespace weir {

std::string_view font_dejavu_sans() { return embedded_font_dejavu_sans(); }

}  // namespace weir
