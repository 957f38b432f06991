#include "sph/neighbours.h"

#include <algorithm>
#include <numeric>

#include "core/parallel.h"
#include "core/trace.h"

namespace weir {

namespace {

template <int Dim>
TilesView<Dim> view_of(const Tiling<Dim>& tiling, const Positions<Dim>& positions,
                       const std::vector<std::int32_t>& adjacent, const DisplacementBox<Dim>* moved) {
  TilesView<Dim> view;
  view.tiles = tiling.tiles().data();
  view.tile_count = static_cast<std::int32_t>(tiling.tiles().size());
  for (int d = 0; d < Dim; ++d) {
    view.x[d] = positions.x[d].data();
    view.low[d] = tiling.low()[d].data();
    view.high[d] = tiling.high()[d].data();
  }
  view.columns = tiling.all_columns().data();
  view.coordinates = tiling.all_coordinates().data();
  view.adjacent = adjacent.data();
  view.moved = moved;
  return view;
}

// Sorting costs as much as making lists, and lists of clusters that have lost their shape are longer: sort when so many
// have been made since, per tile.
constexpr double lists_per_sort = 4;

// Of the largest distance by which any particle of one box came closer to any of another.
template <int Dim>
float closer_squared(const DisplacementBox<Dim>& a, const DisplacementBox<Dim>& b) {
  float sum = 0;
  for (int d = 0; d < Dim; ++d) {
    const float closer = std::max(a.greatest[d] - b.least[d], b.greatest[d] - a.least[d]);
    sum += closer * closer;
  }
  return sum;
}

}  // namespace

template <int Dim>
Neighbours<Dim>::Neighbours(const Settings& settings, ThreadPool& pool, WallParticles<Dim>& walls)
    : settings_(settings),
      list_pairs_(loops_for<Dim>(settings.instruction_set, Terms{}).list_pairs),
      pool_(pool),
      fluid_tiling_(
          TileLattice<Dim>(settings.particle_spacing, settings.support_radius + settings.skin, settings.particles)),
      wall_tiling_(fluid_tiling_.lattice()) {
  wall_tiling_.sort(walls, pool);
}

template <int Dim>
void Neighbours<Dim>::follow(std::size_t tile, const DisplacementBox<Dim>& moved) {
  moved_[tile].least += moved.least;
  moved_[tile].greatest += moved.greatest;
}

template <int Dim>
void Neighbours<Dim>::update(FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls) {
  std::vector<std::int32_t> tiles;
  if (sorted_ && !far_from_columns()) {
    tiles = wrong_tiles();
    if (tiles.empty()) return;
    const auto lists = static_cast<double>(listed_tiles_ - listed_before_sort_) + static_cast<double>(tiles.size());
    sorted_ = lists <= (1 + lists_per_sort) * static_cast<double>(moved_.size());
  } else {
    sorted_ = false;
  }
  if (sorted_) {
    bound_clusters_around(tiles, fluid);
  } else {
    sort(fluid);
    tiles.resize(fluid_tiling_.tiles().size());
    std::iota(tiles.begin(), tiles.end(), 0);
  }
  list(tiles, fluid, walls);
}

template <int Dim>
void Neighbours<Dim>::sort(FluidParticles<Dim>& fluid) {
  const Span span("sort");
  fluid_tiling_.sort(fluid, pool_);
  fluid.follow(fluid_tiling_, pool_);
  fluid_beside_ = fluid_tiling_.adjacent(fluid_tiling_, pool_);
  walls_beside_ = wall_tiling_.adjacent(fluid_tiling_, pool_);
  const std::size_t tiles = fluid_tiling_.tiles().size();
  lists_.fluid.resize(tiles);
  lists_.walls.resize(tiles);
  near_lists_.fluid.resize(tiles);
  near_lists_.walls.resize(tiles);
  moved_.assign(tiles, {});
  moved_then_.resize(tiles * tile_codes<Dim>);
  sorted_ = true;
  ++sorts_;
  listed_before_sort_ = listed_tiles_;
}

// Only adjacent tiles are looked at: two that have one between them must not come within reach of each other. Nor do
// places far from their tile's centre have all their digits.
template <int Dim>
bool Neighbours<Dim>::far_from_columns() const {
  const double reach = settings_.support_radius + settings_.skin;
  const auto limit = static_cast<float>(0.5 * (fluid_tiling_.lattice().edge() - reach));
  return std::any_of(moved_.begin(), moved_.end(), [limit](const DisplacementBox<Dim>& moved) {
    for (int d = 0; d < Dim; ++d) {
      if (!(moved.greatest[d] <= limit && moved.least[d] >= -limit)) return true;
    }
    return false;
  });
}

template <int Dim>
bool Neighbours<Dim>::still_right(std::size_t tile) const {
  // Sums of floats: allow for their rounding.
  constexpr double safe = 0.999;
  const auto limit = static_cast<float>(safe * settings_.skin * settings_.skin);
  const std::size_t around = tile * tile_codes<Dim>;
  const DisplacementBox<Dim> own = moved_[tile] - moved_then_[around + own_tile_code<Dim>];
  for (std::size_t k = around; k < around + tile_codes<Dim>; ++k) {
    if (fluid_beside_[k] >= 0) {
      const DisplacementBox<Dim> other = moved_[static_cast<std::size_t>(fluid_beside_[k])] - moved_then_[k];
      if (!(closer_squared(own, other) <= limit)) return false;
    }
    if (walls_beside_[k] >= 0 && !(closer_squared(own, {}) <= limit)) return false;
  }
  return true;
}

template <int Dim>
std::vector<std::int32_t> Neighbours<Dim>::wrong_tiles() const {
  std::vector<std::uint8_t> wrong(moved_.size());
  parallel_blocks(wrong.size(), pool_, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t tile = begin; tile < end; ++tile) wrong[tile] = still_right(tile) ? 0 : 1;
  });
  std::vector<std::int32_t> tiles;
  for (std::size_t tile = 0; tile < wrong.size(); ++tile) {
    if (wrong[tile] != 0) tiles.push_back(static_cast<std::int32_t>(tile));
  }
  return tiles;
}

