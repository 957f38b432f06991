#include "simd/lanes_functions.h"

#include "simd/lanes.h"

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
  bool are = true;
  for (int k = 0; k < widest_register; k += lanes) are = are && all(at_most(load(a + k), load(b + k)));
  return are;
}

}  // namespace

LaneFunctions lane_functions() { return {larger_of, smaller_of, positive_part_of, square_root_of, all_at_most}; }

}  // namespace weir::WEIR_INSTRUCTION_SET
