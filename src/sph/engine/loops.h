// What engine/built.h declares, for registers of one instruction set.
#pragma once

#include "simd/lanes.h"
#include "sph/engine/built.h"
#include "sph/engine/list_pairs.h"
#include "sph/engine/pair_loop.h"

namespace weir::WEIR_INSTRUCTION_SET {

// The first slot after the whole registers that hold a tile's particles. A tile ends with a whole group, which is a whole
// number of registers.
WEIR_INLINE std::int32_t end_of_registers(const Tile& slots) {
  return slots.begin + (slots.end - slots.begin + lanes - 1) / lanes * lanes;
}

template <class Pass>
WEIR_INLINE void begin_sums(const Pass& pass, const Tile& slots, float* sums) {
  constexpr int width = sum_width<Pass::components>;
  const auto clusters = (end_of_registers(slots) - slots.begin) / cluster;
  for (std::int32_t k = 0; k < clusters; ++k) {
    for (int c = 0; c < width; ++c) {
      const float value = c < Pass::components ? pass.start(c) : 0;
      float* const to = sums + static_cast<std::ptrdiff_t>(cluster) * (k * width + c);
      for (int column = 0; column < cluster; ++column) to[column] = value;
    }
  }
}

// visit(lists that are visited, lists that are left behind).
template <class Pass, int Dim, class Visit>
WEIR_INLINE void visit_lists(const PairArguments<Dim>& in, const Visit& visit) {
  IntBuffer& pruned = in.pairs.pruned[in.tile];
  if constexpr (Pass::prunes) {
    const IntBuffer& listed = in.pairs.listed[in.tile];
    pruned.set_size(0);
    pruned.reserve_more(listed.size());
    Pruned left(pruned.data(), in.support_radius);
    visit(listed, left);
    pruned.set_size(static_cast<std::size_t>(left.end() - pruned.data()));
  } else {
    Unpruned left;
    visit(in.listed ? in.pairs.listed[in.tile] : pruned, left);
  }
}

template <class Pass>
void Pairs<Within<Pass>>::run(const void* parameters, const PairArguments<Pass::dimension>& in) {
  const auto& pass = *static_cast<const Pass*>(parameters);
  if (in.first) begin_sums(pass, in.pairs.tiles[in.tile], in.sums);
  visit_lists<Pass>(in, [&](const IntBuffer& lists, auto& left) {
    visit_within<Pass::dimension>(in.pairs, lists, in.tile, pass, in.sums, left);
  });
}

template <class Pass>
void Pairs<Between<Pass>>::run(const void* parameters, const PairArguments<Pass::dimension>& in) {
  const auto& pass = *static_cast<const Pass*>(parameters);
  if (in.first) begin_sums(pass, in.pairs.tiles[in.tile], in.sums);
  visit_lists<Pass>(in, [&](const IntBuffer& lists, auto& left) {
    visit_between<Pass::dimension>(in.pairs, lists, in.tile, pass, in.sums, left);
  });
}

// A register of particles, as an update sees it.
template <int components>
struct Registers {
  using Number = Lanes;
  std::int32_t slot;
  std::int32_t begin;  // of the tile
  const float* sums;
  Mask particle;

  WEIR_INLINE Lanes load(const float* values) const { return WEIR_INSTRUCTION_SET::load(values + slot); }
  WEIR_INLINE void store(Lanes value, float* values) const { WEIR_INSTRUCTION_SET::store(value, values + slot); }
  WEIR_INLINE Lanes sum(int component) const {
    return load_clusters(sums_at<components>(sums, begin, slot) + cluster * component, cluster * sum_width<components>);
  }
  // What empty slots get instead.
  WEIR_INLINE Lanes of_particles(Lanes value, Lanes otherwise) const { return select(particle, value, otherwise); }
  WEIR_INLINE bool first() const { return slot == begin; }
};

template <class Update>
typename Update::Result Each<Update>::run(const Update& constants, const UpdateArguments& in) {
  const Update update = constants;
  typename Update::template Running<Lanes> running;
  for (std::int32_t i = in.slots.begin; i < in.slots.end; i += lanes) {
    update(Registers<Update::components>{i, in.slots.begin, in.sums, not_negative(in.id + i)}, running);
  }
  return update.result(running);
}

template <int Dim>
void list_within(const ListInput<Dim>& in, std::int32_t tile, IntBuffer& list, IntBuffer& scratch) {
  TileLister<Dim>(in, tile, list, scratch).list_within();
}
template <int Dim>
void list_between(const ListInput<Dim>& in, std::int32_t tile, IntBuffer& list, IntBuffer& scratch) {
  TileLister<Dim>(in, tile, list, scratch).list_between();
}
template <int Dim>
Listers<Dim> listers() {
  return {.rows = rows, .within = list_within<Dim>, .between = list_between<Dim>};
}

}  // namespace weir::WEIR_INSTRUCTION_SET
