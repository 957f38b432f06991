// The pair engine: the only code that visits neighbours. It owns loops, registers and memory access; what happens between
// two particles comes from equations/, through a pass (sph/passes.h).
//
// A register holds pairs: each row one particle i, each column one neighbour j. Pairs within a tile are visited once and
// summed to both sides, pairs between tiles from each side: a tile writes only its own particles. The order of sums
// follows the lists, so results have the same bits for any number of threads.
#pragma once

#include "simd/lanes.h"
#include "sph/engine/narrowed.h"
#include "sph/pair_lists.h"
#include "sph/passes.h"

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
WEIR_INLINE Vec<Dim, Lanes> seen_from(const Vec<Dim, Lanes>& row, int code, float edge) {
  const TileCoordinates<Dim> offset = offset_of_code<Dim>(code);
  Vec<Dim, Lanes> shifted;
  for (int d = 0; d < Dim; ++d) shifted[d] = row[d] - Lanes(edge * static_cast<float>(offset[d]));
  return shifted;
}

// Where a tile's sums hold the first component of a particle, given from which slot on they go.
template <int components>
WEIR_INLINE float* sums_at(float* sums, std::int32_t begin, std::int32_t slot) {
  const std::int32_t column = slot & (cluster - 1);
  return sums + sum_width<components> * (slot - begin - column) + column;
}

// Adds what the fluid neighbours of a tile's particles contribute to `sums`, see sum_width. `narrowed` gets the clusters
// that did.
template <int Dim, class Pass, class Lists>
WEIR_FLATTEN void visit_fluid(const PairInput<Dim>& in, std::int32_t tile, const Pass& constants, float* sums,
                              Lists& lists) {
  constexpr int components = Pass::components;
  // Copies, which no store to a sum could change: they stay in registers.
  const Pass pass = constants;
  Lists narrowed = lists;
  const float* x[Dim];
  for (int d = 0; d < Dim; ++d) x[d] = in.x[d];
  const Tile slots = in.tiles[tile];
  const std::int32_t* list = in.fluid_lists[tile].data();
  const Lanes column = column_numbers();
  for (std::int32_t i = slots.begin; i < slots.end; i += rows) {
    const LoadRows load_i{i};
    Vec<Dim, Lanes> x_i;
    for (int d = 0; d < Dim; ++d) x_i[d] = load_i(x[d]);
    const auto own = pass.template state<Lanes>(load_i);
    Vec<components, Lanes> sum;

    const auto visit_both = [&](std::int32_t j, auto see) {
      const auto other = pass.template state<Lanes>(LoadColumns{j});
      const Vec<Dim, Lanes> x_ij = difference<Dim>(x_i, x, j);
      const Lanes r2 = see(dot(x_ij, x_ij));
      const Vec<components, Lanes> action = pass.fluid(own, other, x_ij, r2);
      sum += action;
      Vec<components, Lanes> reaction;
      if constexpr (Pass::reaction == Reaction::own) {
        reaction = pass.fluid(other, own, Lanes(-1.0F) * x_ij, r2);
      } else {
        reaction = action;
      }
      constexpr bool subtract = Pass::reaction == Reaction::opposite;
      accumulate_columns<subtract, components>(reaction.e, sums + sum_width<components> * (j - slots.begin));
    };
    // In the row's own cluster each pair stands twice, and each particle beside itself: those after the row remain.
    const Lanes last = row_numbers() + Lanes(static_cast<float>(i & (cluster - 1)));
    visit_both(i - (i & (cluster - 1)),
               [&](Lanes r2) { return select(less(last, column), r2, Lanes(beyond_support)); });
    narrowed.begin();
    for (std::int32_t n = *list++; n > 0; --n) {
      const std::int32_t j = *list++;
      visit_both(j, [&](Lanes r2) {
        narrowed.offer(j, r2);
        return r2;
      });
    }
    narrowed.end_count();

    while (const std::int32_t header = *list++) {
      const int code = header & ((1 << segment_code_bits) - 1);
      const Vec<Dim, Lanes> x_seen = seen_from<Dim>(x_i, code, in.edge);
      narrowed.begin();
      for (std::int32_t n = header >> segment_code_bits; n > 0; --n) {
        const std::int32_t j = *list++;
        const auto other = pass.template state<Lanes>(LoadColumns{j});
        const Vec<Dim, Lanes> x_ij = difference<Dim>(x_seen, x, j);
        const Lanes r2 = dot(x_ij, x_ij);
        narrowed.offer(j, r2);
        sum += pass.fluid(own, other, x_ij, r2);
      }
      narrowed.end_segment(code);
    }
    narrowed.append(0);
    for (int c = 0; c < components; ++c) add_rows(sum[c], sums_at<components>(sums, slots.begin, i) + cluster * c);
  }
  lists = narrowed;
}

// Adds what the wall neighbours of a tile's particles contribute; rows without any are not looked at.
template <int Dim, class Pass, class Lists>
WEIR_FLATTEN void visit_walls(const PairInput<Dim>& in, std::int32_t tile, const Pass& constants, float* sums,
                              Lists& lists) {
  constexpr int components = Pass::components;
  const Pass pass = constants;
  Lists narrowed = lists;
  const float* x[Dim];
  for (int d = 0; d < Dim; ++d) x[d] = in.wall_x[d];
  const Tile slots = in.tiles[tile];
  const std::int32_t* list = in.wall_lists[tile].data();
  for (std::int32_t i = *list++; i >= 0; i = *list++) {
    const LoadRows load_i{i};
    Vec<Dim, Lanes> x_i;
    for (int d = 0; d < Dim; ++d) x_i[d] = load_i(in.x[d]);
    const auto own = pass.template state<Lanes>(load_i);
    Vec<components, Lanes> sum;
    std::int32_t* const before = narrowed.end();
    narrowed.append(i);
    bool near = false;
    while (const std::int32_t header = *list++) {
      const int code = header & ((1 << segment_code_bits) - 1);
      const Vec<Dim, Lanes> x_seen = seen_from<Dim>(x_i, code, in.edge);
      narrowed.begin();
      for (std::int32_t n = header >> segment_code_bits; n > 0; --n) {
        const std::int32_t j = *list++;
        const Vec<Dim, Lanes> x_ij = difference<Dim>(x_seen, x, j);
        const Lanes r2 = dot(x_ij, x_ij);
        narrowed.offer(j, r2);
        sum += pass.wall(own, x_ij, r2);
      }
      near = narrowed.end_segment(code) || near;
    }
    narrowed.append(0);
    if (!near) narrowed.cut(before);
    for (int c = 0; c < components; ++c) add_rows(sum[c], sums_at<components>(sums, slots.begin, i) + cluster * c);
  }
  narrowed.append(-1);
  lists = narrowed;
}

}  // namespace weir::WEIR_INSTRUCTION_SET
