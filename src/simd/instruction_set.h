// Which instructions the solver's loops use: chosen when the program runs, from those that it was built with.
#pragma once

#include <span>
#include <string_view>

namespace weir {

// In the order of preference, the last first. `baseline` runs on every processor of the architecture.
enum class InstructionSet { baseline, avx2, avx512 };

std::string_view name_of(InstructionSet set);

// Those that this program was built with and this processor has.
std::span<const InstructionSet> usable_instruction_sets();

// The one named by WEIR_INSTRUCTION_SET, else the last usable one. Throws UsageError for a name that is not usable.
InstructionSet default_instruction_set();

// Throws UsageError, naming those that are usable.
InstructionSet instruction_set_by_name(std::string_view name,
                                       std::span<const InstructionSet> usable = usable_instruction_sets());

}  // namespace weir
