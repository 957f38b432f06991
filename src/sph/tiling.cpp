#include "sph/tiling.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "core/parallel.h"

namespace weir {

namespace {

// Slots that are looked at as one when particles are assigned to tiles; a whole number of groups.
constexpr std::size_t chunk_size = 4096;

constexpr int coordinate_bits = tile_coordinate_bits;
constexpr std::int32_t coordinate_limit = tile_coordinate_limit;

template <int Dim>
std::uint64_t key_of(const TileCoordinates<Dim>& tile) {
  std::uint64_t key = 0;
  for (int d = 0; d < Dim; ++d) key = key << coordinate_bits | static_cast<std::uint64_t>(tile[d] + coordinate_limit);
  return key;
}

template <int Dim>
TileCoordinates<Dim> tile_of(std::uint64_t key) {
  TileCoordinates<Dim> tile;
  for (int d = Dim - 1; d >= 0; --d, key >>= coordinate_bits) {
    tile[d] = static_cast<std::int32_t>(key & ((1U << coordinate_bits) - 1)) - coordinate_limit;
  }
  return tile;
}

}  // namespace

template <int Dim>
std::int32_t Tiling<Dim>::find(const TileCoordinates<Dim>& coordinates) const {
  for (const std::int32_t c : coordinates) {
    if (std::abs(c) >= coordinate_limit) return -1;
  }
  const std::uint64_t key = key_of<Dim>(coordinates);
  const auto at = std::lower_bound(keys_.begin(), keys_.end(), key);
  return at != keys_.end() && *at == key ? static_cast<std::int32_t>(at - keys_.begin()) : -1;
}

template <int Dim>
std::vector<std::int32_t> Tiling<Dim>::adjacent(const Tiling& around, ThreadPool& pool) const {
  constexpr int codes = tile_codes<Dim>;
  std::vector<std::int32_t> found(around.tiles_.size() * codes);
  parallel_blocks(around.tiles_.size(), pool, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t tile = begin; tile < end; ++tile) {
      for (int code = 0; code < codes; ++code) {
        TileCoordinates<Dim> at = around.coordinates_[tile];
        const TileCoordinates<Dim> offset = offset_of_code<Dim>(code);
        for (int d = 0; d < Dim; ++d) at[d] += offset[d];
        found[tile * codes + static_cast<std::size_t>(code)] = find(lattice_.wrapped(at));
      }
    }
  });
  return found;
}

template <int Dim>
Vec<Dim> Tiling<Dim>::half_edges() const {
  Vec<Dim> half{};
  for (int d = 0; d < Dim; ++d) half[d] = static_cast<float>(0.5 * lattice_.edge(d));
  return half;
}

template <int Dim>
void Tiling<Dim>::find_runs(const Positions<Dim>& positions, std::size_t begin, std::size_t end,
                            const std::uint64_t* key_here, std::vector<Run>& runs) const {
  std::int32_t expected = -1;  // slot that would continue the last run
  const auto append = [&](std::uint64_t key, std::size_t slot, std::int32_t count) {
    const auto here = static_cast<std::int32_t>(slot);
    if (here != expected || runs.back().key != key) runs.push_back({key, here, 0});
    runs.back().count += count;
    expected = here + count;
  };
  const Vec<Dim> half = half_edges();
  const auto inside = [&](std::size_t slot) {
    bool is = true;
    for (int d = 0; d < Dim; ++d) is &= positions.x[d][slot] >= -half[d] && positions.x[d][slot] < half[d];
    return is;
  };
  for (std::size_t group = begin; group < end; group += group_size) {
    if (key_here != nullptr) {
      // Most groups are where they were. An empty slot is nowhere, and thus outside.
      bool all = true;
      for (std::size_t slot = group; slot < group + group_size; ++slot) all &= inside(slot);
      if (all) {
        append(*key_here, group, group_size);
        continue;
      }
    }
    for (std::size_t slot = group; slot < std::min(group + group_size, end); ++slot) {
      if (positions.empty(slot)) continue;
      const bool stayed = key_here != nullptr && inside(slot);
      append(stayed ? *key_here : key_of<Dim>(lattice_.tile_at(positions.position(slot))), slot, 1);
    }
  }
}

