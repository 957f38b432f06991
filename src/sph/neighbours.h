// Who is near whom: for each fluid particle the fluid and the wall particles within the support.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/parallel.h"
#include "scene/scene.h"
#include "sph/cell_grid.h"
#include "sph/particles.h"

namespace weir {

// For each particle of the fluid a list of places in another array, in blocks of `block_size` particles.
class NeighbourLists {
 public:
  std::span<const std::int32_t> of(std::size_t i) const {
    const std::uint32_t begin = i % block_size == 0 ? 0 : ends_[i - 1];
    return {blocks_[i / block_size].data() + begin, ends_[i] - begin};
  }

  void resize(std::size_t particles);
  // Lists are appended in the order of particles within a block; blocks are independent.
  std::vector<std::int32_t>& block(std::size_t b) { return blocks_[b]; }
  void end_list(std::size_t b, std::size_t i);

 private:
  std::vector<std::vector<std::int32_t>> blocks_;
  std::vector<std::uint32_t> ends_;  // of particle i's list in its block
};

template <int Dim>
class Neighbours {
 public:
  // Lists reach `skin` (m) beyond `support_radius` (m) and are kept until two particles could have come that much
  // closer.
  struct Settings {
    double support_radius = 0;
    double skin = 0;
    NeighbourSearch search = NeighbourSearch::index_sort;
  };
  // Sorts the walls by space, once.
  Neighbours(const Settings& settings, Team& team, WallParticles<Dim>& walls);

  // Makes the lists right for the particles' positions. Sorts the particles by space whenever lists are made anew.
  void update(FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls);

  const NeighbourLists& fluid() const { return fluid_lists_; }  // j != i, within support_radius + skin
  const NeighbourLists& walls() const { return wall_lists_; }

  std::int64_t rebuilds() const { return rebuilds_; }
  // Positions jumped (a reset): make lists anew at the next update.
  void forget() { position_at_build_.clear(); }

 private:
  bool still_right(const FluidParticles<Dim>& fluid) const;
  void rebuild(FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls);

  Settings settings_;
  Team& team_;
  CellGrid<Dim> fluid_grid_;
  CellGrid<Dim> wall_grid_;
  NeighbourLists fluid_lists_;
  NeighbourLists wall_lists_;
  std::vector<Vec<Dim, double>> position_at_build_;
  std::int64_t rebuilds_ = 0;
};

extern template class Neighbours<2>;
extern template class Neighbours<3>;

}  // namespace weir
