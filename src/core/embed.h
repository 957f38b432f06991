// Files embedded in the program, independent of the working directory and of where the program is installed.
#pragma once

#include <cstddef>
#include <string_view>

// Defines `std::string_view embedded_<name>()`, the content of `file`, in this translation unit. The assembler copies
// the file verbatim, as compiling a generated array of a font's 740 kB takes seconds; CMake rebuilds when the file
// changes (OBJECT_DEPENDS). Symbols are hidden: program and modules may each have a copy.
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
