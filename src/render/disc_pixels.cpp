#include "render/disc_pixels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <new>

namespace weir {

namespace {

constexpr float far = 1e38f;  // squared pixels
constexpr std::int32_t place_bits = 255;
// A disc's edge is spread over so many pixels to both sides.
constexpr float half_edge = 2.0f / 3;
// What is known of a square: its blocks hold something; it is to be drawn.
constexpr std::uint8_t holds = 1;
constexpr std::uint8_t shows = 2;
constexpr int blocks_a_square = square_blocks * square_blocks;

}  // namespace

// Where the loop over discs writes.
struct DiscPixels::Sheet {
  Block* blocks = nullptr;
  std::uint8_t* filled = nullptr;
  int columns = 0;  // squares
  int width = 0;    // pixels
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

// Vectors to places in the picture and in the colour map.
struct ToPicture {
  glm::vec4 scale;
  glm::vec4 offset;
};

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

WEIR_INLINE void add_disc(const Sheet& sheet, float x, float y, std::int32_t place) {
  // Pixels whose middle is within reach. Casting truncates towards zero: sums are kept positive, and ends may be one more
  // than needed, where nothing is covered.
  const int left = static_cast<int>(std::max(x - sheet.reach - 0.5f, -1.0f) + 1);
  const int top = static_cast<int>(std::max(y - sheet.reach - 0.5f, -1.0f) + 1);
  const int right = static_cast<int>(std::min(x + sheet.reach - 0.5f, static_cast<float>(sheet.width - 1)));
  const int bottom = static_cast<int>(std::min(y + sheet.reach - 0.5f, static_cast<float>(sheet.height - 1)));
  const int left_block = left / block_width;
  const int right_block = right / block_width;
  const int top_block = top / block_height;
  const int bottom_block = bottom / block_height;
  // The chroma of a block takes from the pixel to its left.
  const int last_column = std::min((right + 1) / square_width, sheet.columns - 1);
  for (int row = top_block / square_blocks; row <= bottom_block / square_blocks; ++row) {
    sheet.filled[row * sheet.columns + last_column] |= shows;
    for (int column = left_block / square_blocks; column <= right_block / square_blocks; ++column) {
      const int square = row * sheet.columns + column;
      Block* blocks = sheet.blocks + static_cast<std::size_t>(square) * blocks_a_square;
      if ((sheet.filled[square] & holds) == 0) {
        sheet.filled[square] |= holds | shows;
        const EightWhole nothing = EightWhole{} + std::bit_cast<std::int32_t>(far);
        for (int k = 0; k < blocks_a_square; ++k) blocks[k] = {nothing, nothing};
      }
      const Part part{std::max(left_block - column * square_blocks, 0), std::max(top_block - row * square_blocks, 0),
                      std::min(right_block - column * square_blocks, square_blocks - 1),
                      std::min(bottom_block - row * square_blocks, square_blocks - 1)};
      add_to_square(blocks, part, static_cast<float>(column * square_width) - x,
                    static_cast<float>(row * square_height) - y, place);
    }
  }
}

WEIR_INLINE void add_discs(const Sheet& sheet, std::span<const glm::vec4> particles, const ToPicture& view) {
  const auto right_end = static_cast<float>(sheet.width) + sheet.reach;
  const auto lower_end = static_cast<float>(sheet.height) + sheet.reach;
  for (const glm::vec4& particle : particles) {
    const float x = particle.x * view.scale.x + view.offset.x;
    const float y = particle.y * view.scale.y + view.offset.y;
    const float place = particle.w * view.scale.w + view.offset.w;
    // Written so that what is not a number is left out.
    if (x > -sheet.reach && x < right_end && y > -sheet.reach && y < lower_end && place == place)
      add_disc(sheet, x, y, static_cast<std::int32_t>(std::clamp(place, 0.0f, 255.0f) + 0.5f));
  }
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

WEIR_INLINE void colors_of(const EightWhole& keys, const Colormap& colors, EightWhole& rgb) {
  const EightWhole places = keys & place_bits;
  for (int k = 0; k < 8; ++k) rgb[k] = static_cast<std::int32_t>(colors[static_cast<std::size_t>(places[k])]);
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
  void (*add)(const Sheet& sheet, std::span<const glm::vec4> particles, const ToPicture& view);
  void (*resolve)(const Block* blocks, const Look& look, Texel* texels);
};

namespace {

void add_narrow(const Sheet& sheet, std::span<const glm::vec4> particles, const ToPicture& view) {
  add_discs(sheet, particles, view);
}
void resolve_narrow(const Block* blocks, const Look& look, Texel* texels) { resolve_square(blocks, look, texels); }

WEIR_WIDE void add_wide(const Sheet& sheet, std::span<const glm::vec4> particles, const ToPicture& view) {
  add_discs(sheet, particles, view);
}
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
    : loops_(loops(wide_registers)), width_(width), height_(height), columns_(Squares(width, height).columns()) {}

void DiscPixels::add(std::span<const glm::vec4> particles, const glm::vec4& scale, const glm::vec4& offset,
                     double radius, const Colormap& colors) {
  if (!blocks_) {
    filled_ = Squares(width_, height_).filled();
    // Not written to: memory on which no disc ever falls is never really there.
    blocks_.reset(
        static_cast<Block*>(std::aligned_alloc(alignof(Block), filled_.size() * blocks_a_square * sizeof(Block))));
    if (!blocks_) throw std::bad_alloc();
  }
  radius_ = radius;
  colors_ = colors;
  const Sheet sheet{blocks_.get(), filled_.data(), columns_, width_, height_, static_cast<float>(radius) + half_edge};
  loops_.add(sheet, particles, {scale, offset});
}

void DiscPixels::mark(Squares& squares) const {
  std::vector<std::uint8_t>& filled = squares.filled();
  for (std::size_t square = 0; square < filled_.size(); ++square)
    if ((filled_[square] & shows) != 0) filled[square] = 1;
}

void DiscPixels::take(const Squares& squares, double opacity, Texel* texels) {
  // The smooth step's spread about its middle, (4/3)^2 / 20, adds as much to the area as this takes away.
  const double edge = std::sqrt(std::max(radius_ * radius_ - 4.0 / 45, 0.0));
  const Look look{static_cast<float>(edge), static_cast<float>(radius_), static_cast<float>(opacity), &colors_};
  for (std::size_t square = 0; square < squares.first_texels().size(); ++square) {
    const std::uint32_t first = squares.first_texels()[square];
    if (first == Squares::empty) continue;
    if ((filled_[square] & holds) == 0)
      std::fill_n(texels + first, square_texels, Texel{});
    else
      loops_.resolve(&blocks_[square * blocks_a_square], look, texels + first);
  }
  std::fill(filled_.begin(), filled_.end(), std::uint8_t{0});
}

}  // namespace weir
