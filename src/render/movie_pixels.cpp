#include "render/movie_pixels.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace weir {

namespace {

// The blocks of one square, and what they are made of.
struct Part {
  const Texel* background;       // of the whole picture
  const Texel* particles;        // of the square; null: none are in it
  const Texel* left_particles;   // of the square to its left
  const std::uint8_t* texts;     // of the whole picture; null: none are here
  int columns;                   // of the picture, blocks
  int left, top, right, bottom;  // the square's blocks, the last ones not among them
  std::size_t width;             // of the picture, pixels
  std::uint8_t *y, *cb, *cr;     // planes of the whole picture
};

using Colors = std::array<Eight, 3>;  // RGB of 0 .. 255

WEIR_INLINE void channel_of(const EightWhole& pixels, int channel, Eight& values) {
  values = __builtin_convertvector(pixels >> (8 * channel) & 255, Eight);
}

WEIR_INLINE void load_rows(const void* upper, const void* lower, EightWhole& pixels) {
  FourWhole rows[2];
  std::memcpy(&rows[0], upper, sizeof(rows[0]));
  std::memcpy(&rows[1], lower, sizeof(rows[1]));
  pixels = __builtin_shufflevector(rows[0], rows[1], 0, 1, 2, 3, 4, 5, 6, 7);
}

WEIR_INLINE void lay_over(const EightWhole& top, Colors& colors) {
  if (all_lanes(top == EightWhole{})) return;
  Eight alpha;
  channel_of(top, 3, alpha);
  alpha *= 1.0f / 255;
  for (int channel = 0; channel < 3; ++channel) {
    Eight of_top;
    channel_of(top, channel, of_top);
    colors[channel] += alpha * (of_top - colors[channel]);
  }
}

WEIR_INLINE void color_block(const Part& part, int column, int row, Colors& colors) {
  const std::size_t upper = static_cast<std::size_t>(block_height * row) * part.columns + column;
  EightWhole pixels;
  load_rows(part.background + upper, part.background + upper + part.columns, pixels);
  for (int channel = 0; channel < 3; ++channel) channel_of(pixels, channel, colors[channel]);
  const bool within = column >= part.left;
  if (const Texel* particles = within ? part.particles : part.left_particles) {
    const int block = (row - part.top) * square_blocks + (within ? column - part.left : square_blocks - 1);
    std::memcpy(&pixels, particles + static_cast<std::size_t>(block) * block_texels, sizeof(pixels));
    lay_over(pixels, colors);
  }
  if (part.texts != nullptr) {
    const std::uint8_t* texts = part.texts + upper * sizeof(Texel);
    load_rows(texts, texts + part.columns * sizeof(Texel), pixels);
    lay_over(pixels, colors);
  }
}

// [Rec. ITU-R BT.709-6, 3.2 to 3.5], 8 bits, from RGB of 0 .. 255
constexpr std::array<float, 3> luma_weights = {0.2126f, 0.7152f, 0.0722f};
constexpr float luma_scale = 219.0f / 255;
// Two samples of Cb, two of Cr, of sums of eight pixels.
constexpr float blue_scale = 224.0f / 255 / 1.8556f / 8;
constexpr float red_scale = 224.0f / 255 / 1.5748f / 8;
constexpr Four chroma_scale = {blue_scale, blue_scale, red_scale, red_scale};

WEIR_INLINE void luma_of(const Colors& colors, Eight& luma) {
  luma = luma_weights[0] * colors[0] + luma_weights[1] * colors[1] + luma_weights[2] * colors[2];
}

// A channel less the luma, both rows added up.
WEIR_INLINE Four difference(const Eight& channel, const Eight& luma) {
  const Eight both = channel - luma;
  return __builtin_shufflevector(both, both, 0, 1, 2, 3) + __builtin_shufflevector(both, both, 4, 5, 6, 7);
}

// Blue and red differences of a block's columns.
struct Differences {
  Four even;  // blue of columns 0 and 2, then red
  Four odd;   // blue of columns 1 and 3, then red
};
WEIR_INLINE void differences_of(const Colors& colors, const Eight& luma, Differences& differences) {
  const Four blue = difference(colors[2], luma);
  const Four red = difference(colors[0], luma);
  differences.even = __builtin_shufflevector(blue, red, 0, 2, 4, 6);
  differences.odd = __builtin_shufflevector(blue, red, 1, 3, 5, 7);
}

// A sample of chroma lies beside the left edge of its 2 x 2 pixels and takes a quarter of the pixel to its left. `left`
// are the odd columns of the block to the left.
WEIR_INLINE std::uint32_t chroma_of(const Differences& of, const Four& left) {
  const Four before = __builtin_shufflevector(left, of.odd, 1, 4, 3, 6);
  const FourWhole samples = truncated(128.5f + chroma_scale * (before + 2 * of.even + of.odd));
  std::array<std::uint32_t, 2> bytes;
  pack_bytes(__builtin_shufflevector(samples, samples, 0, 1, 2, 3, 0, 1, 2, 3), bytes);
  return bytes[0];
}

WEIR_INLINE void draw_part(const Part& part) {
  Colors colors;
  Eight luma;
  for (int row = part.top; row < part.bottom; ++row) {
    // The picture goes on to the left as it begins.
    color_block(part, std::max(part.left - 1, 0), row, colors);
    luma_of(colors, luma);
    Differences differences;
    differences_of(colors, luma, differences);
    Four left =
        part.left > 0 ? differences.odd : __builtin_shufflevector(differences.even, differences.even, 0, 0, 2, 2);
    std::uint8_t* const upper = part.y + static_cast<std::size_t>(block_height * row) * part.width;
    std::uint8_t* const lower = upper + part.width;
    std::uint8_t* const cb = part.cb + row * (part.width / 2);
    std::uint8_t* const cr = part.cr + row * (part.width / 2);
    for (int column = part.left; column < part.right; ++column) {
      color_block(part, column, row, colors);
      luma_of(colors, luma);
      differences_of(colors, luma, differences);
      const std::uint32_t chroma = chroma_of(differences, left);
      left = differences.odd;
      std::array<std::uint32_t, 2> rows;
      pack_bytes(__builtin_convertvector(16.5f + luma_scale * luma, EightWhole), rows);
      const std::size_t x = static_cast<std::size_t>(column) * block_width;
      const auto put = [&](std::size_t pixels) {
        std::memcpy(upper + x, &rows[0], pixels);
        std::memcpy(lower + x, &rows[1], pixels);
        std::memcpy(cb + x / 2, &chroma, pixels / 2);
        std::memcpy(cr + x / 2, reinterpret_cast<const std::uint8_t*>(&chroma) + 2, pixels / 2);
      };
      if (x + block_width <= part.width)
        put(block_width);
      else
        put(block_width / 2);  // widths are even
    }
  }
}

void draw_narrow(const Part& part) { draw_part(part); }
WEIR_WIDE void draw_wide(const Part& part) { draw_part(part); }

int across(int pixels, int unit) { return (pixels + unit - 1) / unit; }

}  // namespace

