// Who is near whom, in clusters, and what code that is built per instruction set sees of it: bare pointers.
#pragma once

#include <cstdint>
#include <vector>

#include "core/int_buffer.h"
#include "sph/tiling.h"

namespace weir {

// Lists of one tile, in integers, for rows of particles: as many as an instruction set takes at once (1, 2 or 4), each
// row of slots beginning at a multiple of that.
//
//   fluid:  for each row   n, then n clusters of the own tile that begin after the row's own cluster,
//                          segments, 0
//   walls:  for each row that has any   its first slot, segments, 0;  then -1
//   segment:  count << 5 | code of the tile beside, then count clusters there (the wall's own tile is one, too)
//
// A cluster is named by its first slot. Two particles of the own tile are thus listed once, particles of different tiles
// from both sides: a tile writes only its own particles, and which thread does it changes no bit.
struct PairLists {
  std::vector<IntBuffer> fluid;  // per tile of the fluid
  std::vector<IntBuffer> walls;
};

constexpr int segment_code_bits = 5;

// The box that the displacements of a tile's particles lie in, m.
template <int Dim>
struct DisplacementBox {
  Vec<Dim> least{};
  Vec<Dim> greatest{};

  friend DisplacementBox operator-(const DisplacementBox& a, const DisplacementBox& b) {
    return {a.least - b.least, a.greatest - b.greatest};
  }
};

// A sorted set of particles.
template <int Dim>
struct TilesView {
  const Tile* tiles = nullptr;
  std::int32_t tile_count = 0;
  const float* x[Dim] = {};
  const float* low[Dim] = {};  // of clusters
  const float* high[Dim] = {};
  const std::int32_t* columns = nullptr;  // of all tiles
  const TileCoordinates<Dim>* coordinates = nullptr;
  const DisplacementBox<Dim>* moved = nullptr;  // of tiles, since they were sorted into columns; null: not at all
  const std::int32_t* adjacent = nullptr;       // tile_codes per tile of the fluid: the tile of this set there, or -1
};

// What lists are made from.
template <int Dim>
struct ListInput {
  TilesView<Dim> fluid;
  TilesView<Dim> walls;
  float reach = 0;  // m, support radius and skin
  float edge = 0;   // m, of a tile
  std::int32_t columns = 0;
  bool all_pairs = false;  // the naive search: look at every cluster instead of those that the order shows to be near
};

// Sums of pairs stand cluster by cluster, a cluster's components side by side: what a pair adds to four particles is one
// place in memory. So many floats a particle.
template <int components>
constexpr int sum_width = components == 3 ? 4 : components;

// What pair loops read.
template <int Dim>
struct PairInput {
  const Tile* tiles = nullptr;
  const float* x[Dim] = {};
  const float* wall_x[Dim] = {};
  const IntBuffer* fluid_lists = nullptr;
  const IntBuffer* wall_lists = nullptr;
  float edge = 0;  // m, of a tile
};

}  // namespace weir
