// Who is near whom: the fluid sorted by space, and lists of pairs within the support and a skin, kept while they are
// right.
#pragma once

#include <cstdint>

#include "scene/scene.h"
#include "simd/instruction_set.h"
#include "sph/pair_lists.h"
#include "sph/particles.h"
#include "sph/tiling.h"

namespace weir {

// How far particles have moved since lists were made: the box of all displacements, and the longest.
template <int Dim>
struct Displacements {
  Vec<Dim> least{};           // m
  Vec<Dim> greatest{};        // m
  float longest_squared = 0;  // m^2
};

template <int Dim>
class Neighbours {
 public:
  // Lists reach `skin` (m) beyond `support_radius` (m).
  struct Settings {
    double particle_spacing = 0;
    double support_radius = 0;
    double skin = 0;
    NeighbourSearch search = NeighbourSearch::index_sort;
    InstructionSet instruction_set = InstructionSet::baseline;
  };
  // Sorts the walls by space, once.
  Neighbours(const Settings& settings, Team& team, WallParticles<Dim>& walls);

  // Makes the lists right after the particles moved by up to `moved` since they were made. Sorts the particles whenever
  // lists are made anew. Throws std::range_error for particles that have flown too far.
  void update(FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls, const Displacements<Dim>& moved);

  // The lists were made for these places; displacements count from there.
  const std::array<AlignedVector<float>, Dim>& start() const { return start_; }
  std::int64_t rebuilds() const { return rebuilds_; }
  // Positions jumped (a reset): make lists anew at the next update.
  void forget() { made_ = false; }

  const Tiling<Dim>& tiling() const { return fluid_tiling_; }
  PairInput<Dim> pairs(const FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls) const;
  const PairLists& lists() const { return lists_; }

 private:
  bool still_right(const Displacements<Dim>& moved) const;
  void rebuild(FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls);

  Settings settings_;
  Team& team_;
  Tiling<Dim> fluid_tiling_;
  Tiling<Dim> wall_tiling_;
  PairLists lists_;
  std::array<AlignedVector<float>, Dim> start_;
  std::int64_t rebuilds_ = 0;
  bool made_ = false;
};

extern template class Neighbours<2>;
extern template class Neighbours<3>;

}  // namespace weir
