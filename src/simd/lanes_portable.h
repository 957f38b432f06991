// Four lanes by the vector types of GCC and clang, for every processor of the architecture. The interface is that of
// lanes_highway.h. (Highway's own emulation takes four times as long to compile and to run, and its version in Debian
// 12 has no SSE2.)
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "simd/attributes.h"

namespace weir::WEIR_INSTRUCTION_SET {

constexpr int lanes = 4;
// In pair loops a register is a table of pairs: `rows` rows, one particle i each, and `cluster` columns, one neighbour
// j each.
constexpr int cluster = 4;
constexpr int rows = lanes / cluster;

struct Lanes {
  typedef float Register __attribute__((vector_size(16)));  // NOLINT(modernize-use-using): the attribute needs it
  Register v;

  WEIR_INLINE Lanes() : v{} {}
  WEIR_INLINE Lanes(Register r) : v(r) {}                  // NOLINT(google-explicit-constructor)
  WEIR_INLINE Lanes(float s) : v(Register{s, s, s, s}) {}  // NOLINT(google-explicit-constructor)
  WEIR_INLINE explicit Lanes(double s) : Lanes(static_cast<float>(s)) {}
  WEIR_INLINE explicit Lanes(int s) : Lanes(static_cast<float>(s)) {}

  friend WEIR_INLINE Lanes operator+(Lanes a, Lanes b) { return a.v + b.v; }
  friend WEIR_INLINE Lanes operator-(Lanes a, Lanes b) { return a.v - b.v; }
  friend WEIR_INLINE Lanes operator*(Lanes a, Lanes b) { return a.v * b.v; }
  friend WEIR_INLINE Lanes operator/(Lanes a, Lanes b) { return a.v / b.v; }
  friend WEIR_INLINE Lanes operator-(Lanes a) { return -a.v; }
  WEIR_INLINE Lanes& operator+=(Lanes b) { return *this = *this + b; }
  WEIR_INLINE Lanes& operator*=(Lanes b) { return *this = *this * b; }

  // The functions of core/math.h. multiply_add rounds twice: the baseline has no fused instruction.
  friend WEIR_INLINE Lanes multiply_add(Lanes a, Lanes b, Lanes c) { return a.v * b.v + c.v; }
  friend WEIR_INLINE Lanes minus_product(Lanes c, Lanes a, Lanes b) { return c.v - a.v * b.v; }
  friend WEIR_INLINE Lanes quotient(Lanes a, Lanes b) { return a / b; }
  friend WEIR_INLINE Lanes smaller(Lanes a, Lanes b) { return a.v < b.v ? a.v : b.v; }
  friend WEIR_INLINE Lanes larger(Lanes a, Lanes b) { return a.v > b.v ? a.v : b.v; }
  friend WEIR_INLINE Lanes positive_part(Lanes a) { return larger(Lanes(), a); }
  friend WEIR_INLINE Lanes square_root(Lanes a) {
    return Register{std::sqrt(a.v[0]), std::sqrt(a.v[1]), std::sqrt(a.v[2]), std::sqrt(a.v[3])};
  }

  friend WEIR_INLINE float least(Lanes a) {
    const float low = a.v[0] < a.v[1] ? a.v[0] : a.v[1];
    const float high = a.v[2] < a.v[3] ? a.v[2] : a.v[3];
    return low < high ? low : high;
  }
  friend WEIR_INLINE float greatest(Lanes a) { return -least(-a); }
};

// A subset of the lanes.
struct Mask {
  typedef std::int32_t Bits __attribute__((vector_size(16)));  // NOLINT(modernize-use-using)
  Bits m;

  friend WEIR_INLINE Lanes select(Mask which, Lanes yes, Lanes no) { return which.m ? yes.v : no.v; }
  friend WEIR_INLINE bool any(Mask which) { return (which.m[0] | which.m[1] | which.m[2] | which.m[3]) != 0; }
  friend WEIR_INLINE bool all(Mask which) { return (which.m[0] & which.m[1] & which.m[2] & which.m[3]) != 0; }
};
WEIR_INLINE Mask less(Lanes a, Lanes b) { return {a.v < b.v}; }
WEIR_INLINE Mask at_most(Lanes a, Lanes b) { return {a.v <= b.v}; }
WEIR_INLINE Mask both(Mask a, Mask b) { return {a.m & b.m}; }

// `lanes` consecutive numbers; `p` need not be aligned. Arrays are padded by a register.
WEIR_INLINE Lanes load(const float* p) {
  Lanes::Register r;
  std::memcpy(&r, p, sizeof r);
  return r;
}
WEIR_INLINE void store(Lanes a, float* p) { std::memcpy(p, &a.v, sizeof a.v); }

// The columns: p[0 .. cluster) in every row.
WEIR_INLINE Lanes load_columns(const float* p) { return load(p); }
// The rows: p[k] in all lanes of row k.
WEIR_INLINE Lanes load_rows(const float* p) { return *p; }

// p[cluster c + k] += the sum over rows of column k of a[c], or -=.
template <bool subtract, int count>
WEIR_INLINE void accumulate_columns(const Lanes* a, float* p) {
  for (int c = 0; c < count; ++c) {
    float* const q = p + cluster * c;
    store(subtract ? load(q) - a[c] : load(q) + a[c], q);
  }
}
// p[k] += the sum over row k.
WEIR_INLINE void add_rows(Lanes a, float* p) { *p += (a.v[0] + a.v[1]) + (a.v[2] + a.v[3]); }

// Row k is p[stride k + 0 .. cluster).
WEIR_INLINE Lanes load_clusters(const float* p, int) { return load(p); }

// The number of each lane's column, and of its row.
WEIR_INLINE Lanes column_numbers() { return Lanes::Register{0, 1, 2, 3}; }
WEIR_INLINE Lanes row_numbers() { return {}; }

// The first n lanes.
WEIR_INLINE Mask first(int n) { return {Mask::Bits{0, 1, 2, 3} < n}; }

// The lanes k with p[k] >= 0.
WEIR_INLINE Mask not_negative(const std::int32_t* p) {
  Mask::Bits numbers;
  std::memcpy(&numbers, p, sizeof numbers);
  return {numbers >= 0};
}

// Writes start + step k for each lane k of `which`, in order, to `out`, which has room for a whole register. Returns
// the number written.
WEIR_INLINE int store_numbers(Mask which, std::int32_t start, std::int32_t step, std::int32_t* out) {
  int count = 0;
  for (int k = 0; k < lanes; ++k) {
    out[count] = start + step * k;
    count += which.m[k] != 0 ? 1 : 0;
  }
  return count;
}

}  // namespace weir::WEIR_INSTRUCTION_SET
