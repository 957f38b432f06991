// SHA-256 of a text: what tells one scene from another.
#pragma once

#include <string>
#include <string_view>

namespace weir {

std::string sha256(std::string_view text);  // 64 hexadecimal digits

}  // namespace weir
