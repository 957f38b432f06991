// Makes the lists of one tile, in two stages: for a group of particles the clusters whose boxes are near its box, then
// for each row of the group those that hold a particle near one of the row's.
#pragma once

#include "simd/lanes.h"
#include "sph/pair_lists.h"

namespace weir::WEIR_INSTRUCTION_SET {

static_assert(cluster == cluster_size);

template <int Dim>
struct Box {
  float low[Dim];
  float high[Dim];
};

// Appends the clusters among [begin, end) whose boxes are within `reach` of `box`.
template <int Dim>
WEIR_INLINE void append_near_clusters(const TilesView<Dim>& set, const Box<Dim>& box, std::int32_t begin,
                                      std::int32_t end, float reach, IntBuffer& found) {
  if (begin >= end) return;
  found.reserve_more(static_cast<std::size_t>(end - begin + lanes));
  std::int32_t* out = found.data() + found.size();
  for (std::int32_t c = begin; c < end; c += lanes) {
    Lanes square;
    for (int d = 0; d < Dim; ++d) {
      const Lanes below = Lanes(box.low[d]) - load(set.high[d] + c);
      const Lanes above = load(set.low[d] + c) - Lanes(box.high[d]);
      const Lanes gap = positive_part(larger(below, above));
      square = multiply_add(gap, gap, square);
    }
    const Mask near = both(less(square, reach * reach), first(end - c));
    out += store_numbers(near, c * cluster, cluster, out);
  }
  found.set_size(static_cast<std::size_t>(out - found.data()));
}

// Appends the clusters of a tile that are within `reach` of `box`, which is given in the frame of that tile. Clusters
// before `from` are left out.
template <int Dim>
WEIR_INLINE void append_candidates(const ListInput<Dim>& in, const TilesView<Dim>& set, std::int32_t tile,
                                   const Box<Dim>& box, std::int32_t from, IntBuffer& found) {
  // Positions were rounded when they were sorted into columns.
  const float reach = in.reach + 1e-5F * in.edge;
  const float half = 0.5F * in.edge;
  const float columns_per_length = static_cast<float>(in.columns) / in.edge;
  std::int32_t low[Dim];
  std::int32_t high[Dim];
  for (int d = 0; d < Dim; ++d) {
    // Columns hold what was there when they were sorted.
    float low_then = box.low[d] - reach;
    float high_then = box.high[d] + reach;
    if (set.moved != nullptr) {
      low_then -= set.moved[tile].greatest[d];
      high_then -= set.moved[tile].least[d];
    }
    if (low_then > half || high_then < -half) return;
    const auto column = [&](float place) {
      const float number = (place + half) * columns_per_length;
      const auto whole = static_cast<std::int32_t>(number);
      return number < 0 ? 0 : (whole >= in.columns ? in.columns - 1 : whole);
    };
    low[d] = column(low_then);
    high[d] = column(high_then);
  }
  const std::int32_t per_tile = Dim == 2 ? in.columns : in.columns * in.columns;
  const std::int32_t* columns = set.columns + static_cast<std::ptrdiff_t>(tile) * (per_tile + 1);
  // A cluster may lie in two columns; rows of columns follow the order of slots, so none is taken twice.
  const auto append_columns = [&](std::int32_t first_column, std::int32_t last_column) {
    const std::int32_t begin = columns[first_column] / cluster;
    const std::int32_t end = (columns[last_column + 1] + cluster - 1) / cluster;
    append_near_clusters(set, box, begin > from ? begin : from, end, reach, found);
    if (end > from) from = end;
  };
  if constexpr (Dim == 2) {
    append_columns(low[0], high[0]);
  } else {
    for (std::int32_t row = low[0]; row <= high[0]; ++row) {
      const bool back = row % 2 != 0;  // every second row of columns runs back
      const std::int32_t begin = back ? in.columns - 1 - high[1] : low[1];
      const std::int32_t end = back ? in.columns - 1 - low[1] : high[1];
      append_columns(row * in.columns + begin, row * in.columns + end);
    }
  }
}

// Writes those among [candidate, end) to `out` of which some particle is within reach of some particle of the row; returns
// where the next goes. All that it reads are copies, which no store could change: they stay in registers.
template <int Dim>
WEIR_INLINE std::int32_t* write_near(const Vec<Dim, Lanes> row, const Vec<Dim, const float*> x, float reach,
                                     const std::int32_t* candidate, const std::int32_t* end, std::int32_t* out) {
  const Lanes reach_squared = reach * reach;
  for (; candidate != end; ++candidate) {
    const std::int32_t slot = *candidate;
    Lanes square;
    for (int d = 0; d < Dim; ++d) {
      const Lanes x_ij = row[d] - load_columns(x[d] + slot);
      square = multiply_add(x_ij, x_ij, square);
    }
    *out = slot;
    out += any(less(square, reach_squared)) ? 1 : 0;
  }
  return out;
}

template <int Dim>
WEIR_INLINE Vec<Dim, const float*> positions_of(const TilesView<Dim>& set) {
  Vec<Dim, const float*> x;
  for (int d = 0; d < Dim; ++d) x[d] = set.x[d];
  return x;
}

// Candidates of a group in one tile, as the code of that tile and a range of the scratch buffer.
struct Segment {
  std::int32_t code;
  std::int32_t begin;
  std::int32_t end;
  std::int32_t offset[3];  // of the tile, in tiles
};

// Appends for one row the segments of `candidates` that hold anything.
template <int Dim>
WEIR_INLINE void append_segments(const ListInput<Dim>& in, const TilesView<Dim>& set, const Vec<Dim, Lanes>& row,
                                 const Segment* segments, int count, const std::int32_t* candidates, IntBuffer& list) {
  for (int s = 0; s < count; ++s) {
    const Segment& segment = segments[s];
    list.reserve_more(static_cast<std::size_t>(segment.end - segment.begin + 2));
    Vec<Dim, Lanes> shifted;
    for (int d = 0; d < Dim; ++d) shifted[d] = row[d] - Lanes(in.edge * static_cast<float>(segment.offset[d]));
    std::int32_t* const header = list.data() + list.size();
    const std::int32_t* const out = write_near<Dim>(shifted, positions_of(set), in.reach, candidates + segment.begin,
                                                    candidates + segment.end, header + 1);
    const auto found = static_cast<std::int32_t>(out - header - 1);
    if (found == 0) continue;
    *header = found << segment_code_bits | segment.code;
    list.set_size(static_cast<std::size_t>(out - list.data()));
  }
}

WEIR_INLINE void append(IntBuffer& list, std::int32_t number) {
  list.reserve_more(1);
  list.data()[list.size()] = number;
  list.set_size(list.size() + 1);
}

template <int Dim>
class TileLister {
 public:
  TileLister(const ListInput<Dim>& in, std::int32_t tile, IntBuffer& fluid_list, IntBuffer& wall_list,
             IntBuffer& scratch)
      : in_(in), tile_(tile), fluid_list_(fluid_list), wall_list_(wall_list), scratch_(scratch) {}

