#include "sph/particles.h"

namespace weir {

template <int Dim>
void FluidParticles<Dim>::follow(const Tiling<Dim>& tiling, ThreadPool& pool) {
  const std::size_t slots = tiling.slots() + group_size;  // the slack that whole registers may read
  density.resize(slots);
  pressure_term.resize(slots);
  for (int d = 0; d < Dim; ++d) {
    // The accelerations of before the sort are of no use any more: their memory takes the sorted velocities.
    acceleration[d].resize(slots);
    pool.for_each(tiling.tiles().size(), [&](std::size_t tile) {
      const auto end = static_cast<std::size_t>(tiling.end_of_slots(tile));
      for (auto slot = static_cast<std::size_t>(tiling.tiles()[tile].begin); slot < end; ++slot) {
        const std::int32_t from = tiling.order()[slot];
        acceleration[d][slot] = from < 0 ? 0.0F : velocity[d][static_cast<std::size_t>(from)];
      }
    });
    std::swap(velocity[d], acceleration[d]);
    acceleration[d].resize(slots);
  }
}

template struct FluidParticles<2>;
template struct FluidParticles<3>;

}  // namespace weir
