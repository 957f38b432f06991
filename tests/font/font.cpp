#include "font/font.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include <gtest/gtest.h>

namespace weir {
namespace {

TEST(Font, IsDejaVuSansAsFreeTypeReadsIt) {
  const auto bytes = font_dejavu_sans();
  FT_Library library = nullptr;
  ASSERT_EQ(FT_Init_FreeType(&library), 0);
  FT_Face face = nullptr;
  ASSERT_EQ(FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(bytes.data()),
                               static_cast<FT_Long>(bytes.size()), 0, &face),
            0);
  EXPECT_STREQ(face->family_name, "DejaVu Sans");
  EXPECT_STREQ(face->style_name, "Book");
  // Greek rho, superscript two and the middle dot stand in axis titles.
  for (const FT_ULong character : {0x3c1ul, 0xb2ul, 0xb7ul}) EXPECT_NE(FT_Get_Char_Index(face, character), 0u);
  FT_Done_Face(face);
  FT_Done_FreeType(library);
}

}  // namespace
}  // namespace weir
