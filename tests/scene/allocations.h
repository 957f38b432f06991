// How much memory a test has asked for.
#pragma once

#include <cstddef>

namespace weir {

// Bytes that all calls of operator new together have asked for since the program began, freed or not.
std::size_t allocated_bytes();

}  // namespace weir
