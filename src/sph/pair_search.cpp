#include "sph/pair_search.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "core/parallel.h"
#include "core/stopwatch.h"
#include "core/trace.h"

namespace weir {

namespace {

// Sorting costs as much as building lists, and lists of clusters that have lost their shape are longer: sort when so many
// have been built since, per tile.
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

template <int Dim>
TilesView<Dim> view_of(const Tiling<Dim>& tiling, const Positions<Dim>& positions, const DisplacementBox<Dim>* moved) {
  TilesView<Dim> view;
  view.tiles = tiling.tiles().data();
  for (int d = 0; d < Dim; ++d) {
    view.x[d] = positions.x[d].data();
    view.low[d] = tiling.low()[d].data();
    view.high[d] = tiling.high()[d].data();
  }
  view.columns = tiling.all_columns().data();
  view.moved = moved;
  return view;
}

std::vector<std::int32_t> all_tiles(std::size_t count) {
  std::vector<std::int32_t> tiles(count);
  std::iota(tiles.begin(), tiles.end(), 0);
  return tiles;
}

}  // namespace

template <int Dim>
PairSearch<Dim>::PairSearch(const Settings& settings, ThreadPool& pool)
    : settings_(settings),
      pool_(pool),
      lattice_(settings.particle_spacing, settings.support_radius + settings.skin, settings.particles,
               settings.periodic),
      listers_(listers_for<Dim>(settings.instruction_set)) {}

template <int Dim>
void PairSearch<Dim>::add(ParticleSet<Dim>& set, Mobility mobility) {
  members_.push_back({.set = &set,
                      .moving = mobility == Mobility::moving,
                      .tiling = Tiling<Dim>(lattice_),
                      .moved = {},
                      .moved_when_listed = {},
                      .pairs = {}});
  if (mobility == Mobility::fixed) sort(members_.back());
}

template <int Dim>
void PairSearch<Dim>::list(const ParticleSet<Dim>& target, const ParticleSet<Dim>& source) {
  member(target).pairs.push_back({.source = &member(source), .lists = {}, .adjacent = {}, .source_moved = {}});
  expire();
}

template <int Dim>
const typename PairSearch<Dim>::Member& PairSearch<Dim>::member(const ParticleSet<Dim>& set) const {
  const auto found = std::find_if(members_.begin(), members_.end(), [&](const Member& m) { return m.set == &set; });
  if (found == members_.end()) throw std::logic_error("a set that the search does not know");
  return *found;
}

template <int Dim>
const typename PairSearch<Dim>::Pair& PairSearch<Dim>::pair(const ParticleSet<Dim>& target,
                                                            const ParticleSet<Dim>& source) const {
  for (const Pair& each : member(target).pairs) {
    if (each.source->set == &source) return each;
  }
  throw std::logic_error("a pair of sets that was not asked for");
}

template <int Dim>
void PairSearch<Dim>::follow(const ParticleSet<Dim>& set, std::size_t tile, const DisplacementBox<Dim>& moved) {
  member(set).moved[tile] += moved;
}

template <int Dim>
void PairSearch<Dim>::expire() {
  for (Member& each : members_) {
    if (each.moving) each.sorted = false;
  }
}

template <int Dim>
void PairSearch<Dim>::forget() {
  expire();
  for (Member& each : members_) {
    if (each.moving) each.tiling.forget();
  }
}

template <int Dim>
void PairSearch<Dim>::update() {
  const Stopwatch watch;
  const Span span("neighbours");
  rebuild();
  seconds_ += watch.seconds();
}

template <int Dim>
void PairSearch<Dim>::rebuild() {
  for (Member& each : members_) each.just_sorted = false;
  for (Member& each : members_) {
    if (each.moving && must_sort(each)) sort(each);
  }
  for (Member& each : members_) {
    const bool met = each.just_sorted || std::any_of(each.pairs.begin(), each.pairs.end(),
                                                     [](const Pair& pair) { return pair.source->just_sorted; });
    if (met) meet(each);
    if (met) {
      each.stale = all_tiles(each.tiling.tiles().size());
    } else if (!each.moving) {
      each.stale = stale_tiles(each);
    }
    if (each.stale.empty()) continue;
    bound_clusters_around(each, each.stale);
    build(each, each.stale);
  }
}

template <int Dim>
bool PairSearch<Dim>::must_sort(Member& member) const {
  if (!member.sorted || far_from_columns(member)) return true;
  member.stale = stale_tiles(member);
  const auto lists =
      static_cast<double>(member.listed_tiles - member.listed_before_sort) + static_cast<double>(member.stale.size());
  return lists > (1 + lists_per_sort) * static_cast<double>(member.moved.size());
}

template <int Dim>
void PairSearch<Dim>::sort(Member& member) {
  const Span span("sort");
  member.tiling.sort(*member.set, pool_);
  member.set->follow(member.tiling, pool_);
  member.moved.assign(member.tiling.tiles().size(), {});
  member.sorted = true;
  member.just_sorted = true;
  ++member.sorts;
  member.listed_before_sort = member.listed_tiles;
}

// Which tiles of its sources lie around each tile of the target.
template <int Dim>
void PairSearch<Dim>::meet(Member& target) {
  const std::size_t tiles = target.tiling.tiles().size();
  target.moved_when_listed.resize(tiles);
  for (Pair& each : target.pairs) {
    each.adjacent = each.source->tiling.adjacent(target.tiling, pool_);
    each.source_moved.resize(tiles * tile_codes<Dim>);
    each.lists.listed.resize(tiles);
    each.lists.pruned.resize(tiles);
  }
}

// Only adjacent tiles are looked at: two that have one between them must not come within reach of each other. Nor do
// positions far from their tile's centre have all their digits.
template <int Dim>
bool PairSearch<Dim>::far_from_columns(const Member& member) const {
  const double reach = settings_.support_radius + settings_.skin;
  float limit[Dim];
  for (int d = 0; d < Dim; ++d) limit[d] = static_cast<float>(0.5 * (lattice_.edge(d) - reach));
  return std::any_of(member.moved.begin(), member.moved.end(), [&limit](const DisplacementBox<Dim>& moved) {
    for (int d = 0; d < Dim; ++d) {
      if (!(moved.greatest[d] <= limit[d] && moved.least[d] >= -limit[d])) return true;
    }
    return false;
  });
}

template <int Dim>
bool PairSearch<Dim>::still_valid(const Member& member, std::size_t tile) const {
  // Sums of floats: allow for their rounding.
  constexpr double safe = 0.999;
  const auto limit = static_cast<float>(safe * settings_.skin * settings_.skin);
  const std::size_t around = tile * tile_codes<Dim>;
  const DisplacementBox<Dim> own = member.moved[tile] - member.moved_when_listed[tile];
  for (const Pair& each : member.pairs) {
    for (std::size_t k = around; k < around + tile_codes<Dim>; ++k) {
      if (each.adjacent[k] < 0) continue;
      DisplacementBox<Dim> other;
      if (each.source->moving) {
        other = each.source->moved[static_cast<std::size_t>(each.adjacent[k])] - each.source_moved[k];
      }
      if (!(closer_squared(own, other) <= limit)) return false;
    }
  }
  return true;
}

template <int Dim>
std::vector<std::int32_t> PairSearch<Dim>::stale_tiles(const Member& member) const {
  std::vector<std::int32_t> tiles;
  if (member.pairs.empty()) return tiles;
  std::vector<std::uint8_t> stale(member.tiling.tiles().size());
  parallel_blocks(stale.size(), pool_, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t tile = begin; tile < end; ++tile) stale[tile] = still_valid(member, tile) ? 0 : 1;
  });
  for (std::size_t tile = 0; tile < stale.size(); ++tile) {
    if (stale[tile] != 0) tiles.push_back(static_cast<std::int32_t>(tile));
  }
  return tiles;
}

