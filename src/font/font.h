// The typeface of overlays and plots, DejaVu Sans (Bitstream Vera licence: free to embed), embedded in the program: no
// font has to be installed.
#pragma once

#include <string_view>

namespace weir {

// TrueType files, as FT_New_Memory_Face takes them; valid for the life of the program.
std::string_view font_dejavu_sans();
std::string_view font_dejavu_sans_bold();

}  // namespace weir
