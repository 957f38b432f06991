#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace weir {

// How many particles a length is sampled by: rounded, at least one.
inline std::int64_t cells(double length, double dx) { return std::max<std::int64_t>(1, std::llround(length / dx)); }

}  // namespace weir
