// The one typeface of overlays and plots, DejaVu Sans (Bitstream Vera licence: free to embed), inside the program, so
// that no font has to be found on the machine that runs it.
#pragma once

#include <string_view>

namespace weir {

// TrueType files, as FT_New_Memory_Face takes them; valid for the life of the program.
std::string_view font_dejavu_sans();
std::string_view font_dejavu_sans_bold();

}  // namespace weir
