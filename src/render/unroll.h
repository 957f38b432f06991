// Loops of a shader written out before it is compiled.
//
// Software rendering keeps an array that a loop indexes in memory, element by element, unless the compiler unrolls the
// loop, and Mesa's gives up on long bodies; with every index a number the array lives in registers. Drawing takes a
// quarter of the time so.
#pragma once

#include <map>
#include <string>

namespace weir {

// Every `for (int NAME = 0; NAME < LIMIT; ++NAME)` with its statement or block, LIMIT being a number or one of the
// constants, becomes so many blocks with the number in place of the name. Throws std::invalid_argument for a limit that
// is neither, or a block that does not end.
std::string unrolled(std::string source, const std::map<std::string, int>& constants);

}  // namespace weir
