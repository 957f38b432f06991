// What is known of a wall's particles before any is made.
#pragma once

#include "scene/scene.h"

namespace weir {

// A box around them, not always the smallest.
Bounds wall_bounds(const Wall& wall, int dimension, double dx, int layers);

// Whether all of the volume, whose particles lie within `bounds`, is surely in front of the wall's faces, or behind them
// by no more than rounding costs: then no particle of the wall comes nearer to one of the volume than 0.49 dx, for the
// first layer lies dx/2 behind the faces.
bool surely_in_front(const Wall& wall, const Shape& volume, const Bounds& bounds, int dimension, double dx);

// Whether a place is surely farther from all particles of the wall than walls need to be to keep theirs.
bool surely_clear(const Wall& wall, const Vec3& place, int dimension, double dx);

}  // namespace weir
