// A scene file that runs in a blink: 100 particles fall into the corner of a tank; 6 frames.
#pragma once

#include <string>

namespace weir {

inline const std::string small_scene_text = R"(weir: 1
dimension: 2
duration: 0.1
particles: {spacing: 0.05}
fluid:
  volumes:
    - box: {min: [0, 0], max: [0.5, 0.5]}
walls:
  - tank: {min: [0, 0], max: [1, 0.8], open: [top], layers: 2}
solver: {stiffness: 20000}
render: {size: [64, 48], fps: 50}
)";

}  // namespace weir
