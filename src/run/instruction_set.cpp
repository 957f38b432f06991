#include "run/instruction_set.h"

namespace weir {

std::string_view instruction_set() {
#if defined(__x86_64__)
  return "x86-64 baseline";
#elif defined(__aarch64__)
  return "aarch64 baseline";
#else
  return "baseline";
#endif
}

}  // namespace weir
