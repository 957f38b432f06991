#include "render/disc_pixels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace weir {

namespace {

constexpr float far = 1e38f;  // squared pixels
constexpr std::int32_t place_bits = 255;
// A disc's edge is spread over so many pixels to both sides.
constexpr float half_edge = 2.0f / 3;
constexpr int blocks_a_square = square_blocks * square_blocks;

}  // namespace

// Where the loop over discs writes: a row of squares.
struct DiscPixels::Sheet {
  Block* blocks = nullptr;
  std::uint8_t* holds = nullptr;  // for each square whether its blocks hold something
  int row = 0;
  int width = 0;  // of the picture, pixels
  int height = 0;
  float reach = 0;  // the middle of a pixel that a disc covers is nearer to its centre, pixels
};

// How the loop over blocks makes colours of distances.
struct DiscPixels::Look {
  float edge = 0;    // see coverage_of()
  float radius = 0;  // pixels
  float opacity = 1;
  const Colormap* colors = nullptr;
};

namespace {

using Block = DiscPixels::Block;
using Sheet = DiscPixels::Sheet;
using Look = DiscPixels::Look;

// The first and the last of the pixels from 0 to `end` whose middle is within reach. Casting truncates towards zero:
// sums are kept positive, and ends may be one more than needed, where nothing is covered.
WEIR_INLINE int first_pixel(float centre, float reach) {
  return static_cast<int>(std::max(centre - reach - 0.5f, -1.0f) + 1);
}
WEIR_INLINE int last_pixel(float centre, float reach, int end) {
  return static_cast<int>(std::min(centre + reach - 0.5f, static_cast<float>(end - 1)));
}

WEIR_INLINE void lesser(const EightWhole& a, const EightWhole& b, EightWhole& of_both) { of_both = a < b ? a : b; }
WEIR_INLINE void greater(const EightWhole& a, const EightWhole& b, EightWhole& of_both) { of_both = a < b ? b : a; }

// The blocks from `left`, `top` to `right`, `bottom` of a square whose corner has that distance to the disc's centre.
struct Part {
  int left, top, right, bottom;  // blocks of the square
};
WEIR_INLINE void add_to_square(Block* blocks, const Part& part, float from_x, float from_y, std::int32_t place) {
  for (int row = part.top; row <= part.bottom; ++row) {
    const Eight off_y = middle_y + (from_y + static_cast<float>(row * block_height));
    const Eight squared_y = off_y * off_y;
    for (int column = part.left; column <= part.right; ++column) {
      const Eight off_x = middle_x + (from_x + static_cast<float>(column * block_width));
      const Eight squared = off_x * off_x + squared_y;
      const EightWhole key = (reinterpret_cast<EightWhole>(squared) & ~place_bits) | place;
      Block& block = blocks[row * square_blocks + column];
      const EightWhole nearest = block.nearest;
      EightWhole further;
      greater(nearest, key, further);
      lesser(block.second, further, block.second);
      lesser(nearest, key, block.nearest);
    }
  }
}

WEIR_INLINE void add_disc(const Sheet& sheet, const DiscPixels::Disc& disc) {
  const int top_of_row = sheet.row * square_height;
  const int left_block = first_pixel(disc.x, sheet.reach) / block_width;
  const int right_block = last_pixel(disc.x, sheet.reach, sheet.width) / block_width;
  const int top = std::max(first_pixel(disc.y, sheet.reach) - top_of_row, 0) / block_height;
  const int bottom =
      std::min(last_pixel(disc.y, sheet.reach, sheet.height) - top_of_row, square_height - 1) / block_height;
  for (int square = left_block / square_blocks; square <= right_block / square_blocks; ++square) {
    Block* blocks = sheet.blocks + static_cast<std::size_t>(square) * blocks_a_square;
    if (sheet.holds[square] == 0) {
      sheet.holds[square] = 1;
      const EightWhole nothing = EightWhole{} + std::bit_cast<std::int32_t>(far);
      for (int k = 0; k < blocks_a_square; ++k) blocks[k] = {nothing, nothing};
    }
    const Part part{std::max(left_block - square * square_blocks, 0), top,
                    std::min(right_block - square * square_blocks, square_blocks - 1), bottom};
    add_to_square(blocks, part, static_cast<float>(square * square_width) - disc.x,
                  static_cast<float>(top_of_row) - disc.y, disc.place);
  }
}

WEIR_INLINE void add_discs(const Sheet& sheet, std::span<const DiscPixels::Disc> discs) {
  for (const DiscPixels::Disc& disc : discs) add_disc(sheet, disc);
}

// How much of a pixel a disc covers, from the squared distance of its centre alone: a smooth step of 4/3 pixels, in the
// middle between edges along the pixels and across. It is off by 0.043 at most, where a straight edge along the pixels
// just touches one: that gets a step of 7/8 in place of 1. `edge` is such that the integral is the disc's area.
WEIR_INLINE void coverage_of(const Eight& squared, float edge, Eight& coverage) {
  const Eight zero{};
  const Eight one = zero + 1;
  Eight along = squared;
  square_root(along);
  along = 0.5f + (0.5f / half_edge) * (edge - along);
  along = along < one ? along : one;
  along = along > zero ? along : zero;
  coverage = along * along * (3 - 2 * along);
}

// From memory: to take each lane of a register costs more than to read the bytes that were just read.
WEIR_INLINE void colors_of(const EightWhole& keys, const Colormap& colors, EightWhole& rgb) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(&keys);
  constexpr int place = std::endian::native == std::endian::little ? 0 : 3;
  const auto color = [&](int k) { return static_cast<std::int32_t>(colors[bytes[4 * k + place]]); };
  rgb = EightWhole{color(0), color(1), color(2), color(3), color(4), color(5), color(6), color(7)};
}

