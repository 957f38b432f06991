// Glyphs of a TrueType font as grayscale coverage, through FreeType.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

namespace weir {

struct Glyph {
  int left = 0;                        // pixels from the pen to the first column
  int top = 0;                         // pixels from the baseline up to the first row
  int width = 0;                       // pixels
  int height = 0;                      // pixels
  int advance = 0;                     // pixels to the next pen position
  std::vector<std::uint8_t> coverage;  // row by row; 255: the whole pixel
};

class Font {
 public:
  // `file` is the font file's content and must outlive the font.
  explicit Font(std::string_view file);
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  // `size` is the em in pixels. A missing character has the glyph of the box.
  const Glyph& glyph(char32_t character, int size);
  int width(std::string_view utf8, int size);  // pixels

 private:
  struct Face;
  std::unique_ptr<Face> face_;
  std::map<std::pair<char32_t, int>, Glyph> glyphs_;
};

// Code points of UTF-8 text; an invalid byte becomes U+FFFD.
std::u32string code_points(std::string_view utf8);

}  // namespace weir
