#include "sph/neighbours.h"

namespace weir {

void NeighbourLists::resize(std::size_t particles) {
  blocks_.resize(block_count(particles));
  ends_.resize(particles);
}

void NeighbourLists::end_list(std::size_t b, std::size_t i) {
  ends_[i] = static_cast<std::uint32_t>(blocks_[b].size());
}

namespace {

// Appends the points of `ranges` within `reach` of x_i, but for point `self`, to `list`.
template <int Dim, class Ranges>
void append_near(const Vec<Dim, double>& x_i, const std::vector<Vec<Dim, double>>& points, const Ranges& ranges,
                 double reach, std::int32_t self, std::vector<std::int32_t>& list) {
  for (const PointRange& range : ranges) {
    for (std::int32_t j = range.begin; j < range.end; ++j) {
      const Vec<Dim, double> x_ij = x_i - points[j];
      if (dot(x_ij, x_ij) < reach * reach && j != self) list.push_back(j);
    }
  }
}

}  // namespace

template <int Dim>
Neighbours<Dim>::Neighbours(const Settings& settings, Team& team, WallParticles<Dim>& walls)
    : settings_(settings), team_(team) {
  const std::vector<std::int32_t> order = wall_grid_.sort(walls.position, settings.support_radius + settings.skin);
  std::vector<Vec<Dim, double>> sorted;
  sorted.reserve(order.size());
  for (const std::int32_t k : order) sorted.push_back(walls.position[k]);
  walls.position.swap(sorted);
}

template <int Dim>
bool Neighbours<Dim>::still_right(const FluidParticles<Dim>& fluid) const {
  if (position_at_build_.size() != fluid.size()) return false;
  // Two particles come closer by at most twice the largest displacement since the lists were made.
  const double limit = 0.25 * settings_.skin * settings_.skin;
  return parallel_reduce(
      fluid.size(), team_, true,
      [&](std::size_t begin, std::size_t end) {
        bool near = true;
        for (std::size_t i = begin; i < end; ++i) {
          const Vec<Dim, double> moved = fluid.position[i] - position_at_build_[i];
          near = near && dot(moved, moved) <= limit;
        }
        return near;
      },
      [](bool a, bool b) { return a && b; });
}

template <int Dim>
void Neighbours<Dim>::update(FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls) {
  if (!still_right(fluid)) rebuild(fluid, walls);
}

template <int Dim>
void Neighbours<Dim>::rebuild(FluidParticles<Dim>& fluid, const WallParticles<Dim>& walls) {
  ++rebuilds_;
  const double reach = settings_.support_radius + settings_.skin;
  const bool naive = settings_.search == NeighbourSearch::naive;
  if (!naive) fluid.reorder(fluid_grid_.sort(fluid.position, reach), team_);
  position_at_build_ = fluid.position;

  fluid_lists_.resize(fluid.size());
  wall_lists_.resize(fluid.size());
  parallel_blocks(fluid.size(), team_, [&](std::size_t b, std::size_t begin, std::size_t end) {
    std::vector<std::int32_t>& near_fluid = fluid_lists_.block(b);
    std::vector<std::int32_t>& near_walls = wall_lists_.block(b);
    near_fluid.clear();
    near_walls.clear();
    typename CellGrid<Dim>::Cell cell{};
    std::array<PointRange, CellGrid<Dim>::rows> fluid_ranges{};
    std::array<PointRange, CellGrid<Dim>::rows> wall_ranges{};
    if (naive) {
      fluid_ranges[0] = {0, static_cast<std::int32_t>(fluid.size())};
      wall_ranges[0] = {0, static_cast<std::int32_t>(walls.size())};
    }
    for (std::size_t i = begin; i < end; ++i) {
      const Vec<Dim, double>& x_i = fluid.position[i];
      if (!naive) {
        // Both grids have the same cells; particles of one cell stand together.
        const auto own_cell = fluid_grid_.cell_of(x_i);
        if (i == begin || own_cell != cell) {
          cell = own_cell;
          fluid_ranges = fluid_grid_.neighbourhood(cell);
          wall_ranges = wall_grid_.neighbourhood(cell);
        }
      }
      append_near<Dim>(x_i, fluid.position, fluid_ranges, reach, static_cast<std::int32_t>(i), near_fluid);
      append_near<Dim>(x_i, walls.position, wall_ranges, reach, -1, near_walls);
      fluid_lists_.end_list(b, i);
      wall_lists_.end_list(b, i);
    }
  });
}

template class Neighbours<2>;
template class Neighbours<3>;

}  // namespace weir
