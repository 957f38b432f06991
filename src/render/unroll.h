// Unrolls loops in the source of a shader.
//
// The software renderer keeps arrays that a loop indexes in memory unless its compiler unrolls the loop, which Mesa's
// does not do for long bodies; with constant indices they stay in registers. Drawing then takes a quarter of the time.
#pragma once

#include <map>
#include <string>

namespace weir {

// Every `for (int NAME = 0; NAME < LIMIT; ++NAME)` with its statement or block, LIMIT being a number or one of the
// constants, becomes so many blocks with the number in place of the name. Throws std::invalid_argument for a limit that
// is neither, or a block that does not end.
std::string unrolled(std::string source, const std::map<std::string, int>& constants);

}  // namespace weir
