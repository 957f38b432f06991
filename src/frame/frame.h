// What simulation and pictures share: the particles at one instant, and what does not move.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace weir {

// The fluid at exactly index / fps seconds of run time, in the solver's order, in which neighbours stand near each other.
struct Frame {
  std::int64_t index = 0;
  double time = 0;                   // run time, s
  double simulated_time = 0;         // s; stands still while paused, starts again on reset
  double dt = 0;                     // length of the step that led here, s; 0 before the first
  double cfl = 0;                    // dt v_max / h [Hinsch24 6.6.2]
  bool cfl_met = true;               // cfl <= the scene's factor lambda
  std::vector<glm::vec4> particles;  // x, y, z in m (z = 0 in 2D); w = the quantity that the scene colours by, its unit
};

// Walls, and the sizes that a picture needs; the same for all frames of a run.
struct StaticScene {
  std::vector<glm::vec3> walls;   // m
  double particle_spacing = 0;    // dx, m
  double max_speed_estimate = 0;  // m/s, of the whole run, from the scene alone: what `range: auto` for speed means
};

}  // namespace weir
