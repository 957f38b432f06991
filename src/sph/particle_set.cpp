#include "sph/particle_set.h"

#include <utility>

namespace weir {

template <int Dim>
Field& ParticleSet<Dim>::add(std::string_view name, std::string_view unit, int components, Keeping keeping) {
  fields_.push_back({.name = name, .unit = unit, .keeping = keeping, .components = components});
  return fields_.back();
}

template <int Dim>
void ParticleSet<Dim>::start_at(const std::vector<Vec<Dim, double>>& points) {
  static_cast<Positions<Dim>&>(*this) = unsorted<Dim>(points);
  count = points.size();
  for (Field& field : fields_) {
    for (int c = 0; c < field.components; ++c) {
      field.values[static_cast<std::size_t>(c)].assign(this->slots() + group_size, 0.0F);
    }
  }
}

template <int Dim>
void ParticleSet<Dim>::follow(const Tiling<Dim>& tiling, ThreadPool& pool) {
  const std::size_t slots = tiling.slots() + group_size;
  for (Field& field : fields_) {
    for (int c = 0; c < field.components; ++c) {
      AlignedVector<float>& values = field.values[static_cast<std::size_t>(c)];
      if (field.keeping == Keeping::recomputed) {
        values.resize(slots);
        continue;
      }
      spare_.resize(slots);
      pool.for_each(tiling.tiles().size(), [&](std::size_t tile) {
        const auto end = static_cast<std::size_t>(tiling.end_of_slots(tile));
        for (auto slot = static_cast<std::size_t>(tiling.tiles()[tile].begin); slot < end; ++slot) {
          const std::int32_t from = tiling.order()[slot];
          spare_[slot] = from < 0 ? 0.0F : values[static_cast<std::size_t>(from)];
        }
      });
      std::swap(values, spare_);
    }
  }
}

template class ParticleSet<2>;
template class ParticleSet<3>;

}  // namespace weir
