#include "sph/tile_lattice.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace weir {

namespace {

// The nearest number of at most 12 significant bits that is not smaller.
double with_few_digits(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return std::ldexp(std::ceil(std::ldexp(fraction, 12)), exponent - 12);
}

}  // namespace

template <int Dim>
TileLattice<Dim>::TileLattice(double particle_spacing, double reach, std::size_t particles,
                              const Periodicity<Dim>& periodic)
    : periodic_(periodic) {
  // Large enough that few pairs lie between tiles, small enough that there are many to share among threads.
  constexpr std::size_t few = Dim == 2 ? 12'000 : 50'000;
  const double spacings_per_tile = (Dim == 2 ? 32 : 16) / (particles < few ? 2 : 1);
  const double wanted = with_few_digits(std::max(spacings_per_tile * particle_spacing, reach));
  for (int d = 0; d < Dim; ++d) {
    edge_[d] = wanted;
    if (!periodic.along(d)) continue;
    tiles_[d] = std::max(1, static_cast<std::int32_t>(periodic.length[d] / wanted));
    edge_[d] = periodic.length[d] / tiles_[d];
  }
  columns_ = std::max(1, static_cast<std::int32_t>(std::lround(wanted / (2 * particle_spacing))));
  layers_ = 4 * columns_;
}

template <int Dim>
double TileLattice<Dim>::least_edge() const {
  return *std::min_element(edge_.e, edge_.e + Dim);
}

template <int Dim>
TileCoordinates<Dim> TileLattice<Dim>::tile_at(const Vec<Dim, double>& point) const {
  TileCoordinates<Dim> tile;
  for (int d = 0; d < Dim; ++d) {
    double number = std::floor((point[d] - periodic_.start[d]) / edge_[d]);
    if (periodic_.along(d)) number -= std::floor(number / tiles_[d]) * tiles_[d];
    if (!(std::abs(number) < tile_coordinate_limit)) {  // written so that NaN is caught, too
      throw std::range_error(
          "a particle has flown too far to be sorted (more than 2^20 tiles of space from the origin)");
    }
    tile[d] = static_cast<std::int32_t>(number);
  }
  return tile;
}

template <int Dim>
Vec<Dim, double> TileLattice<Dim>::center(const TileCoordinates<Dim>& tile) const {
  Vec<Dim, double> at{};
  for (int d = 0; d < Dim; ++d) at[d] = periodic_.start[d] + (tile[d] + 0.5) * edge_[d];
  return at;
}

template <int Dim>
Vec<Dim, double> TileLattice<Dim>::in_domain(Vec<Dim, double> point) const {
  for (int d = 0; d < Dim; ++d) {
    if (!periodic_.along(d)) continue;
    point[d] -= std::floor((point[d] - periodic_.start[d]) / periodic_.length[d]) * periodic_.length[d];
  }
  return point;
}

template <int Dim>
TileCoordinates<Dim> TileLattice<Dim>::wrapped(TileCoordinates<Dim> tile) const {
  for (int d = 0; d < Dim; ++d) {
    if (periodic_.along(d)) tile[d] = (tile[d] + tiles_[d]) % tiles_[d];
  }
  return tile;
}

template <int Dim>
std::array<std::int32_t, Dim> TileLattice<Dim>::to_nearest_image(Vec<Dim, double>& from_center) const {
  std::array<std::int32_t, Dim> lengths{};
  for (int d = 0; d < Dim; ++d) {
    if (!periodic_.along(d)) continue;
    const double count = std::floor(from_center[d] / periodic_.length[d] + 0.5);
    from_center[d] -= count * periodic_.length[d];
    lengths[d] = static_cast<std::int32_t>(count);
  }
  return lengths;
}

template class TileLattice<2>;
template class TileLattice<3>;

}  // namespace weir
