#include "render/overlay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "render/test_scene.h"
#include "support/golden.h"

namespace weir::test {
namespace {

const std::vector<OverlayItem> everything = {OverlayItem::title, OverlayItem::time, OverlayItem::colorbar,
                                             OverlayItem::scalebar, OverlayItem::cfl};

Still sized(int width, int height) {
  Still still = dam_break();
  still.scene.render.size = {width, height};
  return still;
}

OverlayLayout layout_of(const Still& still) {
  return Overlay(still.scene, color_range(still.scene, still.static_scene)).layout();
}

std::vector<IntBox> boxes(const OverlayLayout& layout) {
  std::vector<IntBox> all;
  for (const std::optional<IntBox>& box : {layout.title, layout.time, layout.cfl, layout.scale, layout.colorbar})
    if (box) all.push_back(*box);
  return all;
}

bool apart(const IntBox& a, const IntBox& b) {
  return a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
}

// The overlay alone, over a picture of one colour.
Image overlay_image(const Still& still) {
  Overlay overlay(still.scene, color_range(still.scene, still.static_scene));
  const auto [width, height] = still.scene.render.size;
  Image image{width, height, std::vector<std::uint8_t>(std::size_t{4} * width * height, 255)};
  overlay.draw_fixed(projection_of(View2D{Vec3(0), 3}, width, height), image);
  overlay.draw_changing(still.frame, image);
  return image;
}

// Pixels in which one channel is well above another.
int pixels_with(const Image& image, const IntBox& box, int strong, int weak) {
  int count = 0;
  for (int y = box.top; y < box.bottom; ++y)
    for (int x = box.left; x < box.right; ++x)
      if (image.pixel(x, y)[strong] > image.pixel(x, y)[weak] + 60) ++count;
  return count;
}

bool only_white(const Image& image) {
  return std::all_of(image.rgba.begin(), image.rgba.end(), [](std::uint8_t v) { return v == 255; });
}

TEST(Overlay, NeverOverlapsItselfAndLeavesRoomForTheScene) {
  for (const int width : {16, 64, 160, 240, 320, 480, 640, 1280, 1920, 3840})
    for (const int height : {16, 48, 120, 180, 240, 360, 720, 1080, 2160})
      for (const char* title : {"Dam break", "A very long title of a scene that says everything about itself"})
        for (const int dimension : {2, 3}) {
          Still still = sized(width, height);
          still.scene.title = title;
          still.scene.dimension = dimension;
          still.scene.duration = 100;
          const OverlayLayout layout = layout_of(still);
          const std::vector<IntBox> all = boxes(layout);
          const PixelBox& c = layout.content;
          const IntBox content{static_cast<int>(c.left), static_cast<int>(c.top), static_cast<int>(c.right),
                               static_cast<int>(c.bottom)};
          ASSERT_GT(c.width(), 0) << width << "x" << height;
          ASSERT_GT(c.height(), 0) << width << "x" << height;
          for (std::size_t a = 0; a < all.size(); ++a) {
            ASSERT_TRUE(all[a].left >= 0 && all[a].top >= 0 && all[a].right <= width && all[a].bottom <= height)
                << width << "x" << height;
            ASSERT_TRUE(apart(all[a], content)) << width << "x" << height;
            for (std::size_t b = 0; b < a; ++b) ASSERT_TRUE(apart(all[a], all[b])) << width << "x" << height;
          }
        }
}

TEST(Overlay, ShowsEverythingFrom320By240On) {
  for (const auto& [width, height] : {std::pair{320, 240}, {640, 360}, {1080, 1920}, {1920, 1080}, {3840, 2160}})
    EXPECT_EQ(boxes(layout_of(sized(width, height))).size(), 5U) << width << "x" << height;
}

TEST(Overlay, SizesFollowTheHeight) {
  EXPECT_EQ(layout_of(sized(1920, 1080)).size, 25);
  EXPECT_EQ(layout_of(sized(3840, 2160)).size, 50);
  EXPECT_EQ(layout_of(sized(320, 240)).size, 9);
}

// Drawn pixels are within the boxes of the layout, except for the rim of a panel.
TEST(Overlay, DrawsInsideItsBoxes) {
  for (const auto& [width, height] : {std::pair{320, 240}, {640, 480}, {1920, 1080}}) {
    const Still still = sized(width, height);
    Image image = overlay_image(still);
    const OverlayLayout layout = layout_of(still);
    const int slack = layout.size / 4 + 1;
    for (const IntBox& box : boxes(layout))
      for (int y = std::max(0, box.top - slack); y < std::min(height, box.bottom + slack); ++y)
        for (int x = std::max(0, box.left - slack); x < std::min(width, box.right + slack); ++x)
          std::fill_n(image.pixel(x, y), 4, std::uint8_t{255});
    EXPECT_TRUE(only_white(image)) << width << "x" << height;
  }
}

TEST(Overlay, EachItemCanBeLeftOut) {
  for (const OverlayItem item : everything) {
    Still still = dam_break();
    std::erase(still.scene.render.overlay, item);
    EXPECT_EQ(boxes(layout_of(still)).size(), 4U);
    still.scene.render.overlay = {item};
    EXPECT_EQ(boxes(layout_of(still)).size(), 1U);
    EXPECT_FALSE(only_white(overlay_image(still)));
  }
}

TEST(Overlay, NothingIsDrawnWhenItIsEmpty) {
  Still still = dam_break();
  still.scene.render.overlay = {};
  EXPECT_TRUE(only_white(overlay_image(still)));
}

TEST(Overlay, ColorBarHasTheMapsEnds) {
  for (const ColormapName name : {ColormapName::viridis, ColormapName::coolwarm}) {
    Still still = sized(640, 480);
    still.scene.render.color.map = name;
    const Image image = overlay_image(still);
    const IntBox bar = layout_of(still).bar;
    ASSERT_GT(bar.height(), 200);
    const int middle = (bar.left + bar.right) / 2;
    for (int y = bar.top; y < bar.bottom; ++y) {
      const std::uint32_t color = colormap(name)[colormap_index((bar.bottom - 0.5 - y) / bar.height(), {0, 1})];
      ASSERT_EQ(image.pixel(middle, y)[0], color >> 16) << y;
      ASSERT_EQ(image.pixel(middle, y)[1], color >> 8 & 0xff) << y;
      ASSERT_EQ(image.pixel(middle, y)[2], color & 0xff) << y;
    }
  }
}

TEST(Overlay, ConditionIsGreenWhenMetAndRedWhenNot) {
  for (const Theme theme : {Theme::light, Theme::dark}) {
    Still still = sized(640, 480);
    still.scene.render.theme = theme;
    const IntBox box = *layout_of(still).cfl;
    constexpr int red = 0;
    constexpr int green = 1;
    still.frame.cfl_met = true;
    EXPECT_GT(pixels_with(overlay_image(still), box, green, red), 40);
    EXPECT_EQ(pixels_with(overlay_image(still), box, red, green), 0);
    still.frame.cfl_met = false;
    EXPECT_GT(pixels_with(overlay_image(still), box, red, green), 40);
    EXPECT_EQ(pixels_with(overlay_image(still), box, green, red), 0);
  }
}

// From frame to frame only the pixels of the digits change.
TEST(Overlay, TimeKeepsItsPosition) {
  Still still = sized(640, 480);
  still.scene.duration = 12;
  const IntBox box = *layout_of(still).time;
  const auto first_column = [&](double time) {
    still.frame.time = time;
    const Image image = overlay_image(still);
    for (int x = box.left; x < box.right; ++x)
      for (int y = box.top; y < box.bottom; ++y)
        if (image.pixel(x, y)[0] < 128) return x;
    return -1;
  };
  const int column = first_column(0);
  EXPECT_GE(column, box.left);
  for (const double time : {0.111, 8.888, 9.999, 10.0, 11.111}) EXPECT_EQ(first_column(time), column) << time;
}

// The bar is the longest run of text colour in a row of its box; 3 m across 640 pixels.
TEST(Overlay, ScaleBarHasTheLengthOfItsLabel) {
  Still still = sized(640, 480);
  still.scene.render.overlay = {OverlayItem::scalebar};
  const Image image = overlay_image(still);
  const IntBox box = *layout_of(still).scale;
  const Rgb text = palette(Theme::light).text;
  int longest = 0;
  for (int y = box.top; y < box.bottom; ++y) {
    int run = 0;
    for (int x = box.left; x < box.right; ++x) {
      run = image.pixel(x, y)[0] == text.r ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  // At most 16 % of 640 pixels are 48 cm, so 20 cm: 42.7 pixels.
  EXPECT_EQ(longest, 43);
}

TEST(Overlay, AnItemOverFluidHasAPanelBehindIt) {
  Still still = sized(640, 480);
  Overlay overlay(still.scene, {0, 5});
  Image dark{640, 480, std::vector<std::uint8_t>(std::size_t{4} * 640 * 480, 0)};
  for (std::size_t k = 3; k < dark.rgba.size(); k += 4) dark.rgba[k] = 255;
  overlay.draw_fixed(projection_of(View2D{Vec3(0), 3}, 640, 480), dark);
  const IntBox title = *overlay.layout().title;
  EXPECT_EQ(dark.pixel(title.left - 1, title.top - 1)[0], 190);  // 190/255 of white over black
  EXPECT_EQ(dark.pixel(320, 240)[0], 0);
}

}  // namespace
}  // namespace weir::test
