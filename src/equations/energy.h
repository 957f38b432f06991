// Energies of one particle, for the log. [Landau and Lifshitz, Mechanics, sec. 4-6]
#pragma once

#include "core/types.h"

namespace weir {

// J (per metre of depth in 2D). [mechanics, kinetic energy]
template <int Dim>
double kinetic_energy(double m, const Vec<Dim, double>& v) {
  return 0.5 * m * dot(v, v);
}

// J, zero at the origin. [mechanics, potential energy]
template <int Dim>
double potential_energy(double m, const Vec<Dim, double>& g, const Vec<Dim, double>& x) {
  return -m * dot(g, x);
}

}  // namespace weir
