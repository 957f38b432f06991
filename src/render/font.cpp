#include "render/font.h"

#include <fmt/format.h>
#include <ft2build.h>

#include <stdexcept>
#include FT_FREETYPE_H

namespace weir {

struct Font::Face {
  FT_Library library = nullptr;
  FT_Face face = nullptr;

  explicit Face(std::string_view file) {
    check(FT_Init_FreeType(&library), "FT_Init_FreeType");
    const FT_Error error = FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(file.data()),
                                              static_cast<FT_Long>(file.size()), 0, &face);
    if (error != 0) FT_Done_FreeType(library);
    check(error, "FT_New_Memory_Face");
  }
  ~Face() {
    FT_Done_Face(face);
    FT_Done_FreeType(library);
  }
  Face(const Face&) = delete;
  Face& operator=(const Face&) = delete;

  static void check(FT_Error error, const char* call) {
    if (error != 0) throw std::runtime_error(fmt::format("the overlay's font: {} failed with error {}", call, error));
  }
};

Font::Font(std::string_view file) : face_(std::make_unique<Face>(file)) {}
Font::~Font() = default;

const Glyph& Font::glyph(char32_t character, int size) {
  const auto [place, is_new] = glyphs_.try_emplace({character, size});
  Glyph& glyph = place->second;
  if (!is_new) return glyph;
  FT_Face face = face_->face;
  Face::check(FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size)), "FT_Set_Pixel_Sizes");
  // Light hinting moves outlines vertically only: horizontal stems align with pixel rows, and widths are unchanged.
  Face::check(FT_Load_Char(face, character, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT), "FT_Load_Char");
  const FT_GlyphSlot slot = face->glyph;
  const FT_Bitmap& bitmap = slot->bitmap;
  glyph.left = slot->bitmap_left;
  glyph.top = slot->bitmap_top;
  glyph.width = static_cast<int>(bitmap.width);
  glyph.height = static_cast<int>(bitmap.rows);
  glyph.advance = static_cast<int>((slot->advance.x + 32) / 64);  // FreeType counts in 1/64 pixel
  glyph.coverage.reserve(std::size_t{bitmap.width} * bitmap.rows);
  for (int row = 0; row < glyph.height; ++row) {
    const unsigned char* line = bitmap.buffer + static_cast<std::ptrdiff_t>(row) * bitmap.pitch;
    glyph.coverage.insert(glyph.coverage.end(), line, line + bitmap.width);
  }
  return glyph;
}

int Font::width(std::string_view utf8, int size) {
  int total = 0;
  for (const char32_t character : code_points(utf8)) total += glyph(character, size).advance;
  return total;
}

std::u32string code_points(std::string_view utf8) {
  constexpr char32_t unreadable = 0xfffd;
  std::u32string all;
  for (std::size_t k = 0; k < utf8.size();) {
    const auto lead = static_cast<unsigned char>(utf8[k++]);
    const int following = lead < 0x80           ? 0
                          : (lead >> 5) == 0x6  ? 1
                          : (lead >> 4) == 0xe  ? 2
                          : (lead >> 3) == 0x1e ? 3
                                                : -1;
    if (following < 0) {
      all.push_back(unreadable);
      continue;
    }
    char32_t point = following == 0 ? lead : lead & (0x3f >> following);
    int read = 0;
    while (read < following && k < utf8.size() && (static_cast<unsigned char>(utf8[k]) >> 6) == 0x2) {
      point = point << 6 | (static_cast<unsigned char>(utf8[k++]) & 0x3f);
      ++read;
    }
    all.push_back(read == following ? point : unreadable);
  }
  return all;
}

}  // namespace weir