  void list() {
    fluid_list_.set_size(0);
    wall_list_.set_size(0);
    const Tile slots = in_.fluid.tiles[tile_];
    for (std::int32_t group = slots.begin; group < slots.end; group += group_size) {
      const std::int32_t end = slots.end < group + group_size ? slots.end : group + group_size;
      if (!in_.all_pairs) collect(group, end);
      for (std::int32_t row = group; row < end; row += rows) {
        if (in_.all_pairs) {
          list_row_naively(row);
        } else {
          list_row(row);
        }
      }
    }
    append(wall_list_, -1);
  }

 private:
  void collect(std::int32_t group, std::int32_t end) {
    Box<Dim> box;
    for (int d = 0; d < Dim; ++d) {
      box.low[d] = in_.fluid.low[d][group / cluster];
      box.high[d] = in_.fluid.high[d][group / cluster];
      for (std::int32_t c = group / cluster + 1; c * cluster < end; ++c) {
        if (in_.fluid.low[d][c] < box.low[d]) box.low[d] = in_.fluid.low[d][c];
        if (in_.fluid.high[d][c] > box.high[d]) box.high[d] = in_.fluid.high[d][c];
      }
    }
    scratch_.set_size(0);
    append_candidates(in_, in_.fluid, tile_, box, group / cluster, scratch_);
    own_end_ = static_cast<std::int32_t>(scratch_.size());
    fluid_segments_ = collect_segments(in_.fluid, box, false, fluid_);
    wall_segments_ = in_.walls.tile_count > 0 ? collect_segments(in_.walls, box, true, walls_) : 0;
  }

  int collect_segments(const TilesView<Dim>& set, const Box<Dim>& box, bool own_tile, Segment* segments) {
    int count = 0;
    for (int code = 0; code < tile_codes<Dim>; ++code) {
      if (code == own_tile_code<Dim> && !own_tile) continue;
      const std::int32_t beside = set.adjacent[static_cast<std::ptrdiff_t>(tile_) * tile_codes<Dim> + code];
      if (beside < 0) continue;
      const TileCoordinates<Dim> offset = offset_of_code<Dim>(code);
      Segment& segment = segments[count];
      Box<Dim> shifted;
      for (int d = 0; d < Dim; ++d) {
        segment.offset[d] = offset[d];
        shifted.low[d] = box.low[d] - in_.edge * static_cast<float>(offset[d]);
        shifted.high[d] = box.high[d] - in_.edge * static_cast<float>(offset[d]);
      }
      segment.code = code;
      segment.begin = static_cast<std::int32_t>(scratch_.size());
      append_candidates(in_, set, beside, shifted, 0, scratch_);
      segment.end = static_cast<std::int32_t>(scratch_.size());
      if (segment.end > segment.begin) ++count;
    }
    return count;
  }

