// Lists of pairs, written out: who may be whose neighbour, by id.
#pragma once

#include <cstdint>
#include <set>
#include <utility>

#include "sph/pair_search.h"

namespace weir {

using IdPairs = std::set<std::pair<std::int32_t, std::int32_t>>;

namespace detail {

// The clusters of the segments at `list` against a row; returns what follows them.
template <int Dim>
const std::int32_t* take_segments(const std::int32_t* list, const Positions<Dim>& fluid, std::int32_t row, int rows,
                                  const Positions<Dim>& others, IdPairs& pairs) {
  while (const std::int32_t header = *list++) {
    for (std::int32_t n = header >> segment_code_bits; n > 0; --n, ++list) {
      for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < cluster_size; ++j) pairs.insert({fluid.id[row + i], others.id[*list + j]});
      }
    }
  }
  return list;
}

inline void drop_empty(IdPairs& pairs) {
  std::erase_if(pairs, [](const auto& pair) { return pair.first < 0 || pair.second < 0; });
}

}  // namespace detail

// (i, j) and (j, i) for fluid particles that the lists bring together.
template <int Dim>
IdPairs listed_fluid_pairs(const PairSearch<Dim>& search, const ParticleSet<Dim>& fluid, int rows) {
  IdPairs pairs;
  for (std::size_t tile = 0; tile < search.tiling(fluid).tiles().size(); ++tile) {
    const std::int32_t* list = search.lists(fluid, fluid).listed[tile].data();
    const Tile slots = search.tiling(fluid).tiles()[tile];
    for (std::int32_t row = slots.begin; row < slots.end; row += rows) {
      const auto both = [&](std::int32_t cluster, int i, int j) {
        pairs.insert({fluid.id[row + i], fluid.id[cluster + j]});
        pairs.insert({fluid.id[cluster + j], fluid.id[row + i]});
      };
      const std::int32_t own = row - row % cluster_size;
      for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < cluster_size; ++j) {
          if (own + j > row + i) both(own, i, j);
        }
      }
      for (std::int32_t n = *list++; n > 0; --n, ++list) {
        for (int i = 0; i < rows; ++i) {
          for (int j = 0; j < cluster_size; ++j) both(*list, i, j);
        }
      }
      list = detail::take_segments<Dim>(list, fluid, row, rows, fluid, pairs);
    }
  }
  detail::drop_empty(pairs);
  return pairs;
}

// (i, j) for a fluid particle i and a wall particle j.
template <int Dim>
IdPairs listed_wall_pairs(const PairSearch<Dim>& search, const ParticleSet<Dim>& fluid, const ParticleSet<Dim>& walls,
                          int rows) {
  IdPairs pairs;
  for (std::size_t tile = 0; tile < search.tiling(fluid).tiles().size(); ++tile) {
    const std::int32_t* list = search.lists(fluid, walls).listed[tile].data();
    for (std::int32_t row = *list++; row >= 0; row = *list++) {
      list = detail::take_segments<Dim>(list, fluid, row, rows, walls, pairs);
    }
  }
  detail::drop_empty(pairs);
  return pairs;
}

}  // namespace weir
