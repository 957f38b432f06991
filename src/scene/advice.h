// Advice on valid but unwise settings of a scene.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace weir {

std::vector<std::string> advice(const Scene& scene);

}  // namespace weir
