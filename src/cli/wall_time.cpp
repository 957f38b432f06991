#include "cli/wall_time.h"

#include <fmt/format.h>

#include <cmath>
#include <regex>

#include "core/error.h"

namespace weir {

double parse_wall_time(const std::string& text) {
  static const std::regex pattern("([0-9]{1,9}(?:\\.[0-9]{1,9})?)([smh]?)");
  std::smatch parts;
  if (!std::regex_match(text, parts, pattern) || std::stod(parts[1]) <= 0) {
    throw UsageError(fmt::format("--max-wall-time {}: not a positive time such as 90, 90s, 15m or 2h", text));
  }
  const double unit = parts[2] == "h" ? 3600 : parts[2] == "m" ? 60 : 1;
  return std::stod(parts[1]) * unit;
}

std::string wall_time_text(double seconds) {
  if (!std::isfinite(seconds)) return "unknown";
  if (seconds < 10) return fmt::format("{:.2g} s", seconds);
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace weir
