#include "frame/frame.h"

#include <cstddef>

namespace weir {

SnapshotRequest frame_request(Quantity quantity) { return {.fluid = {quantity}}; }

void make_frame(const Snapshot& snapshot, Quantity quantity, Frame& frame) {
  static_cast<Instant&>(frame) = snapshot;
  frame.particles.resize(snapshot.fluid.count);
  const auto pack = [&](const auto& values) {
    for (std::size_t i = 0; i < frame.particles.size(); ++i) {
      frame.particles[i] = glm::vec4(snapshot.fluid.positions[i], static_cast<float>(values[i]));
    }
  };
  std::visit(pack, snapshot.fluid.field(quantity).values);
}

}  // namespace weir
