#include "sph/particles.h"

#include "core/parallel.h"

namespace weir {

namespace {

template <class T>
void gather(std::vector<T>& values, const std::vector<std::int32_t>& order, Team& team) {
  std::vector<T> sorted(values.size());
  parallel_blocks(values.size(), team, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) sorted[k] = values[order[k]];
  });
  values.swap(sorted);
}

}  // namespace

template <int Dim>
void FluidParticles<Dim>::reorder(const std::vector<std::int32_t>& order, Team& team) {
  gather(position, order, team);
  gather(velocity, order, team);
  gather(id, order, team);
}

template struct FluidParticles<2>;
template struct FluidParticles<3>;

}  // namespace weir
