// Shaders, embedded in the module.
#pragma once

#include <string_view>

namespace weir::assets {

std::string_view compose_vert();
std::string_view compose_frag();

}  // namespace weir::assets
