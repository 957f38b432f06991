// The division of space into tiles, and which tile a point lies in.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/types.h"

namespace weir {

template <int Dim>
using TileCoordinates = std::array<std::int32_t, Dim>;

// The tiles around one, itself in the middle: codes count the last axis fastest.
template <int Dim>
constexpr int tile_codes = Dim == 2 ? 9 : 27;
template <int Dim>
constexpr int own_tile_code = tile_codes<Dim> / 2;
// -1, 0 or 1 along each axis.
template <int Dim>
constexpr TileCoordinates<Dim> offset_of_code(int code) {
  TileCoordinates<Dim> offset{};
  for (int d = Dim - 1; d >= 0; --d, code /= 3) offset[d] = code % 3 - 1;
  return offset;
}

// Where space repeats: along axes of a length that is not zero, from `start` on, m.
template <int Dim>
struct Periodicity {
  Vec<Dim, double> start{};
  Vec<Dim, double> length{};

  bool along(int axis) const { return length[axis] > 0; }
  bool any() const {
    for (int d = 0; d < Dim; ++d) {
      if (along(d)) return true;
    }
    return false;
  }
};

template <int Dim>
class TileLattice {
 public:
  // Tiles are at least `reach` (m) wide, so that only adjacent ones hold neighbours, and narrower for few particles, so
  // that there are enough tiles to share among threads. A periodic axis must be at least `reach` long.
  TileLattice(double particle_spacing, double reach, std::size_t particles, const Periodicity<Dim>& periodic = {});

  // m. A float with few digits, so that positions are shifted from tile to tile without rounding; along a periodic axis a
  // whole fraction of its length, whose shift is rounded to 2^-24 of 32 spacings, 2e-6 spacings.
  double edge(int axis) const { return edge_[axis]; }
  double least_edge() const;
  // Columns along each axis but the last, about two spacings wide.
  std::int32_t columns() const { return columns_; }
  // Layers that a column is sorted into, about half a spacing high.
  std::int32_t layers() const { return layers_; }
  std::int32_t columns_of_tile() const { return Dim == 2 ? columns_ : columns_ * columns_; }
  const Periodicity<Dim>& periodic() const { return periodic_; }

  // Periodic axes wrap. Throws std::range_error for a point farther than 2^20 tiles from the origin, or not finite.
  TileCoordinates<Dim> tile_at(const Vec<Dim, double>& point) const;
  Vec<Dim, double> center(const TileCoordinates<Dim>& tile) const;
  // The image of a point that lies in the domain; a particle may be somewhat outside until it is sorted.
  Vec<Dim, double> in_domain(Vec<Dim, double> point) const;
  // The coordinates after a step from tile to tile.
  TileCoordinates<Dim> wrapped(TileCoordinates<Dim> tile) const;
  // Replaces a distance from a tile's centre by that of the nearest image. Returns how many lengths were taken off.
  std::array<std::int32_t, Dim> to_nearest_image(Vec<Dim, double>& from_center) const;

 private:
  Vec<Dim, double> edge_;
  Periodicity<Dim> periodic_;
  TileCoordinates<Dim> tiles_{};  // along periodic axes
  std::int32_t columns_;
  std::int32_t layers_;
};

constexpr int tile_coordinate_bits = 21;
constexpr std::int32_t tile_coordinate_limit = 1 << (tile_coordinate_bits - 1);

extern template class TileLattice<2>;
extern template class TileLattice<3>;

}  // namespace weir
