// Lanes by Highway, for the instruction set that this source is built with. Highway has the operations beyond
// arithmetic that the pair engine needs (repeated quarters of a register, compressed stores), which
// std::experimental::simd lacks.
#pragma once

#include <hwy/highway.h>

#include <cstdint>

#include "core/math.h"
#include "simd/attributes.h"

namespace weir::WEIR_INSTRUCTION_SET {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using IntTag = hn::ScalableTag<std::int32_t>;

constexpr int lanes = HWY_LANES(float);

// In pair loops a register is a table of pairs: `rows` rows, one particle i each, and `cluster` columns, one neighbour
// j each.
constexpr int cluster = 4;
constexpr int rows = lanes / cluster;

struct Lanes {
  using Register = hn::Vec<FloatTag>;
  Register v;

  WEIR_INLINE Lanes() : v(hn::Zero(FloatTag())) {}
  WEIR_INLINE Lanes(Register r) : v(r) {}                    // NOLINT(google-explicit-constructor)
  WEIR_INLINE Lanes(float s) : v(hn::Set(FloatTag(), s)) {}  // NOLINT(google-explicit-constructor)
  WEIR_INLINE explicit Lanes(double s) : Lanes(static_cast<float>(s)) {}
  WEIR_INLINE explicit Lanes(int s) : Lanes(static_cast<float>(s)) {}

  friend WEIR_INLINE Lanes operator+(Lanes a, Lanes b) { return hn::Add(a.v, b.v); }
  friend WEIR_INLINE Lanes operator-(Lanes a, Lanes b) { return hn::Sub(a.v, b.v); }
  friend WEIR_INLINE Lanes operator*(Lanes a, Lanes b) { return hn::Mul(a.v, b.v); }
  friend WEIR_INLINE Lanes operator/(Lanes a, Lanes b) { return hn::Div(a.v, b.v); }
  friend WEIR_INLINE Lanes operator-(Lanes a) { return hn::Neg(a.v); }
  WEIR_INLINE Lanes& operator+=(Lanes b) { return *this = *this + b; }
  WEIR_INLINE Lanes& operator*=(Lanes b) { return *this = *this * b; }

  // The functions of core/math.h.
  friend WEIR_INLINE Lanes multiply_add(Lanes a, Lanes b, Lanes c) { return hn::MulAdd(a.v, b.v, c.v); }
  friend WEIR_INLINE Lanes minus_product(Lanes c, Lanes a, Lanes b) { return hn::NegMulAdd(a.v, b.v, c.v); }
  friend WEIR_INLINE Lanes reciprocal_guess(Lanes a) {
    const hn::RebindToSigned<FloatTag> bits;
    return hn::BitCast(FloatTag(), hn::Sub(hn::Set(bits, 0x7EF311C0), hn::BitCast(bits, a.v)));
  }
  // A division takes some 16 cycles for 16 lanes, as long as 32 products, and 5 cycles for 8 lanes.
  friend WEIR_INLINE Lanes quotient(Lanes a, Lanes b) {
    if constexpr (lanes == 16) {
      return a * reciprocal_by_products(b);
    } else {
      return a / b;
    }
  }
  friend WEIR_INLINE Lanes positive_part(Lanes a) { return hn::Max(hn::Zero(FloatTag()), a.v); }
  friend WEIR_INLINE Lanes square_root(Lanes a) { return hn::Sqrt(a.v); }
  friend WEIR_INLINE Lanes smaller(Lanes a, Lanes b) { return hn::Min(a.v, b.v); }
  friend WEIR_INLINE Lanes larger(Lanes a, Lanes b) { return hn::Max(a.v, b.v); }

  friend WEIR_INLINE float least(Lanes a) { return hn::GetLane(hn::MinOfLanes(FloatTag(), a.v)); }
  friend WEIR_INLINE float greatest(Lanes a) { return hn::GetLane(hn::MaxOfLanes(FloatTag(), a.v)); }
};

// A subset of the lanes.
struct Mask {
  hn::Mask<FloatTag> m;

