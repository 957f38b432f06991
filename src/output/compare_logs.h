// How far two log.csv are apart.
#pragma once

#include <string_view>

#include "output/compare.h"

namespace weir {

ComparisonItem compare_logs(std::string_view a, std::string_view b);

}  // namespace weir
