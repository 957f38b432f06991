// Whether particles of volumes lie in shapes, near each other or near points. Lattices store no particles.
#pragma once

#include <vector>

#include "scene/lattice.h"

namespace weir {

// Whether any particle lies inside the shape and in none of its holes.
bool any_inside(const Lattice& lattice, const Shape& shape, const std::vector<Shape>& holes = {});

// The particles that are inside none of the shapes: how many, and the first in the order of sampling.
struct Outsiders {
  std::int64_t count = 0;
  Vec3 first{0};
};
Outsiders outside_all(const Lattice& lattice, const std::vector<Shape>& shapes);

// Whether any two particles are nearer than `distance`, m, which is less than half a spacing: then each has at most one
// node of the other's lattice to look at.
bool any_near(const Lattice& a, const Lattice& b, double distance);
// The same for particles and points; points ascend in y.
bool any_near(const Lattice& lattice, const std::vector<Vec3>& points, double distance);

}  // namespace weir
