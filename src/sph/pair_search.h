// Neighbour search: sets of particles sorted by space on one lattice of tiles, and Verlet lists of pairs within the support
// and a skin, for each ordered pair of sets that some loop asks for.
//
// Lists live until particles of a tile and of one beside it may have come a skin closer; then those of that tile alone are
// rebuilt: a splash does not make the lists of water at rest stale. The displacement box of a fixed set is empty.
//
// What decides the bits of a result is the order of slots: when each set was sorted, and from which order. Lists do not: a
// listed pair beyond the support adds exactly zero, so they may be rebuilt at any moment.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "simd/instruction_set.h"
#include "sph/engine/built.h"
#include "sph/pair_lists.h"
#include "sph/particle_set.h"

namespace weir {

enum class Mobility { fixed, moving };

template <int Dim>
class PairSearch {
 public:
  struct Settings {
    double particle_spacing = 0;  // m
    double support_radius = 0;    // m
    double skin = 0;              // m, how far lists reach beyond the support
    std::size_t particles = 0;    // of the largest set
    Periodicity<Dim> periodic{};
    InstructionSet instruction_set = InstructionSet::baseline;
  };
  PairSearch(const Settings& settings, ThreadPool& pool);

  // Sorts a fixed set once, here. Sets must outlive the search.
  void add(ParticleSet<Dim>& set, Mobility mobility);
  // From now on there are lists of the source's particles near those of the target.
  void list(const ParticleSet<Dim>& target, const ParticleSet<Dim>& source);

  // The particles of a tile moved; a bound that only grows is as good as where each of them went.
  void follow(const ParticleSet<Dim>& set, std::size_t tile, const DisplacementBox<Dim>& moved);
  // Rebuilds stale lists, and from time to time sorts the particles. Throws std::range_error for particles that have flown
  // too far.
  void update();
  // Sort and rebuild everything at the next update.
  void expire();
  // Positions of moving sets jumped (a reset), and are not sorted.
  void forget();

  double seconds() const { return seconds_; }  // in update()
  std::int64_t sorts(const ParticleSet<Dim>& set) const { return member(set).sorts; }
  std::int64_t listed_tiles(const ParticleSet<Dim>& set) const { return member(set).listed_tiles; }
  const TileLattice<Dim>& lattice() const { return lattice_; }
  const Tiling<Dim>& tiling(const ParticleSet<Dim>& set) const { return member(set).tiling; }
  const PairLists& lists(const ParticleSet<Dim>& target, const ParticleSet<Dim>& source) const;
  PairInput<Dim> pairs(const ParticleSet<Dim>& target, const ParticleSet<Dim>& source);
  // Whether any particle of the source can be near one of this tile.
  bool near(const ParticleSet<Dim>& target, std::size_t tile) const;

 private:
  struct Member;
  struct Pair {  // of the member that owns it and a source
    Member* source;
    PairLists lists;
    std::vector<std::int32_t> adjacent;              // see ListInput
    std::vector<DisplacementBox<Dim>> source_moved;  // of the source's tiles around each, when its lists were made
  };
  struct Member {
    ParticleSet<Dim>* set;
    bool moving;
    Tiling<Dim> tiling;
    std::vector<DisplacementBox<Dim>> moved;              // of each tile, since it was sorted
    std::vector<DisplacementBox<Dim>> moved_when_listed;  // of each tile, when its lists were made
    std::deque<Pair> pairs;
    std::vector<std::int32_t> stale{};  // tiles whose lists are to be built
    bool sorted = false;
    bool just_sorted = false;
    std::int64_t sorts = 0;
    std::int64_t listed_tiles = 0;
    std::int64_t listed_before_sort = 0;
  };

  const Member& member(const ParticleSet<Dim>& set) const;
  Member& member(const ParticleSet<Dim>& set) {
    return const_cast<Member&>(static_cast<const PairSearch*>(this)->member(set));
  }
  const Pair& pair(const ParticleSet<Dim>& target, const ParticleSet<Dim>& source) const;
  void rebuild();
  void sort(Member& member);
  bool must_sort(Member& member) const;  // and which tiles are stale, if not
  void meet(Member& target);
  bool far_from_columns(const Member& member) const;
  bool still_valid(const Member& member, std::size_t tile) const;
  std::vector<std::int32_t> stale_tiles(const Member& member) const;
  void bound_clusters_around(const Member& target, const std::vector<std::int32_t>& tiles);
  void build(Member& target, const std::vector<std::int32_t>& tiles);

  Settings settings_;
  ThreadPool& pool_;
  TileLattice<Dim> lattice_;
  Listers<Dim> listers_;
  std::deque<Member> members_;
  double seconds_ = 0;
};

extern template class PairSearch<2>;
extern template class PairSearch<3>;

}  // namespace weir
