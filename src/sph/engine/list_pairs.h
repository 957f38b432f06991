// Builds the lists of one tile, in two stages: for a group of particles the clusters whose boxes are near its box, then
// for each i-cluster of the group those that hold a particle near one of its own.
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
  std::int32_t low[Dim];
  std::int32_t high[Dim];
  for (int d = 0; d < Dim; ++d) {
    // Positions were rounded when they were sorted into columns.
    const float reach = in.reach + 1e-5F * in.edge[d];
    const float half = 0.5F * in.edge[d];
    const float columns_per_length = static_cast<float>(in.columns) / in.edge[d];
    // Columns hold what was there when they were sorted.
    float low_then = box.low[d] - reach;
    float high_then = box.high[d] + reach;
    if (set.moved != nullptr) {
      low_then -= set.moved[tile].greatest[d];
      high_then -= set.moved[tile].least[d];
    }
    if (low_then > half || high_then < -half) return;
    const auto column = [&](float position) {
      const float number = (position + half) * columns_per_length;
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
    append_near_clusters(set, box, begin > from ? begin : from, end, in.reach + 1e-5F * in.edge[0], found);
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
    for (int d = 0; d < Dim; ++d) shifted[d] = row[d] - Lanes(in.edge[d] * static_cast<float>(segment.offset[d]));
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
  TileLister(const ListInput<Dim>& in, std::int32_t tile, IntBuffer& list, IntBuffer& scratch)
      : in_(in), tile_(tile), list_(list), candidates_(scratch) {}

  // Of a set with itself.
  void list_within() {
    for_each_group([&](std::int32_t group, const Box<Dim>& box, std::int32_t end) {
      candidates_.set_size(0);
      append_candidates(in_, in_.source, tile_, box, group / cluster, candidates_);
      const auto own_end = static_cast<std::int32_t>(candidates_.size());
      collect_segments(box, false);
      for (std::int32_t i = group; i < end; i += rows) {
        const Vec<Dim, Lanes> row = load_row(i);
        append_own(i, row, own_end);
        append_segments(in_, in_.source, row, segments_, segment_count_, candidates_.data(), list_);
        append(list_, 0);
      }
    });
  }

  // Of one set and another.
  void list_between() {
    for_each_group([&](std::int32_t group, const Box<Dim>& box, std::int32_t end) {
      candidates_.set_size(0);
      collect_segments(box, true);
      if (segment_count_ == 0) return;
      for (std::int32_t i = group; i < end; i += rows) {
        const std::size_t before = list_.size();
        append(list_, i);
        append_segments(in_, in_.source, load_row(i), segments_, segment_count_, candidates_.data(), list_);
        if (list_.size() == before + 1) {
          list_.set_size(before);
        } else {
          append(list_, 0);
        }
      }
    });
    append(list_, -1);
  }

 private:
  // visit(first slot, box of its particles, end of its slots) for each group of the tile.
  template <class Visit>
  WEIR_INLINE void for_each_group(const Visit& visit) {
    list_.set_size(0);
    const Tile slots = in_.target.tiles[tile_];
    for (std::int32_t group = slots.begin; group < slots.end; group += group_size) {
      const std::int32_t end = slots.end < group + group_size ? slots.end : group + group_size;
      Box<Dim> box;
      for (int d = 0; d < Dim; ++d) {
        box.low[d] = in_.target.low[d][group / cluster];
        box.high[d] = in_.target.high[d][group / cluster];
        for (std::int32_t c = group / cluster + 1; c * cluster < end; ++c) {
          if (in_.target.low[d][c] < box.low[d]) box.low[d] = in_.target.low[d][c];
          if (in_.target.high[d][c] > box.high[d]) box.high[d] = in_.target.high[d][c];
        }
      }
      visit(group, box, end);
    }
  }

  void collect_segments(const Box<Dim>& box, bool own_tile) {
    segment_count_ = 0;
    for (int code = 0; code < tile_codes<Dim>; ++code) {
      if (code == own_tile_code<Dim> && !own_tile) continue;
      const std::int32_t beside = in_.adjacent[static_cast<std::ptrdiff_t>(tile_) * tile_codes<Dim> + code];
      if (beside < 0) continue;
      const TileCoordinates<Dim> offset = offset_of_code<Dim>(code);
      Segment& segment = segments_[segment_count_];
      Box<Dim> shifted;
      for (int d = 0; d < Dim; ++d) {
        segment.offset[d] = offset[d];
        shifted.low[d] = box.low[d] - in_.edge[d] * static_cast<float>(offset[d]);
        shifted.high[d] = box.high[d] - in_.edge[d] * static_cast<float>(offset[d]);
      }
      segment.code = code;
      segment.begin = static_cast<std::int32_t>(candidates_.size());
      append_candidates(in_, in_.source, beside, shifted, 0, candidates_);
      segment.end = static_cast<std::int32_t>(candidates_.size());
      if (segment.end > segment.begin) ++segment_count_;
    }
  }

  Vec<Dim, Lanes> load_row(std::int32_t first_slot) const {
    // Empty slots are near nothing, not even each other.
    const Lanes not_there = __builtin_nanf("");
    Vec<Dim, Lanes> row;
    for (int d = 0; d < Dim; ++d) {
      const Lanes x = load_rows(in_.target.x[d] + first_slot);
      row[d] = select(less(x, 0.5F * nowhere), x, not_there);
    }
    return row;
  }

  // Clusters of the own tile after the i-cluster's own, which needs no listing.
  void append_own(std::int32_t first_slot, const Vec<Dim, Lanes>& row, std::int32_t own_end) {
    list_.reserve_more(static_cast<std::size_t>(own_end + 2));
    std::int32_t* const count = list_.data() + list_.size();
    const std::int32_t* candidate = candidates_.data();
    const std::int32_t* const end = candidate + own_end;
    while (candidate != end && *candidate <= first_slot) ++candidate;  // they ascend
    const std::int32_t* const out =
        write_near<Dim>(row, positions_of(in_.source), in_.reach, candidate, end, count + 1);
    *count = static_cast<std::int32_t>(out - count - 1);
    list_.set_size(static_cast<std::size_t>(out - list_.data()));
  }

  const ListInput<Dim>& in_;
  std::int32_t tile_;
  IntBuffer& list_;
  IntBuffer& candidates_;  // of the own tile, then segment by segment
  Segment segments_[tile_codes<Dim>];
  int segment_count_ = 0;
};

}  // namespace weir::WEIR_INSTRUCTION_SET