template <int Dim>
void Tiling<Dim>::sort(Positions<Dim>& positions, ThreadPool& pool) {
  // Sorted before, it is looked at tile by tile: most particles are still in theirs.
  const bool sorted = !tiles_.empty();
  const std::size_t chunks = sorted ? tiles_.size() : (positions.slots() + chunk_size - 1) / chunk_size;
  std::vector<std::vector<Run>> runs_of_chunks(chunks);
  std::atomic<bool> flown{false};
  pool.for_each(chunks, [&](std::size_t chunk) {
    try {
      if (sorted) {
        const std::uint64_t key = keys_[chunk];
        find_runs(positions, static_cast<std::size_t>(tiles_[chunk].begin),
                  static_cast<std::size_t>(end_of_slots(chunk)), &key, runs_of_chunks[chunk]);
      } else {
        find_runs(positions, chunk * chunk_size, std::min(positions.slots(), (chunk + 1) * chunk_size), nullptr,
                  runs_of_chunks[chunk]);
      }
    } catch (const std::range_error&) {  // must not leave a thread of the pool
      flown = true;
    }
  });
  if (flown) {
    for (std::size_t slot = 0; slot < positions.slots(); ++slot) {
      if (!positions.empty(slot)) lattice_.tile_at(positions.position(slot));  // throws
    }
  }
  make_directory(runs_of_chunks, pool);

  const std::size_t slots = tiles_.empty() ? 0 : static_cast<std::size_t>(end_of_slots(tiles_.size() - 1));
  order_.resize(slots);
  columns_.resize(tiles_.size() * static_cast<std::size_t>(lattice_.columns_of_tile() + 1));
  spare_.resize(slots);
  for (int d = 0; d < Dim; ++d) {
    if (lattice_.periodic().along(d)) spare_.rounds[d].resize(slots);
  }
  for (int d = 0; d < Dim; ++d) {
    low_[d].resize(slots / cluster_size + group_size);
    high_[d].resize(slots / cluster_size + group_size);
  }
  pool.for_each(tiles_.size(), [&](std::size_t tile) {
    sort_tile(positions, tile);
    bound_clusters(spare_, tile);
  });
  std::swap(positions, spare_);
}

template <int Dim>
void Tiling<Dim>::make_directory(std::vector<std::vector<Run>>& runs_of_chunks, ThreadPool& pool) {
  // Tiles entered for the first time.
  std::vector<std::vector<std::uint64_t>> new_keys(runs_of_chunks.size());
  pool.for_each(runs_of_chunks.size(), [&](std::size_t chunk) {
    std::uint64_t last = ~std::uint64_t{0};
    for (const Run& run : runs_of_chunks[chunk]) {
      if (run.key == last) continue;
      last = run.key;
      if (!std::binary_search(keys_.begin(), keys_.end(), run.key)) new_keys[chunk].push_back(run.key);
    }
    std::sort(new_keys[chunk].begin(), new_keys[chunk].end());
    new_keys[chunk].erase(std::unique(new_keys[chunk].begin(), new_keys[chunk].end()), new_keys[chunk].end());
  });
  for (const auto& keys : new_keys) keys_.insert(keys_.end(), keys.begin(), keys.end());
  std::sort(keys_.begin(), keys_.end());
  keys_.erase(std::unique(keys_.begin(), keys_.end()), keys_.end());

  // Runs by tile: a counting sort, which keeps their order.
  pool.for_each(runs_of_chunks.size(), [&](std::size_t chunk) {
    std::uint64_t key = ~std::uint64_t{0};
    std::uint64_t place = 0;
    for (Run& run : runs_of_chunks[chunk]) {
      if (run.key != key) {
        key = run.key;
        place = static_cast<std::uint64_t>(std::lower_bound(keys_.begin(), keys_.end(), key) - keys_.begin());
      }
      run.key = place;
    }
  });
  std::vector<std::int64_t> particles(keys_.size());
  std::vector<std::size_t> next_run(keys_.size() + 1);
  std::size_t runs = 0;
  for (const auto& chunk : runs_of_chunks) {
    runs += chunk.size();
    for (const Run& run : chunk) {
      particles[run.key] += run.count;
      ++next_run[run.key + 1];
    }
  }
  for (std::size_t tile = 0; tile < keys_.size(); ++tile) next_run[tile + 1] += next_run[tile];
  runs_.resize(runs);
  for (const auto& chunk : runs_of_chunks) {
    for (const Run& run : chunk) runs_[next_run[run.key]++] = run;
  }

  // Tiles that lost their last particle are gone.
  tiles_.clear();
  coordinates_.clear();
  first_run_.assign(1, 0);
  std::int64_t slot = 0;
  std::size_t kept = 0;
  for (std::size_t tile = 0; tile < keys_.size(); ++tile) {
    if (particles[tile] == 0) continue;
    keys_[kept++] = keys_[tile];
    coordinates_.push_back(tile_of<Dim>(keys_[kept - 1]));
    tiles_.push_back({static_cast<std::int32_t>(slot), static_cast<std::int32_t>(slot + particles[tile])});
    first_run_.push_back(next_run[tile]);
    slot = (slot + particles[tile] + group_size - 1) / group_size * group_size;
    if (slot > std::numeric_limits<std::int32_t>::max()) {
      throw std::range_error("more than 2^31 slots of particles");
    }
  }
  keys_.resize(kept);
}

