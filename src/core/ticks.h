// Positions and labels of the ticks of an axis or a colour bar.
#pragma once

#include <string>
#include <vector>

namespace weir {

struct Tick {
  double value = 0;
  std::string label;  // empty: a minor tick
};

// Multiples of 1, 2 or 5 times a power of ten inside [low, high], `most` at the most, all with the same decimals.
// Below 0.0001 and from 100 000 on, labels are powers of ten: "2·10⁻⁵".
std::vector<Tick> linear_ticks(double low, double high, int most);

// Powers of ten inside [low, high] (0 < low), labelled "10⁻³", with minor ticks at 2 .. 9 times each. When fewer than
// two powers lie inside, ticks at 1, 2 and 5 are labelled as well.
std::vector<Tick> logarithmic_ticks(double low, double high);

}  // namespace weir