MoviePixels::MoviePixels(int width, int height, std::span<const IntBox> text_boxes, bool wide_registers)
    : columns_(across(width, block_width)),
      rows_(across(height, block_height)),
      square_columns_(across(width, square_width)),
      wide_registers_(wide_registers),
      has_texts_(static_cast<std::size_t>(square_columns_) * across(height, square_height), 0) {
  mark(text_boxes, has_texts_);
}

void MoviePixels::mark(std::span<const IntBox> boxes, std::vector<std::uint8_t>& squares) const {
  for (const IntBox& box : boxes)
    for (int row = box.top / square_height; row < across(box.bottom, square_height); ++row)
      for (int column = box.left / square_width; column < across(box.right, square_width); ++column)
        squares[static_cast<std::size_t>(row) * square_columns_ + column] = 1;
}

void MoviePixels::draw(const MovieLayers& layers, int row, MovieImage& image) const {
  for (const std::uint32_t square : layers.squares.to_draw(row))
    draw_square(layers, {static_cast<int>(square & 0xffff), row}, image);
}

void MoviePixels::draw(const MovieLayers& layers, std::span<const IntBox> boxes, MovieImage& image) const {
  std::vector<std::uint8_t> touched(has_texts_.size(), 0);
  mark(boxes, touched);
  for (std::size_t square = 0; square < touched.size(); ++square)
    if (touched[square] != 0)
      draw_square(layers, {static_cast<int>(square % square_columns_), static_cast<int>(square / square_columns_)},
                  image);
}

void MoviePixels::draw_square(const MovieLayers& layers, Place place, MovieImage& image) const {
  const std::size_t square = static_cast<std::size_t>(place.row) * square_columns_ + place.column;
  const auto particles_of = [&](std::size_t of) {
    const std::uint32_t first = layers.squares.first_texels()[of];
    return first == Squares::empty ? nullptr : layers.particles + first;
  };
  Part part{};
  part.background = layers.background.data();
  part.particles = particles_of(square);
  part.left_particles = place.column > 0 ? particles_of(square - 1) : nullptr;
  part.texts = has_texts_[square] != 0 ? layers.texts.rgba.data() : nullptr;
  part.columns = columns_;
  part.left = place.column * square_blocks;
  part.top = place.row * square_blocks;
  part.right = std::min(part.left + square_blocks, columns_);
  part.bottom = std::min(part.top + square_blocks, rows_);
  part.width = static_cast<std::size_t>(image.width);
  part.y = image.y.data();
  part.cb = image.cb.data();
  part.cr = image.cr.data();
  wide_registers_ ? draw_wide(part) : draw_narrow(part);
}

}  // namespace weir
