// Fluid at rest.
//
// [Landau87] L. D. Landau, E. M. Lifshitz, Fluid Mechanics, 2nd ed., Pergamon, 1987, sec. 3.
#pragma once

namespace weir {

// The weight of what lies above, Pa; depth in m, of fluid at its rest density. [Landau87, column]
inline double hydrostatic_pressure(double rest_density, double g, double depth) { return rest_density * g * depth; }

// How high above its bottom, m, that which lies at `depth` of a column of `height` (m, both as at rest density) comes to
// stand when the column is compressed by its own weight: the integral of d depth / (1 + g depth / c^2) from there to the
// bottom, for a linear equation of state. As its power series, for g height / c^2 up to some 0.1. [Landau87, settled]
inline double settled_height(double height, double depth, double g_per_c_squared) {
  double sum = 0;
  double top = depth;
  double bottom = height;
  for (int n = 1; n <= 8; ++n) {
    sum += (bottom - top) / n;
    top *= -g_per_c_squared * depth;
    bottom *= -g_per_c_squared * height;
  }
  return sum;
}

}  // namespace weir
