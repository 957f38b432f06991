#include "simd/instruction_set.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#if defined(__x86_64__)
#include <cpuid.h>
#endif

#include <cstdlib>
#include <vector>

#include "core/error.h"

namespace weir {

namespace {

#if defined(__x86_64__)
// movbe, f16c and lzcnt, which __builtin_cpu_supports of clang 14 does not know. [Intel 64 and IA-32 Architectures
// Software Developer's Manual, vol. 2A, CPUID]
bool has_movbe_f16c_and_lzcnt() {
  constexpr unsigned movbe_and_f16c = 1U << 22 | 1U << 29;  // leaf 1, ECX
  constexpr unsigned lzcnt = 1U << 5;                       // leaf 0x80000001, ECX
  unsigned eax = 0;
  unsigned ebx = 0;
  unsigned ecx = 0;
  unsigned edx = 0;
  if (__get_cpuid(1, &eax, &ebx, &ecx, &edx) == 0 || (ecx & movbe_and_f16c) != movbe_and_f16c) return false;
  return __get_cpuid(0x80000001, &eax, &ebx, &ecx, &edx) != 0 && (ecx & lzcnt) == lzcnt;
}

// All instructions that compilers emit unasked for -march=haswell -maes -mpclmul; includes that the operating system
// saves the registers.
bool has_avx2() {
  return __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("popcnt") && __builtin_cpu_supports("avx") &&
         __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi") &&
         __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("aes") && __builtin_cpu_supports("pclmul") &&
         has_movbe_f16c_and_lzcnt();
}

// The same for -march=skylake-avx512.
bool has_avx512() {
  return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
         __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}
#endif

bool has(InstructionSet set) {
  switch (set) {
    case InstructionSet::baseline:
      return true;
#if defined(__x86_64__)
    case InstructionSet::avx2:
      return has_avx2();
    case InstructionSet::avx512:
      return has_avx512();
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

InstructionSet instruction_set_by_name(std::string_view name, std::span<const InstructionSet> usable) {
  std::vector<std::string_view> names;
  for (const InstructionSet set : usable) {
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
