// The instruction set of the solver's loops, chosen at run time among those that the program was built with.
#pragma once

#include <span>
#include <string_view>

namespace weir {

// In ascending order of preference. `baseline` runs on every processor of the architecture.
enum class InstructionSet { baseline, avx2, avx512 };

std::string_view name_of(InstructionSet set);

// Sets that the program was built with and the processor supports.
std::span<const InstructionSet> usable_instruction_sets();

// The set named by WEIR_INSTRUCTION_SET, else the last usable one. Throws UsageError for a name that is not usable.
InstructionSet default_instruction_set();

// Throws UsageError, naming the usable sets.
InstructionSet instruction_set_by_name(std::string_view name,
                                       std::span<const InstructionSet> usable = usable_instruction_sets());

}  // namespace weir
