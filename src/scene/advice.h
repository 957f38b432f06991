// What is right but unwise in a scene, in words for its user.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace weir {

std::vector<std::string> advice(const Scene& scene);

}  // namespace weir
