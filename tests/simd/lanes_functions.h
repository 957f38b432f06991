// Functions of registers on arrays, for tests that are built for every processor.
#pragma once

namespace weir {

constexpr int widest_register = 16;  // floats

// Each takes and returns `widest_register` numbers.
struct LaneFunctions {
  void (*larger)(const float* a, const float* b, float* result);
  void (*smaller)(const float* a, const float* b, float* result);
  void (*positive_part)(const float* a, float* result);
  void (*square_root)(const float* a, float* result);
  bool (*all_at_most)(const float* a, const float* b);
};

// In lanes_functions.cpp, which is built once per instruction set.
namespace baseline {
LaneFunctions lane_functions();
}
#if defined(__x86_64__)
namespace avx2 {
LaneFunctions lane_functions();
}
namespace avx512 {
LaneFunctions lane_functions();
}
#endif

}  // namespace weir
