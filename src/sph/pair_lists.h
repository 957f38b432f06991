// Verlet lists of pairs of clusters, and what code that is built per instruction set sees of them: bare pointers.
#pragma once

#include <cstdint>
#include <vector>

#include "core/int_buffer.h"
#include "sph/tiling.h"

namespace weir {

// The lists of one ordered pair of sets, per tile of the target, in integers, for i-clusters: as many particles as an
// instruction set takes at once (1, 2 or 4), each i-cluster beginning at a multiple of that.
//
//   a set with itself:   for each i-cluster   n, then n j-clusters of the own tile that begin after the i-cluster's own,
//                                             segments, 0
//   one set and another: for each i-cluster that has any   its first slot, segments, 0;  then -1
//   segment:  count << 5 | code of the source's tile, then count j-clusters there (between sets the own tile is one, too)
//
// A j-cluster is named by its first slot. Two particles of one tile of one set are thus listed once, others from both
// sides: a tile writes only its own particles, and which thread does it changes no bit.
struct PairLists {
  std::vector<IntBuffer> listed;  // within the support and the skin
  std::vector<IntBuffer> pruned;  // what a pruning loop leaves of them: within the support as the particles stand
};

constexpr int segment_code_bits = 5;

// The box that the displacements of a tile's particles lie in, m.
template <int Dim>
struct DisplacementBox {
  Vec<Dim> least{};
  Vec<Dim> greatest{};

  DisplacementBox& operator+=(const DisplacementBox& b) {
    least += b.least;
    greatest += b.greatest;
    return *this;
  }
  friend DisplacementBox operator-(const DisplacementBox& a, const DisplacementBox& b) {
    return {a.least - b.least, a.greatest - b.greatest};
  }
};

// A sorted set of particles.
template <int Dim>
struct TilesView {
  const Tile* tiles = nullptr;
  const float* x[Dim] = {};
  const float* low[Dim] = {};  // of clusters
  const float* high[Dim] = {};
  const std::int32_t* columns = nullptr;        // of all tiles
  const DisplacementBox<Dim>* moved = nullptr;  // of tiles, since they were sorted into columns; null: not at all
};

// What the lists of one ordered pair of sets are made from.
template <int Dim>
struct ListInput {
  TilesView<Dim> target;
  TilesView<Dim> source;
  const std::int32_t* adjacent = nullptr;  // tile_codes per tile of the target: the tile of the source there, or -1
  float reach = 0;                         // m, support radius and skin
  float edge[Dim] = {};                    // m, of a tile
  std::int32_t columns = 0;
};

// Sums of pairs stand cluster by cluster, a cluster's components side by side: what a pair adds to four particles is one
// place in memory. So many floats a particle.
template <int components>
constexpr int sum_width = components <= 2 ? components : (components + 3) / 4 * 4;

// What loops over pairs read, of one ordered pair of sets.
template <int Dim>
struct PairInput {
  const Tile* tiles = nullptr;  // of the target
  const float* x[Dim] = {};     // of the target
  const float* source_x[Dim] = {};
  const IntBuffer* listed = nullptr;  // per tile
  IntBuffer* pruned = nullptr;
  float edge[Dim] = {};  // m, of a tile
};

}  // namespace weir
