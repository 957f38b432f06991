// The one grammar of numbers in scenes and options:
//   [+-] digits [. digits*] [(e|E) [+-] digits]   or   [+-] . digits [(e|E) [+-] digits]
// so `5`, `5.`, `.5` and `1e-3` are numbers; hexadecimal, octal (a leading zero), inf, nan and `1_000` are not.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace weir {

struct ParsedNumber {
  std::optional<double> value;  // finite
  std::string why;              // if there is no value: the mistake in the text
};
ParsedNumber parse_number(std::string_view text);

// Shortest text that reads back to the same number; always with a point before an exponent, as YAML 1.1 tools want.
std::string number_text(double value);

}  // namespace weir
