#include "font/font.h"

// The assembler copies the file in as it is; a generated array of its 740 kB would take the compiler seconds. Hidden
// symbols: program and modules each may carry a copy without seeing the other's.
asm(R"(
    .pushsection .rodata
    .balign 16
    .hidden weir_font_begin
    .hidden weir_font_end
    .globl weir_font_begin
    .globl weir_font_end
weir_font_begin:
    .incbin ")" WEIR_FONT_FILE R"("
weir_font_end:
    .popsection
)");

extern "C" {
extern const std::byte weir_font_begin[] __attribute__((visibility("hidden")));
extern const std::byte weir_font_end[] __attribute__((visibility("hidden")));
}

namespace weir {

std::span<const std::byte> font_dejavu_sans() { return {weir_font_begin, weir_font_end}; }

}  // namespace weir
