// Particles sorted by space: into tiles, within a tile into columns along the last axis, within a column by height.
//
// Consecutive particles are then near each other, and consecutive clusters of four make compact boxes, which is what
// the lists of pairs are built from. Only tiles that hold particles exist: memory and time follow the particles, not the
// domain. The order depends on the particles alone, never on the number of threads. [The index sort of Hinsch24 ch. 5.2
// on sparse cells]
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/thread_pool.h"
#include "core/types.h"
#include "sph/positions.h"
#include "sph/tile_lattice.h"

namespace weir {

// Slots [begin, end) hold the tile's particles; the next tile begins at a whole group.
struct Tile {
  std::int32_t begin = 0;
  std::int32_t end = 0;
};

template <int Dim>
class Tiling {
 public:
  explicit Tiling(const TileLattice<Dim>& lattice) : lattice_(lattice) {}

  // Sorts `places`. order()[k] tells which slot the particle now in slot k came from, -1 for an empty slot.
  void sort(Positions<Dim>& positions, ThreadPool& pool);
  // The next places to sort are not those of the last sort.
  void forget() { tiles_.clear(); }

  const TileLattice<Dim>& lattice() const { return lattice_; }
  std::span<const Tile> tiles() const { return tiles_; }
  const std::vector<std::int32_t>& order() const { return order_; }
  std::size_t slots() const { return order_.size(); }
  std::int32_t end_of_slots(std::size_t tile) const {
    return (tiles_[tile].end + group_size - 1) / group_size * group_size;
  }
  // Up to the end of its last group.
  std::int32_t slots_of(std::size_t tile) const { return end_of_slots(tile) - tiles_[tile].begin; }
  const TileCoordinates<Dim>& coordinates(std::size_t tile) const { return coordinates_[tile]; }

  const std::vector<TileCoordinates<Dim>>& all_coordinates() const { return coordinates_; }

  // First slots of the columns of each tile, and one more per tile for their end. Columns run in a meander through the
  // tile, so that consecutive ones touch.
  const std::vector<std::int32_t>& all_columns() const { return columns_; }
  // Corners of the box around each cluster, m from its tile's centre; no box around none.
  const std::array<AlignedVector<float>, Dim>& low() const { return low_; }
  const std::array<AlignedVector<float>, Dim>& high() const { return high_; }

  // The tile with these coordinates, -1 if no particle is there.
  std::int32_t find(const TileCoordinates<Dim>& coordinates) const;
  // Puts the boxes around a tile's clusters where its particles are now.
  void bound_clusters(const Positions<Dim>& positions, std::size_t tile);
  // For each tile of `around`, in the order of codes, the tile here or -1.
  std::vector<std::int32_t> adjacent(const Tiling& around, ThreadPool& pool) const;

 private:
  // Particles in consecutive slots that lie in one tile: most of a tile stays together from one sort to the next.
  struct Run {
    std::uint64_t key;  // of the tile, later its number
    std::int32_t first;
    std::int32_t count;
  };
  // Appends the runs among the slots [begin, end), which begin a group. `key_here`: of the tile that these slots were
  // sorted into, if they were.
  void find_runs(const Positions<Dim>& positions, std::size_t begin, std::size_t end, const std::uint64_t* key_here,
                 std::vector<Run>& runs) const;
  void make_directory(std::vector<std::vector<Run>>& runs_of_chunks, ThreadPool& pool);
  Vec<Dim> half_edges() const;  // m, of a tile
  void sort_tile(const Positions<Dim>& positions, std::size_t tile);

  TileLattice<Dim> lattice_;
  std::vector<std::uint64_t> keys_;  // of the tiles, ascending
  std::vector<TileCoordinates<Dim>> coordinates_;
  std::vector<Tile> tiles_;
  std::vector<std::int32_t> order_;
  std::vector<std::int32_t> columns_;
  std::array<AlignedVector<float>, Dim> low_;
  std::array<AlignedVector<float>, Dim> high_;
  std::vector<Run> runs_;               // by tile, within a tile in the order before the sort
  std::vector<std::size_t> first_run_;  // of each tile, and one more
  Positions<Dim> spare_;                // where the sorted places are made
};

extern template class Tiling<2>;
extern template class Tiling<3>;

}  // namespace weir
