// The eight pixels of a block in vector types of the compiler: two rows of four, in one register of eight floats or in
// two of four. Functions with these parameters are always inlined, as their calling convention depends on the
// instruction set of the caller.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "render/four.h"
#include "simd/attributes.h"

// For functions whose loops are built for AVX2, where there is such a thing.
#if defined(__x86_64__)
#define WEIR_WIDE __attribute__((target("avx2")))
#else
#define WEIR_WIDE
#endif

namespace weir {

using Eight = float __attribute__((vector_size(32)));
using EightWhole = std::int32_t __attribute__((vector_size(32)));

// Whether loops built for AVX2 may run. Their pixels are the same bits.
inline bool has_wide_registers() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

// The pixels' middles, from the block's upper left corner.
inline constexpr Eight middle_x{0.5f, 1.5f, 2.5f, 3.5f, 0.5f, 1.5f, 2.5f, 3.5f};
inline constexpr Eight middle_y{0.5f, 0.5f, 0.5f, 0.5f, 1.5f, 1.5f, 1.5f, 1.5f};

WEIR_INLINE bool all_lanes(const EightWhole& masks) {
  std::array<std::uint64_t, 4> parts;
  std::memcpy(parts.data(), &masks, sizeof(parts));
  return (parts[0] & parts[1] & parts[2] & parts[3]) == ~std::uint64_t{0};
}

WEIR_INLINE void square_root(Eight& of) {
#if defined(__x86_64__)
  const Four low = _mm_sqrt_ps(__builtin_shufflevector(of, of, 0, 1, 2, 3));
  const Four high = _mm_sqrt_ps(__builtin_shufflevector(of, of, 4, 5, 6, 7));
  of = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
#else
  for (int k = 0; k < 8; ++k) of[k] = std::sqrt(of[k]);
#endif
}

// Of lanes 0 .. 255 the lowest bytes, those of four lanes each.
WEIR_INLINE void pack_bytes(const EightWhole& of, std::array<std::uint32_t, 2>& bytes) {
#if defined(__x86_64__)
  using Words = long long __attribute__((vector_size(16)));
  const FourWhole low = __builtin_shufflevector(of, of, 0, 1, 2, 3);
  const FourWhole high = __builtin_shufflevector(of, of, 4, 5, 6, 7);
  const __m128i words = _mm_packs_epi32(reinterpret_cast<Words>(low), reinterpret_cast<Words>(high));
  const __m128i packed = _mm_packus_epi16(words, words);
  std::memcpy(bytes.data(), &packed, sizeof(bytes));
#else
  for (int row = 0; row < 2; ++row)
    bytes[row] = of[4 * row] | of[4 * row + 1] << 8 | of[4 * row + 2] << 16 | of[4 * row + 3] << 24;
#endif
}

// A texel's pixels of channels 0 .. 255.
WEIR_INLINE void pack(const std::array<Eight, 3>& rgb, const Eight& alpha, EightWhole& pixels) {
  pixels = __builtin_convertvector(rgb[0] + 0.5f, EightWhole) |
           __builtin_convertvector(rgb[1] + 0.5f, EightWhole) << 8 |
           __builtin_convertvector(rgb[2] + 0.5f, EightWhole) << 16 |
           __builtin_convertvector(alpha + 0.5f, EightWhole) << 24;
}

}  // namespace weir
