// A register of floats, used as the number type of the equations.
//
// Compiled once per instruction set, each time in a namespace of that set's name (WEIR_INSTRUCTION_SET), so that the
// linker never merges functions of different sets.
#pragma once

#if !defined(WEIR_INSTRUCTION_SET)
#error "only sources that are built per instruction set may include this"
#endif

#if defined(WEIR_PORTABLE_LANES)
#include "simd/lanes_portable.h"
#else
#include "simd/lanes_highway.h"
#endif