  friend WEIR_INLINE Lanes select(Mask which, Lanes yes, Lanes no) { return hn::IfThenElse(which.m, yes.v, no.v); }
  friend WEIR_INLINE bool all(Mask which) { return hn::AllTrue(FloatTag(), which.m); }
  friend WEIR_INLINE bool any(Mask which) { return !hn::AllFalse(FloatTag(), which.m); }
};
WEIR_INLINE Mask less(Lanes a, Lanes b) { return {hn::Lt(a.v, b.v)}; }
WEIR_INLINE Mask at_most(Lanes a, Lanes b) { return {hn::Le(a.v, b.v)}; }

// `lanes` consecutive numbers; `p` need not be aligned. Arrays are padded by a register.
WEIR_INLINE Lanes load(const float* p) { return hn::LoadU(FloatTag(), p); }
WEIR_INLINE void store(Lanes a, float* p) { hn::StoreU(a.v, FloatTag(), p); }

// The columns: p[0 .. cluster) in every row. `p` is aligned to a cluster.
WEIR_INLINE Lanes load_columns(const float* p) { return hn::LoadDup128(FloatTag(), p); }

// The rows: p[k] in all lanes of row k.
WEIR_INLINE Lanes load_rows(const float* p) {
  if constexpr (rows == 1) {
    return *p;
  } else {
    alignas(64) constexpr std::int32_t index[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
    return hn::TableLookupLanes(hn::LoadU(FloatTag(), p), hn::SetTableIndices(FloatTag(), index));
  }
}

// Lanes of a smaller register.
template <int n>
using Part = hn::FixedTag<float, n>;

// p[0 .. n) += a, or -= a. `p` is aligned to that.
template <bool subtract, int n>
WEIR_INLINE void accumulate(hn::Vec<Part<n>> a, float* p) {
  const Part<n> part;
  const auto was = hn::Load(part, p);
  hn::Store(subtract ? hn::Sub(was, a) : hn::Add(was, a), part, p);
}

template <class Tag>
WEIR_INLINE auto add_halves(Tag, hn::Vec<Tag> a) {
  const hn::Half<Tag> half;
  return hn::Add(hn::LowerHalf(half, a), hn::UpperHalf(half, a));
}

// The sum over rows.
template <class Tag>
WEIR_INLINE auto fold_rows(Tag all, hn::Vec<Tag> a) {
  if constexpr (hn::MaxLanes(Tag()) == cluster) {
    return a;
  } else {
    return fold_rows(hn::Half<Tag>(), add_halves(all, a));
  }
}

// The sums over rows of several registers, one cluster after the other; of three, the fourth cluster is unspecified.
// Fewer shuffles than folding each register.
template <int count>
WEIR_INLINE auto fold_rows_of(const Lanes* a) {
  static_assert(count == 2 || count == 3);
  const FloatTag all;
  if constexpr (rows == 2) {
    return hn::Add(hn::ConcatLowerLower(all, a[1].v, a[0].v), hn::ConcatUpperUpper(all, a[1].v, a[0].v));
  } else {
    // Blocks of four lanes: a0 b1 a2 b3 and a1 b0 a3 b2.
    const auto both =
        hn::Add(hn::OddEvenBlocks(a[1].v, a[0].v), hn::SwapAdjacentBlocks(hn::OddEvenBlocks(a[0].v, a[1].v)));
    if constexpr (count == 2) return add_halves(all, both);
    if constexpr (count == 3) {
      const auto third = hn::Add(a[2].v, hn::SwapAdjacentBlocks(a[2].v));
      return hn::Add(hn::ConcatLowerLower(all, third, both), hn::ConcatUpperUpper(all, third, both));
    }
  }
}

// p[cluster c + k] += the sum over rows of column k of a[c], or -=. `p` is aligned to a cluster of sum_width<count>.
template <bool subtract, int count>
WEIR_INLINE void accumulate_columns(const Lanes* a, float* p) {
  if constexpr (count == 1) {
    accumulate<subtract, cluster>(fold_rows(FloatTag(), a[0].v), p);
  } else if constexpr (count == 3 && rows == 2) {
    accumulate<subtract, 8>(fold_rows_of<2>(a), p);
    accumulate<subtract, cluster>(fold_rows(FloatTag(), a[2].v), p + 8);
  } else {
    accumulate<subtract, count == 2 ? 8 : 16>(fold_rows_of<count>(a), p);
  }
}

// The first four lanes.
template <class Tag>
WEIR_INLINE auto first_cluster(Tag, hn::Vec<Tag> a) {
  if constexpr (hn::MaxLanes(Tag()) == cluster) {
    return a;
  } else {
    const hn::Half<Tag> half;
    return first_cluster(half, hn::LowerHalf(half, a));
  }
}

// p[k] += the sum over row k.
WEIR_INLINE void add_rows(Lanes a, float* p) {
  auto s = hn::Add(a.v, hn::Shuffle2301(a.v));
  s = hn::Add(s, hn::Shuffle1032(s));
  if constexpr (rows == cluster) {
    alignas(64) constexpr std::int32_t index[16] = {0, 4, 8, 12};
    const auto first = hn::TableLookupLanes(s, hn::SetTableIndices(FloatTag(), index));
    accumulate<false, cluster>(first_cluster(FloatTag(), first), p);
  } else {
    alignas(64) float sums[lanes];
    hn::Store(s, FloatTag(), sums);
    for (int k = 0; k < rows; ++k) p[k] += sums[cluster * k];
  }
}

// Row k is p[stride k + 0 .. cluster).
template <class Tag>
WEIR_INLINE auto load_clusters_as(Tag all, const float* p, int stride) {
  if constexpr (hn::MaxLanes(Tag()) == cluster) {
    return hn::Load(all, p);
  } else {
    const hn::Half<Tag> half;
    constexpr int rows_of_half = static_cast<int>(hn::MaxLanes(hn::Half<Tag>())) / cluster;
    return hn::Combine(all, load_clusters_as(half, p + rows_of_half * stride, stride),
                       load_clusters_as(half, p, stride));
  }
}
WEIR_INLINE Lanes load_clusters(const float* p, int stride) { return load_clusters_as(FloatTag(), p, stride); }

// The number of each lane's column, and of its row.
WEIR_INLINE Lanes column_numbers() {
  alignas(64) constexpr float number[16] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
  return load(number);
}
WEIR_INLINE Lanes row_numbers() {
  alignas(64) constexpr float number[16] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};
  return load(number);
}

// The first n lanes.
WEIR_INLINE Mask first(int n) { return {hn::FirstN(FloatTag(), static_cast<std::size_t>(n))}; }

// The lanes k with p[k] >= 0.
WEIR_INLINE Mask not_negative(const std::int32_t* p) {
  return {hn::RebindMask(FloatTag(), hn::Gt(hn::LoadU(IntTag(), p), hn::Set(IntTag(), -1)))};
}
WEIR_INLINE Mask both(Mask a, Mask b) { return {hn::And(a.m, b.m)}; }

// Writes start + step k for each lane k of `which`, in order, to `out`, which has room for a whole register. Returns
// the number written.
WEIR_INLINE int store_numbers(Mask which, std::int32_t start, std::int32_t step, std::int32_t* out) {
  const auto numbers = hn::Add(hn::Set(IntTag(), start), hn::Mul(hn::Iota(IntTag(), 0), hn::Set(IntTag(), step)));
  return static_cast<int>(hn::CompressBlendedStore(numbers, hn::RebindMask(IntTag(), which.m), IntTag(), out));
}

}  // namespace weir::WEIR_INSTRUCTION_SET