  void list_row(std::int32_t first_slot) {
    Vec<Dim, Lanes> row;
    load_row(first_slot, row);
    append_own(first_slot, row);
    append_segments(in_, in_.fluid, row, fluid_, fluid_segments_, scratch_.data(), fluid_list_);
    append(fluid_list_, 0);

    if (wall_segments_ == 0) return;
    const std::size_t before = begin_walls(first_slot);
    append_segments(in_, in_.walls, row, walls_, wall_segments_, scratch_.data(), wall_list_);
    end_walls(before);
  }

  // Against every cluster there is, in the same order.
  void list_row_naively(std::int32_t first_slot) {
    Vec<Dim, Lanes> row;
    load_row(first_slot, row);
    scratch_.set_size(0);
    take_all(in_.fluid.tiles[tile_]);
    own_end_ = static_cast<std::int32_t>(scratch_.size());
    append_own(first_slot, row);
    append_all(in_.fluid, row, false, fluid_list_);
    append(fluid_list_, 0);

    const std::size_t before = begin_walls(first_slot);
    append_all(in_.walls, row, true, wall_list_);
    end_walls(before);
  }

  void take_all(const Tile& slots) {
    for (std::int32_t slot = slots.begin; slot < slots.end; slot += cluster) append(scratch_, slot);
  }

  void append_all(const TilesView<Dim>& set, const Vec<Dim, Lanes>& row, bool own_tile, IntBuffer& list) {
    for (std::int32_t tile = 0; tile < set.tile_count; ++tile) {
      Segment segment{};
      bool beside = false;
      for (int d = 0; d < Dim; ++d) {
        segment.offset[d] = set.coordinates[tile][d] - in_.fluid.coordinates[tile_][d];
        beside = beside || segment.offset[d] != 0;
        segment.code =
            3 * segment.code + segment.offset[d] + 1;  // means something for adjacent tiles, and only those are near
      }
      if (!beside && !own_tile) continue;
      scratch_.set_size(0);
      take_all(set.tiles[tile]);
      segment.end = static_cast<std::int32_t>(scratch_.size());
      append_segments(in_, set, row, &segment, 1, scratch_.data(), list);
    }
  }

  void load_row(std::int32_t first_slot, Vec<Dim, Lanes>& row) const {
    // Empty slots are near nothing, not even each other.
    const Lanes nobody = __builtin_nanf("");
    for (int d = 0; d < Dim; ++d) {
      const Lanes x = load_rows(in_.fluid.x[d] + first_slot);
      row[d] = select(less(x, 0.5F * nowhere), x, nobody);
    }
  }

  // Clusters of the own tile after the row's own, which needs no listing.
  void append_own(std::int32_t first_slot, const Vec<Dim, Lanes>& row) {
    fluid_list_.reserve_more(static_cast<std::size_t>(own_end_ + 2));
    std::int32_t* const count = fluid_list_.data() + fluid_list_.size();
    const std::int32_t* candidate = scratch_.data();
    const std::int32_t* const end = candidate + own_end_;
    while (candidate != end && *candidate <= first_slot) ++candidate;  // they ascend
    const std::int32_t* const out = write_near<Dim>(row, positions_of(in_.fluid), in_.reach, candidate, end, count + 1);
    *count = static_cast<std::int32_t>(out - count - 1);
    fluid_list_.set_size(static_cast<std::size_t>(out - fluid_list_.data()));
  }

  std::size_t begin_walls(std::int32_t first_slot) {
    append(wall_list_, first_slot);
    return wall_list_.size() - 1;
  }
  // A row without walls has no entry.
  void end_walls(std::size_t before) {
    if (wall_list_.size() == before + 1) {
      wall_list_.set_size(before);
    } else {
      append(wall_list_, 0);
    }
  }

  const ListInput<Dim>& in_;
  std::int32_t tile_;
  IntBuffer& fluid_list_;
  IntBuffer& wall_list_;
  IntBuffer& scratch_;  // candidates: of the own tile, then segment by segment
  std::int32_t own_end_ = 0;
  Segment fluid_[tile_codes<Dim>];
  Segment walls_[tile_codes<Dim>];
  int fluid_segments_ = 0;
  int wall_segments_ = 0;
};

}  // namespace weir::WEIR_INSTRUCTION_SET