template <int Dim>
void Tiling<Dim>::sort_tile(const Positions<Dim>& positions, std::size_t tile) {
  const std::int32_t columns = lattice_.columns();
  const std::int32_t layers = lattice_.layers();
  const std::int32_t cells = lattice_.columns_of_tile() * layers;
  const Vec<Dim, double> center = lattice_.center(coordinates_[tile]);
  const Vec<Dim> half = half_edges();
  const auto number = [&](const Vec<Dim>& from_center, int d, std::int32_t parts) {
    const float share = (from_center[d] + half[d]) / (2 * half[d]);
    const auto part = static_cast<std::int32_t>(share * static_cast<float>(parts));
    return std::clamp(part, 0, parts - 1);
  };
  // Every second column runs down, every second row of columns back.
  const auto cell_at = [&](const Vec<Dim>& from_center) {
    std::int32_t column = number(from_center, 0, columns);
    if constexpr (Dim == 3) {
      const std::int32_t along = number(from_center, 1, columns);
      column = column * columns + (column % 2 == 0 ? along : columns - 1 - along);
    }
    const std::int32_t layer = number(from_center, Dim - 1, layers);
    return column * layers + (column % 2 == 0 ? layer : layers - 1 - layer);
  };
  const Tile slots = tiles_[tile];
  thread_local std::vector<std::int32_t> next_in_cell;
  thread_local std::vector<std::int32_t> cell_of;
  next_in_cell.assign(static_cast<std::size_t>(cells) + 1, 0);
  cell_of.resize(static_cast<std::size_t>(slots.end - slots.begin));
  const auto is_new = [&](const Run& run) {  // its positions count from another tile's centre
    const Vec<Dim, double>& from = positions.center[static_cast<std::size_t>(run.first) / group_size];
    for (int d = 0; d < Dim; ++d) {
      if (from[d] != center[d]) return true;
    }
    return false;
  };
  // Where a tile is its own neighbour, a particle may leave it and come in again on the other side.
  const bool periodic = lattice_.periodic().any();
  const auto outside = [&](std::size_t slot) {
    bool is = false;
    for (int d = 0; d < Dim; ++d) is |= !(positions.x[d][slot] >= -half[d] && positions.x[d][slot] < half[d]);
    return is;
  };
  std::size_t particle = 0;
  for (std::size_t r = first_run_[tile]; r < first_run_[tile + 1]; ++r) {
    const bool run_is_new = is_new(runs_[r]);
    for (std::int32_t k = 0; k < runs_[r].count; ++k) {
      const auto slot = static_cast<std::size_t>(runs_[r].first + k);
      const bool shifted = run_is_new || (periodic && outside(slot));
      Vec<Dim> from_center{};
      for (int d = 0; d < Dim; ++d) from_center[d] = positions.x[d][slot];
      if (shifted) {
        Vec<Dim, double> exact = positions.position(slot) - center;
        lattice_.to_nearest_image(exact);
        from_center = convert<float>(exact);
      }
      const std::int32_t cell = cell_at(from_center);
      cell_of[particle++] = cell;
      ++next_in_cell[static_cast<std::size_t>(cell) + 1];
    }
  }
  next_in_cell[0] = slots.begin;
  for (std::int32_t cell = 0; cell < cells; ++cell) {
    next_in_cell[static_cast<std::size_t>(cell) + 1] += next_in_cell[static_cast<std::size_t>(cell)];
  }
  std::int32_t* const starts = &columns_[tile * static_cast<std::size_t>(lattice_.columns_of_tile() + 1)];
  for (std::int32_t column = 0; column <= lattice_.columns_of_tile(); ++column) {
    starts[column] = next_in_cell[static_cast<std::size_t>(column * layers)];
  }
  thread_local std::vector<std::size_t> shifted_slots;
  shifted_slots.clear();
  particle = 0;
  for (std::size_t r = first_run_[tile]; r < first_run_[tile + 1]; ++r) {
    const bool run_is_new = is_new(runs_[r]);
    for (std::int32_t k = 0; k < runs_[r].count; ++k) {
      const bool shifted = run_is_new || (periodic && outside(static_cast<std::size_t>(runs_[r].first + k)));
      const auto to = static_cast<std::size_t>(next_in_cell[static_cast<std::size_t>(cell_of[particle++])]++);
      order_[to] = runs_[r].first + k;
      if (shifted) shifted_slots.push_back(to);
    }
  }

  const auto begin = static_cast<std::size_t>(slots.begin);
  const auto end = static_cast<std::size_t>(slots.end);
  const auto end_of_groups = static_cast<std::size_t>(end_of_slots(tile));
  for (std::size_t slot = begin; slot < end_of_groups; slot += group_size) spare_.center[slot / group_size] = center;
  for (int d = 0; d < Dim; ++d) {
    for (std::size_t slot = begin; slot < end; ++slot) {
      spare_.x[d][slot] = positions.x[d][static_cast<std::size_t>(order_[slot])];
      spare_.compensation[d][slot] = positions.compensation[d][static_cast<std::size_t>(order_[slot])];
    }
  }
  for (std::size_t slot = begin; slot < end; ++slot)
    spare_.id[slot] = positions.id[static_cast<std::size_t>(order_[slot])];
  for (int d = 0; d < Dim; ++d) {
    if (!lattice_.periodic().along(d)) continue;
    for (std::size_t slot = begin; slot < end; ++slot) {
      const auto from = static_cast<std::size_t>(order_[slot]);
      spare_.rounds[d][slot] = positions.rounds[d].empty() ? 0 : positions.rounds[d][from];
    }
  }
  for (const std::size_t slot : shifted_slots) {
    Vec<Dim, double> from_center = positions.position(static_cast<std::size_t>(order_[slot])) - center;
    const std::array<std::int32_t, Dim> rounds = lattice_.to_nearest_image(from_center);
    spare_.set_from_center(slot, from_center);
    for (int d = 0; d < Dim; ++d) {
      if (lattice_.periodic().along(d)) spare_.rounds[d][slot] += rounds[d];
    }
  }
  for (std::size_t slot = end; slot < end_of_groups; ++slot) {
    spare_.clear(slot);
    order_[slot] = -1;
  }
}

template <int Dim>
void Tiling<Dim>::bound_clusters(const Positions<Dim>& positions, std::size_t tile) {
  for (std::int32_t first = tiles_[tile].begin; first < end_of_slots(tile); first += cluster_size) {
    const std::int32_t end = std::min(first + cluster_size, tiles_[tile].end);
    for (int d = 0; d < Dim; ++d) {
      float low = nowhere;
      float high = -nowhere;
      for (std::int32_t slot = first; slot < end; ++slot) {
        low = std::min(low, positions.x[d][static_cast<std::size_t>(slot)]);
        high = std::max(high, positions.x[d][static_cast<std::size_t>(slot)]);
      }
      low_[d][static_cast<std::size_t>(first / cluster_size)] = low;
      high_[d][static_cast<std::size_t>(first / cluster_size)] = high;
    }
  }
}

template class Tiling<2>;
template class Tiling<3>;

}  // namespace weir
