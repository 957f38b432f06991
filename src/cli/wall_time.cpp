#include "cli/wall_time.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "core/error.h"

namespace weir {

double parse_wall_time(const std::string& text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number, std::chars_format::fixed);
  const std::string unit(error == std::errc() ? rest : end, end);
  const double seconds = unit.empty() || unit == "s" ? 1 : unit == "m" ? 60 : unit == "h" ? 3600 : 0;
  // 0 for malformed numbers and units, inf and nan.
  if (error != std::errc() || !(number * seconds > 0 && number * seconds < 1e13)) {
    throw UsageError(fmt::format("--max-wall-time {}: not a positive time such as 90, 90s, 15m or 2h", text));
  }
  return number * seconds;
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
