// Lengths and mass that follow from the particle spacing.
#include <algorithm>
#include <cmath>

#include "equations/density.h"
#include "equations/kernels.h"
#include "scene/scene.h"

namespace weir {

double smoothing_length(const Scene& scene) { return scene.solver.kernel.smoothing * scene.particle_spacing; }

double support_radius(const Scene& scene) { return support_per_h * smoothing_length(scene); }

double particle_mass(const Scene& scene) {
  return lattice_mass(scene.fluid.rest_density, scene.particle_spacing, scene.dimension);
}

int wall_layers(const Scene& scene, const Wall& wall) {
  if (wall.layers > 0) return wall.layers;
  // The last digits of h / dx must not add a layer.
  return std::max(1, static_cast<int>(std::ceil(support_per_h * scene.solver.kernel.smoothing - 1e-9)));
}

}  // namespace weir
