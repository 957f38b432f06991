#include "simd/instruction_set.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.h"

namespace weir {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(InstructionSets, TheBaselineIsAlwaysUsableAndFirst) {
  ASSERT_FALSE(usable_instruction_sets().empty());
  EXPECT_EQ(usable_instruction_sets().front(), InstructionSet::baseline);
}

TEST(InstructionSets, AreFoundByTheirNames) {
  for (const InstructionSet set : usable_instruction_sets()) EXPECT_EQ(instruction_set_by_name(name_of(set)), set);
}

// As on a processor that lacks a set that the program was built with.
TEST(InstructionSets, AnUnusableSetIsRefusedNamingTheUsableOnes) {
  const std::vector<InstructionSet> here = {InstructionSet::baseline, InstructionSet::avx2};
  EXPECT_EQ(instruction_set_by_name("avx2", here), InstructionSet::avx2);
  for (const char* name : {"avx512", "sse9", ""}) {
    try {
      instruction_set_by_name(name, here);
      ADD_FAILURE() << name;
    } catch (const UsageError& error) {
      EXPECT_THAT(error.what(), HasSubstr("'" + std::string(name) + "'"));
      EXPECT_THAT(error.what(), HasSubstr("baseline, avx2"));
      EXPECT_THAT(error.what(), Not(HasSubstr("avx2, avx512")));
    }
  }
}

#if defined(__x86_64__) && defined(__linux__)
// As in the kernel, which omits features whose registers it does not save.
std::set<std::string> flags_of_processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("flags")) continue;
    std::istringstream words(line.substr(line.find(':') + 1));
    return {std::istream_iterator<std::string>(words), {}};
  }
  return {};
}

bool includes(const std::set<std::string>& flags, std::initializer_list<const char*> wanted) {
  return std::all_of(wanted.begin(), wanted.end(), [&](const char* flag) { return flags.contains(flag); });
}

// Features of gcc -march=haswell and -march=skylake-avx512 by the kernel's names (abm is lzcnt and popcnt), without
// those that compilers use on request alone.
TEST(InstructionSets, AreUsableIfTheProcessorHasEveryFeatureThatCompilersUse) {
  const std::set<std::string> flags = flags_of_processor();
  ASSERT_FALSE(flags.empty());
  const bool avx2 = includes(
      flags, {"sse4_2", "popcnt", "avx", "avx2", "fma", "f16c", "bmi1", "bmi2", "abm", "movbe", "aes", "pclmulqdq"});
  const bool avx512 = avx2 && includes(flags, {"avx512f", "avx512cd", "avx512bw", "avx512dq", "avx512vl"});
  std::vector<InstructionSet> expected = {InstructionSet::baseline};
  if (avx2) expected.push_back(InstructionSet::avx2);
  if (avx512) expected.push_back(InstructionSet::avx512);
  const auto usable = usable_instruction_sets();
  EXPECT_EQ(std::vector<InstructionSet>(usable.begin(), usable.end()), expected);
}
#endif

}  // namespace
}  // namespace weir
