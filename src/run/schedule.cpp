#include "run/schedule.h"

#include <cmath>

namespace weir {

namespace {

// Of the interval: run time k/fps and a multiple of the interval may name the same instant and differ in the last bits.
constexpr double rounding = 1e-9;

}  // namespace

bool Schedule::due(double time) const { return time >= (static_cast<double>(multiple_) - rounding) * every_; }

void Schedule::written(double time) {
  multiple_ = static_cast<std::int64_t>(std::floor(time / every_ + rounding)) + 1;
  last_ = time;
}

}  // namespace weir
