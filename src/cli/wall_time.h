// Durations as people write them.
#pragma once

#include <string>

namespace weir {

// Seconds of "90", "90s", "15m", "1.5h". Throws UsageError.
double parse_wall_time(const std::string& text);

// "0.042 s", "12 s", "3 min 05 s", "2 h 10 min".
std::string wall_time_text(double seconds);

}  // namespace weir
