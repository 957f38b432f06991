// Rules between fields, and the cost of a scene. Independent of YAML.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace weir {

// One broken rule. `path` is the key as in a file: "fluid.volumes.1.box".
struct Violation {
  std::string path;
  std::string message;  // follows the path: "overlaps fluid.volumes.0"
};

// Every rule that the scene breaks.
std::vector<Violation> check(const Scene& scene);

// The same for a scene of which some keys could not be read: rules that look at these are left out. `unread` says
// whether the key of that path, or one in it or around it, is such a key.
using Unread = std::function<bool(const std::string& path)>;
std::vector<Violation> check(const Scene& scene, const Unread& unread);

// Printed by `weir check` for a valid scene.
struct Estimate {
  std::int64_t fluid_particles = 0;
  std::int64_t wall_particles = 0;
  double memory = 0;  // bytes
  double dt = 0;      // s, at the estimated top speed
  std::int64_t steps = 0;
  double mass = 0;        // kg as sampled
  double mass_error = 0;  // sampled / exact - 1
};
Estimate estimate(const Scene& scene);

}  // namespace weir
