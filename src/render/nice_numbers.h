// Round numbers for ranges and scale bars, and units for short numbers.
#pragma once

#include <string>

namespace weir {

// The smallest of 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten that is not below `value`; 1 for 0.
double round_up_nicely(double value);

// The largest of 1, 2, 5 times a power of ten that is not above `value` (> 0).
double round_down_125(double value);

// A length in the unit that gives the shortest text: "5 cm", "2 mm", "10 m".
std::string length_text(double metres);

// A multiple of a unit in which numbers up to `largest` are short: with {1e-3, "kPa"}, values times 1e-3 are in kPa.
struct DisplayUnit {
  double factor = 1;
  std::string name;
};
DisplayUnit display_unit(const std::string& si_unit, double largest);

}  // namespace weir
