// Which instructions the solver was built for: the same state hash may be expected within one set only.
#pragma once

#include <string_view>

namespace weir {

std::string_view instruction_set();

}  // namespace weir
