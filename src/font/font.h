// The one typeface of overlays and plots, DejaVu Sans (Bitstream Vera licence: free to embed), inside the program, so
// that no font has to be found on the machine that runs it.
#pragma once

#include <cstddef>
#include <span>

namespace weir {

// A TrueType file, as FT_New_Memory_Face takes it; valid for the life of the program.
std::span<const std::byte> font_dejavu_sans();

}  // namespace weir
