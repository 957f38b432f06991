// Fonts and shaders, part of the module itself: found whatever the working directory and wherever weir is installed.
#pragma once

#include <string_view>

namespace weir::assets {

extern const std::string_view font;
extern const std::string_view font_bold;
extern const std::string_view disc_vert;
extern const std::string_view disc_frag;

}  // namespace weir::assets
