// Who is near whom: the fluid sorted by space, and lists of pairs within the support and a skin, kept while they are
// right. Each tile's lists are made anew for themselves, when its particles and those of a tile beside it may have come a
// skin closer: a splash does not make the lists of water at rest wrong.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/scene.h"
#include "simd/instruction_set.h"
#include "sph/engine/engine.h"
#include "sph/pair_lists.h"
#include "sph/particles.h"
#include "sph/tiling.h"

namespace weir {

template <int Dim>
class Neighbours {
 public:
  // Lists reach `skin` (m) beyond `support_radius` (m).
  struct Settings {
    double particle_spacing = 0;
    double support_radius = 0;
    double skin = 0;
    std::size_t particles = 0;  // of the fluid
    NeighbourSearch search = NeighbourSearch::index_sort;
    InstructionSet instruction_set = InstructionSet::baseline;
  };
  // Sorts the walls by space, once.
  Neighbours(const Settings& settings, ThreadPool& pool, WallParticles<Dim>& walls);

  // The particles of a tile moved; a bound that only grows is as good as where each of them went.
  void follow(std::size_t tile, const DisplacementBox<Dim>& moved);
  // Makes the lists right that motion may have made wrong, and from time to time sorts the particles anew. Throws
  // std::range_error for particles that have flown too far.
  void update(FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls);
  // Sort and list at the next update, though lists may be right.
  void expire() { sorted_ = false; }
  // Positions jumped (a reset), to places that were not sorted.
  void forget() {
    sorted_ = false;
    fluid_tiling_.forget();
  }

  std::int64_t sorts() const { return sorts_; }
  std::int64_t listed_tiles() const { return listed_tiles_; }
  const Tiling<Dim>& tiling() const { return fluid_tiling_; }
  PairInput<Dim> pairs(const FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls) const;
  const PairLists& lists() const { return lists_; }
  // What the first loop over pairs leaves of the lists: those within the support as the particles stand.
  PairLists& near_lists() { return near_lists_; }
  PairInput<Dim> near_pairs(const FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls) const;

 private:
  void sort(FluidParticles<Dim>& fluid);
  bool far_from_columns() const;
  bool still_right(std::size_t tile) const;
  std::vector<std::int32_t> wrong_tiles() const;
  void bound_clusters_around(const std::vector<std::int32_t>& tiles, const FluidParticles<Dim>& fluid);
  void list(const std::vector<std::int32_t>& tiles, const FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls);

  Settings settings_;
  ListPairs<Dim> list_pairs_;
  ThreadPool& pool_;
  Tiling<Dim> fluid_tiling_;
  Tiling<Dim> wall_tiling_;
  PairLists lists_;
  PairLists near_lists_;
  std::vector<std::int32_t> fluid_beside_;  // see TilesView::adjacent
  std::vector<std::int32_t> walls_beside_;
  std::vector<DisplacementBox<Dim>> moved_;       // of each tile, since it was sorted
  std::vector<DisplacementBox<Dim>> moved_then_;  // of the tiles around each, when its lists were made
  bool sorted_ = false;
  std::int64_t sorts_ = 0;
  std::int64_t listed_tiles_ = 0;
  std::int64_t listed_before_sort_ = 0;
};

extern template class Neighbours<2>;
extern template class Neighbours<3>;

}  // namespace weir