WEIR_INLINE void resolve_block(const Block& block, const Look& look, Texel* texels) {
  const Eight zero{};
  const Eight one = zero + 1;
  const Eight nearest = reinterpret_cast<Eight>(block.nearest);
  const Eight second = reinterpret_cast<Eight>(block.second);
  Eight by_one;
  Eight by_two;
  coverage_of(nearest, look.edge, by_one);
  coverage_of(second, look.edge, by_two);
  Eight covered = by_one + by_two;
  covered = covered < one ? covered : one;
  // How much of the pixel lies on the nearest disc's side of the line between the two, were they tangent.
  Eight side = 0.5f + (second - nearest) * (0.25f / look.radius);
  side = side < one ? side : one;
  side = by_two > zero ? side : one;
  EightWhole front;
  EightWhole back;
  colors_of(block.nearest, *look.colors, front);
  colors_of(block.second, *look.colors, back);
  std::array<Eight, 3> rgb;
  for (int channel = 0; channel < 3; ++channel) {
    const Eight of_front = __builtin_convertvector(front >> (16 - 8 * channel) & 255, Eight);
    const Eight of_back = __builtin_convertvector(back >> (16 - 8 * channel) & 255, Eight);
    rgb[channel] = of_back + side * (of_front - of_back);
  }
  EightWhole pixels;
  pack(rgb, covered * (255 * look.opacity), pixels);
  pixels = covered > zero ? pixels : EightWhole{};
  std::memcpy(texels, &pixels, sizeof(pixels));
}

WEIR_INLINE void resolve_square(const Block* blocks, const Look& look, Texel* texels) {
  const EightWhole nothing = EightWhole{} + std::bit_cast<std::int32_t>(far);
  for (int k = 0; k < blocks_a_square; ++k, texels += block_texels) {
    if (all_lanes(blocks[k].nearest == nothing))
      std::fill_n(texels, block_texels, Texel{});
    else
      resolve_block(blocks[k], look, texels);
  }
}

}  // namespace

struct DiscPixels::Loops {
  void (*add)(const Sheet& sheet, std::span<const Disc> discs);
  void (*resolve)(const Block* blocks, const Look& look, Texel* texels);
};

namespace {

void add_narrow(const Sheet& sheet, std::span<const DiscPixels::Disc> discs) { add_discs(sheet, discs); }
void resolve_narrow(const Block* blocks, const Look& look, Texel* texels) { resolve_square(blocks, look, texels); }

WEIR_WIDE void add_wide(const Sheet& sheet, std::span<const DiscPixels::Disc> discs) { add_discs(sheet, discs); }
WEIR_WIDE void resolve_wide(const Block* blocks, const Look& look, Texel* texels) {
  resolve_square(blocks, look, texels);
}

}  // namespace

