#include "render/canvas.h"

#include <gtest/gtest.h>

#include "font/font.h"

namespace weir {
namespace {

Image filled(int width, int height, std::uint8_t value, std::uint8_t alpha) {
  Image image{width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height, value)};
  for (std::size_t k = 3; k < image.rgba.size(); k += 4) image.rgba[k] = alpha;
  return image;
}

TEST(Canvas, BlendsOverAnOpaquePixel) {
  Image image = filled(1, 1, 100, 255);
  blend(image, 0, 0, {200, 100, 0}, 51);  // a fifth
  EXPECT_EQ(image.rgba, (std::vector<std::uint8_t>{120, 100, 80, 255}));
}

// Porter and Duff 1984, "over": alpha = a + b (1 - a), colour = (a A + b (1 - a) B) / alpha.
TEST(Canvas, BlendsOverAPartlyClearPixel) {
  Image image = filled(1, 1, 100, 102);  // 0.4
  blend(image, 0, 0, {200, 100, 0}, 51);
  EXPECT_EQ(image.rgba[3], 133);  // 0.2 + 0.4 * 0.8 = 0.52
  EXPECT_NEAR(image.rgba[0], (0.2 * 200 + 0.32 * 100) / 0.52, 0.6);
  EXPECT_NEAR(image.rgba[2], (0.32 * 100) / 0.52, 0.6);
}

TEST(Canvas, OnAClearPixelKeepsTheColourStraight) {
  Image image = filled(1, 1, 0, 0);
  blend(image, 0, 0, {200, 100, 50}, 10);
  EXPECT_EQ(image.rgba, (std::vector<std::uint8_t>{200, 100, 50, 10}));
}

TEST(Canvas, StaysInThePicture) {
  Image image = filled(4, 4, 0, 255);
  fill(image, {-5, -5, 2, 99}, {9, 9, 9});
  EXPECT_EQ(image.pixel(1, 3)[0], 9);
  EXPECT_EQ(image.pixel(2, 0)[0], 0);
  Font font(font_dejavu_sans());
  draw_text(image, font, 40, -10, 2, "Wide", {255, 255, 255});
  draw_text_upwards(image, font, 40, 1, 300, "Wide", {255, 255, 255});
}

TEST(Font, DigitsAreEquallyWideAtEverySize) {
  Font font(font_dejavu_sans());
  for (int size = 9; size < 60; ++size)
    for (const char* digit : {"1", "7", "9", "\u2007"})
      EXPECT_EQ(font.width(digit, size), font.width("0", size)) << size;
}

TEST(Font, HasTheSymbolsOfTheOverlay) {
  Font font(font_dejavu_sans());
  for (const char32_t mark : {U'✓', U'✗', U'−', U'³', U'µ'})
    EXPECT_NE(font.glyph(mark, 20).coverage, font.glyph(0xfffe, 20).coverage);
  EXPECT_EQ(font.width("✓", 25), font.width("✗", 25));
}

// A capital I at 100 pixels: DejaVu Sans' stem is 0.0986 em wide and its capitals 0.729 em high.
TEST(Font, GlyphsHaveTheNominalSize) {
  Font font(font_dejavu_sans());
  const Glyph& letter = font.glyph(U'I', 100);
  EXPECT_EQ(letter.height, 73);
  EXPECT_EQ(letter.top, 73);
  double area = 0;
  for (const std::uint8_t value : letter.coverage) area += value / 255.0;
  EXPECT_NEAR(area / letter.height, 9.86, 0.2);
}

TEST(Font, ReadsUtf8) {
  EXPECT_EQ(code_points("aü€\U0001F30A"), U"aü€\U0001F30A");
  EXPECT_EQ(code_points("a\xff"
                        "b"),
            U"a\ufffd"
            U"b");
  EXPECT_EQ(code_points("\xc3"), U"\ufffd");
  EXPECT_EQ(code_points("\xe2\x82z"), U"\ufffdz");
}

}  // namespace
}  // namespace weir
