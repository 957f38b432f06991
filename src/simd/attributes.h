// Compiler attributes of vectorised loops.
#pragma once

#define WEIR_INLINE inline __attribute__((always_inline))
// Inlines every call within: a call in a loop would spill registers to memory.
#define WEIR_FLATTEN __attribute__((flatten))
