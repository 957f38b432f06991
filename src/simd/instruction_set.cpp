#include "simd/instruction_set.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdlib>
#include <vector>

#include "core/error.h"

namespace weir {

namespace {

bool has(InstructionSet set) {
  switch (set) {
    case InstructionSet::baseline:
      return true;
#if defined(__x86_64__)
    case InstructionSet::avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2") &&
             __builtin_cpu_supports("aes") && __builtin_cpu_supports("pclmul");
    case InstructionSet::avx512:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
             __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512cd") && has(InstructionSet::avx2);
#endif
    default:
      return false;
  }
}

}  // namespace

std::string_view name_of(InstructionSet set) {
  switch (set) {
    case InstructionSet::baseline:
      return "baseline";
    case InstructionSet::avx2:
      return "avx2";
    case InstructionSet::avx512:
      return "avx512";
  }
  return "";
}

std::span<const InstructionSet> usable_instruction_sets() {
  static const std::vector<InstructionSet> usable = [] {
    std::vector<InstructionSet> sets;
    for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
      if (has(set)) sets.push_back(set);
    }
    return sets;
  }();
  return usable;
}

InstructionSet instruction_set_by_name(std::string_view name) {
  std::vector<std::string_view> names;
  for (const InstructionSet set : usable_instruction_sets()) {
    if (name_of(set) == name) return set;
    names.push_back(name_of(set));
  }
  throw UsageError(
      fmt::format("no instruction set '{}' here: this program and processor have {}", name, fmt::join(names, ", ")));
}

InstructionSet default_instruction_set() {
  const char* wanted = std::getenv("WEIR_INSTRUCTION_SET");
  if (wanted != nullptr && *wanted != '\0') return instruction_set_by_name(wanted);
  return usable_instruction_sets().back();
}

}  // namespace weir
