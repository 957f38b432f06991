// Which sides of a tank lie across an axis, and which are open.
#pragma once

#include <algorithm>
#include <array>

#include "scene/scene.h"

namespace weir {

// At the low and the high end of the axis.
inline std::array<Side, 2> tank_sides(int axis, int dimension) {
  if (axis == 0) return {Side::left, Side::right};
  if (axis == dimension - 1) return {Side::bottom, Side::top};
  return {Side::front, Side::back};
}

inline bool is_open(const Tank& tank, Side side) {
  return std::find(tank.open.begin(), tank.open.end(), side) != tank.open.end();
}

}  // namespace weir
