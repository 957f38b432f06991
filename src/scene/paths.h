// Names of the parts of a scene in messages: their keys in a file.
#pragma once

#include <string>

#include "scene/scene.h"

namespace weir {

std::string shape_path(const std::string& path, const Shape& shape, int dimension);
std::string volume_path(std::size_t index);                      // "fluid.volumes.0"
std::string wall_path(std::size_t index);                        // "walls.0"
std::string volume_path(const Scene& scene, std::size_t index);  // "fluid.volumes.0.box"
std::string wall_path(const Scene& scene, std::size_t index);    // "walls.0.tank"

}  // namespace weir
