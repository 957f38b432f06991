#include "simd/lanes_functions.h"

#include "simd/lanes.h"

// Features that instruction_set.cpp does not check.
#if !defined(WEIR_PORTABLE_LANES)
#if defined(__AVX512VBMI__) || defined(__AVX512VBMI2__) || defined(__AVX512IFMA__) || defined(__AVX512VNNI__) ||       \
    defined(__AVX512BITALG__) || defined(__AVX512VPOPCNTDQ__) || defined(__AVX512BF16__) || defined(__AVX512FP16__) || \
    defined(__AVXVNNI__) || defined(__GFNI__) || defined(__VAES__) || defined(__VPCLMULQDQ__)
#error "built with instructions whose support is not checked: see instruction_set.cpp"
#endif
#endif

namespace weir::WEIR_INSTRUCTION_SET {

namespace {

void larger_of(const float* a, const float* b, float* result) {
  for (int k = 0; k < widest_register; k += lanes) store(larger(load(a + k), load(b + k)), result + k);
}
void smaller_of(const float* a, const float* b, float* result) {
  for (int k = 0; k < widest_register; k += lanes) store(smaller(load(a + k), load(b + k)), result + k);
}
void positive_part_of(const float* a, float* result) {
  for (int k = 0; k < widest_register; k += lanes) store(positive_part(load(a + k)), result + k);
}
void square_root_of(const float* a, float* result) {
  for (int k = 0; k < widest_register; k += lanes) store(square_root(load(a + k)), result + k);
}
bool all_at_most(const float* a, const float* b) {
  bool result = true;
  for (int k = 0; k < widest_register; k += lanes) result = result && all(at_most(load(a + k), load(b + k)));
  return result;
}

}  // namespace

LaneFunctions lane_functions() { return {larger_of, smaller_of, positive_part_of, square_root_of, all_at_most}; }

}  // namespace weir::WEIR_INSTRUCTION_SET
