// Loops over one tile that are built once per instruction set, and the choice among them. engine/instances.def lists them,
// one line a loop; a loop that is used and not listed does not link.
#pragma once

#include <cstdint>
#include <stdexcept>

#include "simd/instruction_set.h"
#include "sph/pair_lists.h"

namespace weir {

// What a loop over pairs gets beside its pass.
template <int Dim>
struct PairArguments {
  PairInput<Dim> pairs;
  std::int32_t tile = 0;
  float support_radius = 0;  // m
  bool listed = false;       // visit lists with their skin, as no loop before has pruned these
  bool first = true;         // of the loops that add to these sums: begin with the pass's start value
  float* sums = nullptr;     // of the tile, sum_width<components> floats a slot up to the end of a group
};
template <int Dim>
using RunPairs = void (*)(const void* pass, const PairArguments<Dim>& in);

// What a loop over particles gets beside its update.
struct UpdateArguments {
  Tile slots;
  const std::int32_t* id = nullptr;
  const float* sums = nullptr;
};

template <int Dim>
using ListTile = void (*)(const ListInput<Dim>& in, std::int32_t tile, IntBuffer& list, IntBuffer& scratch);
template <int Dim>
struct Listers {
  int rows = 0;                     // particles of an i-cluster
  ListTile<Dim> within = nullptr;   // of a set with itself
  ListTile<Dim> between = nullptr;  // of one set and another
};

// Of a set with itself: each pair of one tile is visited once and acts on both.
template <class Pass>
struct Within {};
// Of one set and another: a pair acts on the target alone.
template <class Pass>
struct Between {};

#define WEIR_DECLARE_LOOPS(set)                                                \
  namespace set {                                                              \
  template <class Loop>                                                        \
  struct Pairs;                                                                \
  template <class Pass>                                                        \
  struct Pairs<Within<Pass>> {                                                 \
    static void run(const void*, const PairArguments<Pass::dimension>&);       \
  };                                                                           \
  template <class Pass>                                                        \
  struct Pairs<Between<Pass>> {                                                \
    static void run(const void*, const PairArguments<Pass::dimension>&);       \
  };                                                                           \
  template <class Update>                                                      \
  struct Each {                                                                \
    static typename Update::Result run(const Update&, const UpdateArguments&); \
  };                                                                           \
  template <int Dim>                                                           \
  Listers<Dim> listers();                                                      \
  }
WEIR_DECLARE_LOOPS(baseline)
#if defined(__x86_64__)
WEIR_DECLARE_LOOPS(avx2)
WEIR_DECLARE_LOOPS(avx512)
#endif
#undef WEIR_DECLARE_LOOPS

// choose(baseline's, AVX2's, AVX-512's) without naming those that this architecture lacks.
#if defined(__x86_64__)
#define WEIR_BUILT_FOR(set, what) \
  ((set) == InstructionSet::avx512 ? (avx512::what) : (set) == InstructionSet::avx2 ? (avx2::what) : (baseline::what))
#else
#define WEIR_BUILT_FOR(set, what) ((void)(set), (baseline::what))
#endif

// `set` must be usable.
template <class Loop, int Dim>
RunPairs<Dim> pairs_for(InstructionSet set) {
  return WEIR_BUILT_FOR(set, Pairs<Loop>::run);
}
template <class Update>
auto each_for(InstructionSet set) {
  return WEIR_BUILT_FOR(set, Each<Update>::run);
}
template <int Dim>
Listers<Dim> listers_for(InstructionSet set) {
  return WEIR_BUILT_FOR(set, listers<Dim>)();
}

}  // namespace weir
