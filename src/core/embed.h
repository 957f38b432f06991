// Files as part of the program: found whatever the working directory and wherever the program stands.
#pragma once

#include <cstddef>
#include <string_view>

// Makes `std::string_view embedded_<name>()`, the content of `file`, in this file alone. The assembler copies it in as
// it is, where a generated array of a font's 740 kB would take the compiler seconds; CMake has to rebuild when the file
// changes (OBJECT_DEPENDS). Hidden symbols: program and modules each may carry a copy without seeing the other's.
#define WEIR_EMBED(name, file)                                                                                  \
  asm(".pushsection .rodata\n"                                                                                  \
      ".balign 16\n"                                                                                            \
      ".hidden weir_embedded_" #name "\n.hidden weir_embedded_" #name                                           \
      "_end\n"                                                                                                  \
      ".globl weir_embedded_" #name "\n.globl weir_embedded_" #name "_end\nweir_embedded_" #name                \
      ":\n"                                                                                                     \
      ".incbin \"" file "\"\nweir_embedded_" #name                                                              \
      "_end:\n"                                                                                                 \
      ".popsection\n");                                                                                         \
  extern "C" {                                                                                                  \
  extern const char weir_embedded_##name[] __attribute__((visibility("hidden")));                               \
  extern const char weir_embedded_##name##_end[] __attribute__((visibility("hidden")));                         \
  }                                                                                                             \
  static std::string_view embedded_##name() {                                                                   \
    return {weir_embedded_##name, static_cast<std::size_t>(weir_embedded_##name##_end - weir_embedded_##name)}; \
  }