// Boxes of clusters of sets that move and were not just sorted, in these tiles and those of sources around them.
template <int Dim>
void PairSearch<Dim>::bound_clusters_around(const Member& target, const std::vector<std::int32_t>& tiles) {
  for (Member& each : members_) {
    if (!each.moving || each.just_sorted) continue;
    std::vector<std::uint8_t> near(each.tiling.tiles().size());
    for (const std::int32_t tile : tiles) {
      if (&each == &target) near[static_cast<std::size_t>(tile)] = 1;
      for (const Pair& pair : target.pairs) {
        if (pair.source != &each) continue;
        const std::size_t around = static_cast<std::size_t>(tile) * tile_codes<Dim>;
        for (std::size_t k = around; k < around + tile_codes<Dim>; ++k) {
          if (pair.adjacent[k] >= 0) near[static_cast<std::size_t>(pair.adjacent[k])] = 1;
        }
      }
    }
    pool_.for_each(near.size(), [&](std::size_t tile) {
      if (near[tile] != 0) each.tiling.bound_clusters(*each.set, tile);
    });
  }
}

template <int Dim>
void PairSearch<Dim>::build(Member& target, const std::vector<std::int32_t>& tiles) {
  const Span span("lists");
  std::vector<ListInput<Dim>> inputs;
  for (const Pair& each : target.pairs) {
    ListInput<Dim> input;
    input.target = view_of<Dim>(target.tiling, *target.set, target.moving ? target.moved.data() : nullptr);
    input.source =
        view_of<Dim>(each.source->tiling, *each.source->set, each.source->moving ? each.source->moved.data() : nullptr);
    input.adjacent = each.adjacent.data();
    input.reach = static_cast<float>(settings_.support_radius + settings_.skin);
    for (int d = 0; d < Dim; ++d) input.edge[d] = static_cast<float>(lattice_.edge(d));
    input.columns = lattice_.columns();
    inputs.push_back(input);
  }
  pool_.for_each(tiles.size(), [&](std::size_t k) {
    thread_local IntBuffer scratch;
    const auto tile = static_cast<std::size_t>(tiles[k]);
    const std::size_t around = tile * tile_codes<Dim>;
    for (std::size_t p = 0; p < inputs.size(); ++p) {
      Pair& pair = target.pairs[p];
      const bool own = pair.source == &target;
      (own ? listers_.within : listers_.between)(inputs[p], tiles[k], pair.lists.listed[tile], scratch);
      if (!pair.source->moving) continue;
      for (std::size_t code = around; code < around + tile_codes<Dim>; ++code) {
        if (pair.adjacent[code] < 0) continue;
        pair.source_moved[code] = pair.source->moved[static_cast<std::size_t>(pair.adjacent[code])];
      }
    }
    target.moved_when_listed[tile] = target.moved[tile];
  });
  target.listed_tiles += static_cast<std::int64_t>(tiles.size());
}

