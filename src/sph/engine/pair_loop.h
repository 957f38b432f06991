// The pair engine: the only code that visits neighbours. It owns loops, registers and memory access; what happens between
// two particles comes from equations/, through a pass (sph/passes/pass.h).
//
// A register holds pairs: each row one particle i, each column one neighbour j. Pairs within a tile of one set are visited
// once and summed to both sides, others from each side: a tile writes only its own particles. The order of sums follows the
// lists, so results have the same bits for any number of threads.
#pragma once

#include "simd/lanes.h"
#include "sph/engine/pruning.h"
#include "sph/pair_lists.h"
#include "sph/passes/pass.h"

namespace weir::WEIR_INSTRUCTION_SET {

struct LoadRows {
  std::int32_t slot;
  WEIR_INLINE Lanes operator()(const float* values) const { return load_rows(values + slot); }
};
struct LoadColumns {
  std::int32_t slot;
  WEIR_INLINE Lanes operator()(const float* values) const { return load_columns(values + slot); }
};

template <int Dim>
WEIR_INLINE Vec<Dim, Lanes> difference(const Vec<Dim, Lanes>& row, const float* const* x, std::int32_t slot) {
  Vec<Dim, Lanes> x_ij;
  for (int d = 0; d < Dim; ++d) x_ij[d] = row[d] - load_columns(x[d] + slot);
  return x_ij;
}

// `row` in the frame of the tile with this code.
template <int Dim>
WEIR_INLINE Vec<Dim, Lanes> seen_from(const Vec<Dim, Lanes>& row, int code, const float* edge) {
  const TileCoordinates<Dim> offset = offset_of_code<Dim>(code);
  Vec<Dim, Lanes> shifted;
  for (int d = 0; d < Dim; ++d) shifted[d] = row[d] - Lanes(edge[d] * static_cast<float>(offset[d]));
  return shifted;
}

// Where a tile's sums hold the first component of a particle, given from which slot on they go.
template <int components, class Float>
WEIR_INLINE Float* sums_at(Float* sums, std::int32_t begin, std::int32_t slot) {
  const std::int32_t column = slot & (cluster - 1);
  return sums + sum_width<components> * (slot - begin - column) + column;
}

template <int components>
WEIR_INLINE void add_to_row(const Vec<components, Lanes>& sum, float* sums) {
  for (int c = 0; c < components; ++c) add_rows(sum[c], sums + cluster * c);
}

// Adds what neighbours in the same set contribute to a tile's `sums`, see sum_width. `lists` gets the clusters that did.
template <int Dim, class Pass, class Lists>
WEIR_FLATTEN void visit_within(const PairInput<Dim>& in, const IntBuffer& visited, std::int32_t tile,
                               const Pass& constants, float* sums, Lists& lists) {
  constexpr int components = Pass::components;
  // Copies, which no store to a sum could change: they stay in registers.
  const Pass pass = constants;
  Lists pruned = lists;
  const float* x[Dim];
  float edge[Dim];
  for (int d = 0; d < Dim; ++d) {
    x[d] = in.x[d];
    edge[d] = in.edge[d];
  }
  const Tile slots = in.tiles[tile];
  const std::int32_t* list = visited.data();
  const Lanes column = column_numbers();
  for (std::int32_t i = slots.begin; i < slots.end; i += rows) {
    const LoadRows load_i{i};
    Vec<Dim, Lanes> x_i;
    for (int d = 0; d < Dim; ++d) x_i[d] = load_i(x[d]);
    const auto own = pass.template target<Lanes>(load_i);
    Vec<components, Lanes> sum;

    const auto visit_both = [&](std::int32_t j, auto see) {
      const auto other = pass.template source<Lanes>(LoadColumns{j});
      const Vec<Dim, Lanes> x_ij = difference<Dim>(x_i, x, j);
      const Lanes r2 = see(dot(x_ij, x_ij));
      Vec<components, Lanes> reaction;
      if constexpr (Pass::reaction == Reaction::both) {
        const Both<components, Lanes> both = pass.both(own, other, x_ij, r2);
        sum += both.to_i;
        reaction = both.to_j;
      } else {
        const Vec<components, Lanes> action = pass.pair(own, other, x_ij, r2);
        sum += action;
        if constexpr (Pass::reaction == Reaction::exchanged) {
          reaction = pass.pair(other, own, Lanes(-1.0F) * x_ij, r2);
        } else {
          reaction = action;
        }
      }
      constexpr bool subtract = Pass::reaction == Reaction::opposite;
      accumulate_columns<subtract, components>(reaction.e, sums + sum_width<components> * (j - slots.begin));
    };
    // In the i-cluster's own j-cluster each pair stands twice, and each particle beside itself: those after the row remain.
    const Lanes last = row_numbers() + Lanes(static_cast<float>(i & (cluster - 1)));
    visit_both(i - (i & (cluster - 1)),
               [&](Lanes r2) { return select(less(last, column), r2, Lanes(beyond_support)); });
    pruned.begin();
    for (std::int32_t n = *list++; n > 0; --n) {
      const std::int32_t j = *list++;
      visit_both(j, [&](Lanes r2) {
        pruned.offer(j, r2);
        return r2;
      });
    }
    pruned.end_count();

    while (const std::int32_t header = *list++) {
      const int code = header & ((1 << segment_code_bits) - 1);
      const Vec<Dim, Lanes> x_seen = seen_from<Dim>(x_i, code, edge);
      pruned.begin();
      for (std::int32_t n = header >> segment_code_bits; n > 0; --n) {
        const std::int32_t j = *list++;
        const auto other = pass.template source<Lanes>(LoadColumns{j});
        const Vec<Dim, Lanes> x_ij = difference<Dim>(x_seen, x, j);
        const Lanes r2 = dot(x_ij, x_ij);
        pruned.offer(j, r2);
        if constexpr (Pass::reaction == Reaction::both) {
          sum += pass.both(own, other, x_ij, r2).to_i;
        } else {
          sum += pass.pair(own, other, x_ij, r2);
        }
      }
      pruned.end_segment(code);
    }
    pruned.append(0);
    add_to_row<components>(sum, sums_at<components>(sums, slots.begin, i));
  }
  lists = pruned;
}

// Adds what neighbours in another set contribute; i-clusters without any are not looked at.
template <int Dim, class Pass, class Lists>
WEIR_FLATTEN void visit_between(const PairInput<Dim>& in, const IntBuffer& visited, std::int32_t tile,
                                const Pass& constants, float* sums, Lists& lists) {
  constexpr int components = Pass::components;
  const Pass pass = constants;
  Lists pruned = lists;
  const float* x[Dim];
  float edge[Dim];
  for (int d = 0; d < Dim; ++d) {
    x[d] = in.source_x[d];
    edge[d] = in.edge[d];
  }
  const Tile slots = in.tiles[tile];
  const std::int32_t* list = visited.data();
  for (std::int32_t i = *list++; i >= 0; i = *list++) {
    const LoadRows load_i{i};
    Vec<Dim, Lanes> x_i;
    for (int d = 0; d < Dim; ++d) x_i[d] = load_i(in.x[d]);
    const auto own = pass.template target<Lanes>(load_i);
    Vec<components, Lanes> sum;
    std::int32_t* const before = pruned.end();
    pruned.append(i);
    bool near = false;
    while (const std::int32_t header = *list++) {
      const int code = header & ((1 << segment_code_bits) - 1);
      const Vec<Dim, Lanes> x_seen = seen_from<Dim>(x_i, code, edge);
      pruned.begin();
      for (std::int32_t n = header >> segment_code_bits; n > 0; --n) {
        const std::int32_t j = *list++;
        const auto other = pass.template source<Lanes>(LoadColumns{j});
        const Vec<Dim, Lanes> x_ij = difference<Dim>(x_seen, x, j);
        const Lanes r2 = dot(x_ij, x_ij);
        pruned.offer(j, r2);
        sum += pass.pair(own, other, x_ij, r2);
      }
      near = pruned.end_segment(code) || near;
    }
    pruned.append(0);
    if (!near) pruned.cut(before);
    add_to_row<components>(sum, sums_at<components>(sums, slots.begin, i));
  }
  pruned.append(-1);
  lists = pruned;
}

}  // namespace weir::WEIR_INSTRUCTION_SET
