// Positions to more digits than a float has, in floats.
//
// Space is divided into tiles. A particle stands in a slot; the slots of a tile follow each other, and the tile is filled
// up to a whole number of groups. A position is kept relative to the centre of its tile, as a float and the rounding error
// of that float (its compensation): pairs need the first alone, whose error is at most 1e-6 particle spacings however large
// the domain, and many small steps lose nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/aligned.h"
#include "core/types.h"

namespace weir {

constexpr std::int32_t cluster_size = 4;  // slots that the pair engine takes as one neighbour
constexpr std::int32_t group_size = 16;   // slots that share a tile; tiles are padded to whole groups

// The position of an empty slot: too far from everything to be anything's neighbour.
constexpr float nowhere = 1e12F;

template <int Dim>
struct Positions {
  std::array<AlignedVector<float>, Dim> x;             // m, from the tile's centre
  std::array<AlignedVector<float>, Dim> compensation;  // m, what x lacks
  AlignedVector<std::int32_t> id;        // the particle's number in the scene's order; -1 in an empty slot
  std::vector<Vec<Dim, double>> center;  // of the tile, m; per group
  // How often a particle has gone round a periodic axis, less often backwards; empty along other axes.
  std::array<std::vector<std::int32_t>, Dim> rounds;

  std::size_t slots() const { return id.size(); }
  bool empty(std::size_t slot) const { return id[slot] < 0; }

  // m, in the frame of the scene's origin; within the domain along periodic axes.
  Vec<Dim, double> position(std::size_t slot) const {
    Vec<Dim, double> at = center[slot / group_size];
    for (int d = 0; d < Dim; ++d) {
      at[d] += static_cast<double>(x[d][slot]) + static_cast<double>(compensation[d][slot]);
    }
    return at;
  }

  // m; went on where it left the domain.
  Vec<Dim, double> unwrapped_position(std::size_t slot, const Vec<Dim, double>& period) const {
    Vec<Dim, double> at = position(slot);
    for (int d = 0; d < Dim; ++d) {
      if (!rounds[d].empty()) at[d] += period[d] * rounds[d][slot];
    }
    return at;
  }

  void resize(std::size_t slots) {
    for (auto& each : x) each.resize(slots + group_size);  // the slack that whole registers may read
    for (auto& each : compensation) each.resize(slots + group_size);
    id.resize(slots);
    center.resize(slots / group_size);
  }

  void set_from_center(std::size_t slot, const Vec<Dim, double>& from_center) {
    for (int d = 0; d < Dim; ++d) {
      x[d][slot] = static_cast<float>(from_center[d]);
      compensation[d][slot] = static_cast<float>(from_center[d] - static_cast<double>(x[d][slot]));
    }
  }
  void clear(std::size_t slot) {
    for (int d = 0; d < Dim; ++d) {
      x[d][slot] = nowhere;
      compensation[d][slot] = 0;
    }
    id[slot] = -1;
  }
};

// Points in the order of their numbers, all about one centre: positions before they are sorted.
template <int Dim>
Positions<Dim> unsorted(const std::vector<Vec<Dim, double>>& points) {
  Positions<Dim> positions;
  const std::size_t slots = (points.size() + group_size - 1) / group_size * group_size;
  positions.resize(slots);
  for (std::size_t slot = 0; slot < slots; ++slot) {
    if (slot < points.size()) {
      positions.set_from_center(slot, points[slot] - positions.center[slot / group_size]);
      positions.id[slot] = static_cast<std::int32_t>(slot);
    } else {
      positions.clear(slot);
    }
  }
  return positions;
}

}  // namespace weir