template <int Dim>
void Neighbours<Dim>::bound_clusters_around(const std::vector<std::int32_t>& tiles, const FluidParticles<Dim>& fluid) {
  std::vector<std::uint8_t> near(moved_.size());
  for (const std::int32_t tile : tiles) {
    const std::size_t around = static_cast<std::size_t>(tile) * tile_codes<Dim>;
    for (std::size_t k = around; k < around + tile_codes<Dim>; ++k) {
      if (fluid_beside_[k] >= 0) near[static_cast<std::size_t>(fluid_beside_[k])] = 1;
    }
  }
  pool_.for_each(near.size(), [&](std::size_t tile) {
    if (near[tile] != 0) fluid_tiling_.bound_clusters(fluid, tile);
  });
}

template <int Dim>
void Neighbours<Dim>::list(const std::vector<std::int32_t>& tiles, const FluidParticles<Dim>& fluid,
                           const WallParticles<Dim>& walls) {
  const Span span("lists");
  ListInput<Dim> input;
  input.fluid = view_of(fluid_tiling_, fluid, fluid_beside_, moved_.data());
  input.walls = view_of<Dim>(wall_tiling_, walls, walls_beside_, nullptr);
  input.reach = static_cast<float>(settings_.support_radius + settings_.skin);
  input.edge = static_cast<float>(fluid_tiling_.lattice().edge());
  input.columns = fluid_tiling_.lattice().columns();
  input.all_pairs = settings_.search == NeighbourSearch::naive;
  pool_.for_each(tiles.size(), [&](std::size_t k) {
    thread_local IntBuffer scratch;
    const auto tile = static_cast<std::size_t>(tiles[k]);
    list_pairs_(input, tiles[k], lists_.fluid[tile], lists_.walls[tile], scratch);
    const std::size_t around = tile * tile_codes<Dim>;
    for (std::size_t code = around; code < around + tile_codes<Dim>; ++code) {
      if (fluid_beside_[code] >= 0) moved_then_[code] = moved_[static_cast<std::size_t>(fluid_beside_[code])];
    }
  });
  listed_tiles_ += static_cast<std::int64_t>(tiles.size());
}

template <int Dim>
PairInput<Dim> Neighbours<Dim>::pairs(const FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls) const {
  PairInput<Dim> input;
  input.tiles = fluid_tiling_.tiles().data();
  for (int d = 0; d < Dim; ++d) {
    input.x[d] = fluid.x[d].data();
    input.wall_x[d] = walls.x[d].data();
  }
  input.fluid_lists = lists_.fluid.data();
  input.wall_lists = lists_.walls.data();
  input.edge = static_cast<float>(fluid_tiling_.lattice().edge());
  return input;
}

template <int Dim>
PairInput<Dim> Neighbours<Dim>::near_pairs(const FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls) const {
  PairInput<Dim> input = pairs(fluid, walls);
  input.fluid_lists = near_lists_.fluid.data();
  input.wall_lists = near_lists_.walls.data();
  return input;
}

template class Neighbours<2>;
template class Neighbours<3>;

}  // namespace weir