template <int Dim>
const PairLists& PairSearch<Dim>::lists(const ParticleSet<Dim>& target, const ParticleSet<Dim>& source) const {
  return pair(target, source).lists;
}

template <int Dim>
PairInput<Dim> PairSearch<Dim>::pairs(const ParticleSet<Dim>& target, const ParticleSet<Dim>& source) {
  auto& found = const_cast<Pair&>(pair(target, source));
  PairInput<Dim> input;
  input.tiles = tiling(target).tiles().data();
  for (int d = 0; d < Dim; ++d) {
    input.x[d] = target.x[d].data();
    input.source_x[d] = source.x[d].data();
    input.edge[d] = static_cast<float>(lattice_.edge(d));
  }
  input.listed = found.lists.listed.data();
  input.pruned = found.lists.pruned.data();
  return input;
}

template <int Dim>
bool PairSearch<Dim>::near(const ParticleSet<Dim>& target, std::size_t tile) const {
  for (const Pair& each : member(target).pairs) {
    const std::size_t around = tile * tile_codes<Dim>;
    for (std::size_t k = around; k < around + tile_codes<Dim>; ++k) {
      if (each.adjacent[k] >= 0) return true;
    }
  }
  return false;
}

template class PairSearch<2>;
template class PairSearch<3>;

}  // namespace weir
