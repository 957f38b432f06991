#include "sph/neighbours.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "sph/engine/engine.h"

namespace weir {

namespace {

template <int Dim>
TilesView<Dim> view_of(const Tiling<Dim>& tiling, const Places<Dim>& places,
                       const std::vector<std::int32_t>& adjacent) {
  TilesView<Dim> view;
  view.tiles = tiling.tiles().data();
  view.tile_count = static_cast<std::int32_t>(tiling.tiles().size());
  for (int d = 0; d < Dim; ++d) {
    view.x[d] = places.x[d].data();
    view.low[d] = tiling.low()[d].data();
    view.high[d] = tiling.high()[d].data();
  }
  view.columns = tiling.all_columns().data();
  view.coordinates = tiling.all_coordinates().data();
  view.adjacent = adjacent.data();
  return view;
}

}  // namespace

template <int Dim>
Neighbours<Dim>::Neighbours(const Settings& settings, Team& team, WallParticles<Dim>& walls)
    : settings_(settings),
      team_(team),
      fluid_tiling_(TileLattice<Dim>(settings.particle_spacing, settings.support_radius + settings.skin)),
      wall_tiling_(fluid_tiling_.lattice()) {
  wall_tiling_.sort(walls, team);
}

template <int Dim>
bool Neighbours<Dim>::still_right(const Displacements<Dim>& moved) const {
  if (!made_) return false;
  // Places far from the centre of their tile would lose digits.
  const double half_edge = 0.5 * fluid_tiling_.lattice().edge();
  if (static_cast<double>(moved.longest_squared) > half_edge * half_edge) return false;
  // Two particles come closer by at most the difference of their displacements: by the diagonal of the box that all
  // displacements lie in, and by twice the longest. Walls do not move.
  double diagonal_squared = 0;
  for (int d = 0; d < Dim; ++d) {
    double least = moved.least[d];
    double greatest = moved.greatest[d];
    if (!wall_tiling_.tiles().empty()) {
      least = std::min(least, 0.0);
      greatest = std::max(greatest, 0.0);
    }
    diagonal_squared += (greatest - least) * (greatest - least);
  }
  const double closer_squared = std::min(diagonal_squared, 4.0 * static_cast<double>(moved.longest_squared));
  // Displacements are differences of floats: allow for their rounding.
  constexpr double safe = 0.999;
  return closer_squared <= safe * settings_.skin * settings_.skin;
}

template <int Dim>
void Neighbours<Dim>::update(FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls,
                             const Displacements<Dim>& moved) {
  if (!still_right(moved)) rebuild(fluid, walls);
}

template <int Dim>
void Neighbours<Dim>::rebuild(FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls) {
  ++rebuilds_;
  fluid_tiling_.sort(fluid, team_);
  fluid.follow(fluid_tiling_, team_);

  const std::vector<std::int32_t> fluid_beside = fluid_tiling_.adjacent(fluid_tiling_, team_);
  const std::vector<std::int32_t> walls_beside = wall_tiling_.adjacent(fluid_tiling_, team_);
  ListInput<Dim> input;
  input.fluid = view_of(fluid_tiling_, fluid, fluid_beside);
  input.walls = view_of(wall_tiling_, walls, walls_beside);
  input.reach = static_cast<float>(settings_.support_radius + settings_.skin);
  input.edge = static_cast<float>(fluid_tiling_.lattice().edge());
  input.columns = fluid_tiling_.lattice().columns();
  input.all_pairs = settings_.search == NeighbourSearch::naive;

  const std::size_t tiles = fluid_tiling_.tiles().size();
  lists_.fluid.resize(tiles);
  lists_.walls.resize(tiles);
  for (int d = 0; d < Dim; ++d) start_[d].resize(fluid.x[d].size());
  const ListPairs<Dim> list_pairs = loops_for<Dim>(settings_.instruction_set, Terms{}).list_pairs;
  team_.for_each(tiles, [&](std::size_t tile) {
    thread_local IntBuffer scratch;
    list_pairs(input, static_cast<std::int32_t>(tile), lists_.fluid[tile], lists_.walls[tile], scratch);
    const auto begin = fluid_tiling_.tiles()[tile].begin;
    const auto end = fluid_tiling_.end_of_slots(tile);
    for (int d = 0; d < Dim; ++d) {
      std::copy(fluid.x[d].begin() + begin, fluid.x[d].begin() + end, start_[d].begin() + begin);
    }
  });
  made_ = true;
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

template class Neighbours<2>;
template class Neighbours<3>;

}  // namespace weir
