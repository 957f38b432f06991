// Round numbers for ranges and scale bars, and units that keep numbers short.
#pragma once

#include <string>

namespace weir {

// The smallest of 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten that is not below `value`; 1 for 0.
double round_up_nicely(double value);

// The largest of 1, 2, 5 times a power of ten that is not above `value` (> 0).
double round_down_125(double value);

// A length with the unit that keeps it short: "5 cm", "2 mm", "10 m".
std::string length_text(double metres);

// A multiple of a unit in which numbers up to `largest` are short: {1e-3, "kPa"} means that values are to be multiplied
// by 1e-3 and read in kPa.
struct DisplayUnit {
  double factor = 1;
  std::string name;
};
DisplayUnit display_unit(const std::string& si_unit, double largest);

}  // namespace weir