const DiscPixels::Loops& DiscPixels::loops(bool wide_registers) {
  static constexpr Loops narrow{add_narrow, resolve_narrow};
  static constexpr Loops wide{add_wide, resolve_wide};
  return wide_registers ? wide : narrow;
}

DiscPixels::DiscPixels(int width, int height, bool wide_registers)
    : loops_(loops(wide_registers)), width_(width), height_(height) {}

void DiscPixels::show(std::span<const glm::vec4> particles, const glm::vec4& scale, const glm::vec4& offset,
                      double radius, const Colormap& colors) {
  radius_ = radius;
  colors_ = colors;
  reach_ = static_cast<float>(radius) + half_edge;
  const float right_end = static_cast<float>(width_) + reach_;
  const float lower_end = static_cast<float>(height_) + reach_;
  discs_.clear();
  for (const glm::vec4& particle : particles) {
    const float x = particle.x * scale.x + offset.x;
    const float y = particle.y * scale.y + offset.y;
    const float place = particle.w * scale.w + offset.w;
    // Written so that what is not a number is left out.
    if (!(x > -reach_ && x < right_end && y > -reach_ && y < lower_end && place == place)) continue;
    const float above_nearest = std::clamp(place, 0.0f, 255.0f) + 0.5f;
    discs_.push_back({x, y, static_cast<std::int32_t>(above_nearest)});
  }
}

void DiscPixels::mark(Squares& squares) {
  // Sorted by rows of squares, twice if it lies in two.
  const auto top_row = [&](const Disc& disc) { return first_pixel(disc.y, reach_) / square_height; };
  const auto bottom_row = [&](const Disc& disc) { return last_pixel(disc.y, reach_, height_) / square_height; };
  const int columns = squares.columns();
  row_ends_.assign(squares.rows() + 1, 0);
  for (const Disc& disc : discs_) {
    const int left = first_pixel(disc.x, reach_) / square_width;
    // The chroma of a block takes from the pixel to its left.
    const int right = std::min((last_pixel(disc.x, reach_, width_) + 1) / square_width, columns - 1);
    for (int row = top_row(disc); row <= bottom_row(disc); ++row) {
      ++row_ends_[row + 1];
      std::uint8_t* line = &squares.filled()[static_cast<std::size_t>(row) * columns];
      for (int column = left; column <= right; ++column) line[column] = 1;
    }
  }
  std::partial_sum(row_ends_.begin(), row_ends_.end(), row_ends_.begin());
  by_rows_.resize(row_ends_.back());
  // What was the end of the row before moves to the end of each row.
  for (const Disc& disc : discs_)
    for (int row = top_row(disc); row <= bottom_row(disc); ++row) by_rows_[row_ends_[row]++] = disc;
}

void DiscPixels::take(const Squares& squares, double opacity, Texel* texels, const RowTaken& taken) {
  const auto columns = static_cast<std::size_t>(squares.columns());
  blocks_.resize(columns * blocks_a_square);
  holds_.resize(columns);
  // The smooth step's spread about its middle, (4/3)^2 / 20, adds as much to the area as this takes away.
  const double edge = std::sqrt(std::max(radius_ * radius_ - 4.0 / 45, 0.0));
  const Look look{static_cast<float>(edge), static_cast<float>(radius_), static_cast<float>(opacity), &colors_};
  std::size_t begin = 0;
  for (int row = 0; row < squares.rows(); ++row) {
    std::fill(holds_.begin(), holds_.end(), std::uint8_t{0});
    const std::size_t end = row_ends_[row];
    loops_.add({blocks_.data(), holds_.data(), row, width_, height_, reach_},
               std::span(by_rows_).subspan(begin, end - begin));
    begin = end;
    for (std::size_t column = 0; column < columns; ++column) {
      const std::uint32_t first = squares.first_texels()[row * columns + column];
      if (first == Squares::empty) continue;
      if (holds_[column] == 0)
        std::fill_n(texels + first, square_texels, Texel{});
      else
        loops_.resolve(&blocks_[column * blocks_a_square], look, texels + first);
    }
    taken(row);
  }
}

}  // namespace weir
