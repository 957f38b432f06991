// Layers of particles along one flank of a polyline.
#pragma once

#include <vector>

#include "scene/scene.h"

namespace weir {

std::vector<Vec3> sample_polyline(const Polyline& line, double dx, int layers);

}  // namespace weir
