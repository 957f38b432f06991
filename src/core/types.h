// The number and vector types that everything else speaks in.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace weir {

// Per-particle quantities and pair sums. Positions are kept in double and only their differences are rounded to Real,
// so that a large domain costs no accuracy.
using Real = float;

template <int Dim, class T = Real>
using Vec = glm::vec<Dim, T, glm::defaultp>;

// A point or vector of the scene, in metres or the unit stated; z is 0 in 2D.
using Vec3 = glm::dvec3;

struct Bounds {
  Vec3 min{0};
  Vec3 max{0};
};

}  // namespace weir
