// What loops over registers ask of the compiler.
#pragma once

#define WEIR_INLINE inline __attribute__((always_inline))
// Every call within is inlined: one in a loop would send registers through memory.
#define WEIR_FLATTEN __attribute__((flatten))
