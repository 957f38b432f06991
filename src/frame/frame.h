// Input of a renderer: the particles of one instant in a compact form, and the static scene.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "frame/snapshot.h"

namespace weir {

struct Frame : Instant {
  std::vector<glm::vec4> particles;  // x, y, z in m (z = 0 in 2D); w = the quantity that colours, in its unit
};

// Request for the snapshot that a frame coloured by a quantity is made from.
SnapshotRequest frame_request(Quantity quantity);
// From a snapshot filled by frame_request(). The frame's memory is reused.
void make_frame(const Snapshot& snapshot, Quantity quantity, Frame& frame);

// Walls, and the sizes that a picture needs; the same for all frames of a run.
struct StaticScene {
  std::vector<glm::vec3> walls;   // m
  double particle_spacing = 0;    // dx, m
  double max_speed_estimate = 0;  // m/s, of the whole run, from the scene alone: the end of an automatic range of speed
};

}  // namespace weir
