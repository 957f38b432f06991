// Shaders, part of the module itself.
#pragma once

#include <string_view>

namespace weir::assets {

std::string_view gather_vert();
std::string_view gather_frag();

}  // namespace weir::assets
