#include "render/ball_pixels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <new>

#include "render/eight.h"

namespace weir {

namespace {

constexpr float full = 1024;  // of a pixel's area
constexpr float far = 1e38f;  // m
constexpr float nowhere_hidden = std::numeric_limits<float>::infinity();

int across(int pixels, int unit) { return (pixels + unit - 1) / unit; }

}  // namespace

// Aligned for the widest loop: without AVX the compiler would be content with half.
struct alignas(sizeof(Eight)) BallPixels::Block {
  Eight nearest;  // depth of the surface, m
  Eight second;
  Eight covered;  // in 1/1024; grows beyond a whole pixel
  EightWhole nearest_ball;
  EightWhole second_ball;
};

// A ball covers less of a pixel as the squared distance grows, from all to none over about a pixel, in the middle of
// which lies the edge: the integral is the area of the disc. Its surface is a paraboloid, which meets another where a
// sphere does, if both are equally far.
struct BallPixels::Seen {
  float x = 0;  // pixels
  float y = 0;
  float front = 0;   // m, of the nearest point
  float radius = 0;  // m
  float curve = 0;   // m per squared pixel
  float most = 0;    // the share of a pixel is middle - slope * squared distance, from 0 to most, in 1/1024
  float middle = 0;
  float slope = 0;
  float touched = 0;  // squared distance, pixels, from which on the share is 0
};

namespace {

using Block = BallPixels::Block;
using Seen = BallPixels::Seen;

WEIR_INLINE void share_of(const Seen& seen, const Eight& squared, Eight& share) {
  const Eight zero{};
  const Eight one = zero + 1;
  const Eight most = zero + seen.most;
  share = seen.middle - seen.slope * squared;
  share = share < most ? share : most;
  share = share > zero ? share : zero;
  const Eight floor = __builtin_convertvector(__builtin_convertvector(share, EightWhole), Eight);
  share = floor + (floor < share ? one : zero);
}

// The pixels of two blocks, the first of which has its upper left corner in `left`, `top`. Whether all of them are
// covered and show two balls then.
WEIR_INLINE bool add_to_blocks(Block* blocks, const Seen& seen, std::int32_t number, int left, int top) {
  const Eight zero{};
  const Eight far_away = zero + far;
  const Eight deepest = zero + seen.radius;
  const Eight whole = zero + full;
  const Eight off_x = middle_x + (static_cast<float>(left) - seen.x);
  const Eight squared_x = off_x * off_x;
  const EightWhole ball = EightWhole{} + number;
  EightWhole done = ~EightWhole{};
  for (int k = 0; k < 2; ++k, top += block_height) {
    Block& block = blocks[k];
    const Eight off_y = middle_y + (static_cast<float>(top) - seen.y);
    const Eight squared = squared_x + off_y * off_y;
    Eight share;
    share_of(seen, squared, share);
    Eight deep = seen.curve * squared;
    deep = deep < deepest ? deep : deepest;
    const Eight key = share > zero ? seen.front + deep : far_away;
    const Eight nearest = block.nearest;
    const Eight second = block.second;
    const EightWhole nearest_ball = block.nearest_ball;
    const EightWhole second_ball = block.second_ball;
    const EightWhole is_nearer = key < nearest;
    // What covers all of a pixel is its own second: so nothing behind it is looked for.
    const EightWhole is_all = share >= whole;
    const Eight behind = is_nearer & ~is_all ? nearest : key;
    const EightWhole behind_ball = is_nearer & ~is_all ? nearest_ball : ball;
    const EightWhole is_second = is_nearer | (behind < second);
    const Eight covered = block.covered + share;
    const Eight new_second = is_second ? behind : second;
    block.covered = covered;
    block.nearest = is_nearer ? key : nearest;
    block.nearest_ball = is_nearer ? ball : nearest_ball;
    block.second = new_second;
    block.second_ball = is_second ? behind_ball : second_ball;
    done &= (covered >= whole) & (new_second < far_away);
  }
  return all_lanes(done);
}

using Added = BallPixels::Added;

// Of the balls of eight pixels: how far each pixel is to the right of its ball's centre and up, in radii as drawn; the
// ball's colour and its share of the pixel.
struct Look {
  Eight right;
  Eight up;
  Eight share;
  EightWhole color;
};

WEIR_INLINE void look_at(const Added* balls, const EightWhole& numbers, int left, int top, Look& look) {
  std::array<Eight, 4> of;  // each of a ball in the upper row and of the one below
  for (int k = 0; k < 4; ++k) {
    Four upper;
    Four lower;
    std::memcpy(&upper, &balls[numbers[k]], sizeof(upper));
    std::memcpy(&lower, &balls[numbers[k + 4]], sizeof(lower));
    of[k] = __builtin_shufflevector(upper, lower, 0, 1, 2, 3, 4, 5, 6, 7);
  }
  const Eight low_a = __builtin_shufflevector(of[0], of[1], 0, 8, 1, 9, 4, 12, 5, 13);
  const Eight low_b = __builtin_shufflevector(of[2], of[3], 0, 8, 1, 9, 4, 12, 5, 13);
  const Eight high_a = __builtin_shufflevector(of[0], of[1], 2, 10, 3, 11, 6, 14, 7, 15);
  const Eight high_b = __builtin_shufflevector(of[2], of[3], 2, 10, 3, 11, 6, 14, 7, 15);
  const std::array<Eight, 4> fields = {__builtin_shufflevector(low_a, low_b, 0, 1, 8, 9, 4, 5, 12, 13),
                                       __builtin_shufflevector(low_a, low_b, 2, 3, 10, 11, 6, 7, 14, 15),
                                       __builtin_shufflevector(high_a, high_b, 0, 1, 8, 9, 4, 5, 12, 13),
                                       __builtin_shufflevector(high_a, high_b, 2, 3, 10, 11, 6, 7, 14, 15)};
  const Eight off_x = middle_x + static_cast<float>(left) - fields[0];
  const Eight off_y = middle_y + static_cast<float>(top) - fields[1];
  const Eight zero{};
  const Eight least = zero + least_ball;
  const Eight size = fields[2];
  const Eight drawn = size > least ? size : least;
  const Eight part = 1 / drawn;
  const Eight most = full * (size * part) * (size * part);
  look.share = most * (0.5f + 0.5f * drawn - 0.5f * part * (off_x * off_x + off_y * off_y));
  look.share = look.share < most ? look.share : most;
  look.right = off_x * part;
  look.up = -off_y * part;
  std::memcpy(&look.color, &fields[3], sizeof(look.color));
}

// Red, green and blue of the balls where they are looked at: light from behind the viewer's left shoulder, some from
// everywhere, and a darker rim that sets neighbours apart.
WEIR_INLINE void shade(const Look& look, std::array<Eight, 3>& rgb) {
  const Eight zero{};
  const Eight one = zero + 1;
  Eight towards = 1 - (look.right * look.right + look.up * look.up);
  towards = towards > zero ? towards : zero;
  square_root(towards);
  Eight diffuse = 0.7071f * towards + 0.5657f * look.up - 0.4243f * look.right;
  diffuse = diffuse > zero ? diffuse : zero;
  Eight inner = 2.5f * towards;
  inner = inner < one ? inner : one;
  const Eight light = (0.42f + 0.58f * diffuse) * (0.55f + 0.45f * inner);
  for (int channel = 0; channel < 3; ++channel)
    rgb[channel] = light * __builtin_convertvector(look.color >> (16 - 8 * channel) & 255, Eight);
}

WEIR_INLINE void resolve_block(const Block& block, const Added* balls, float opacity, int left, int top,
                               Texel* texels) {
  const Eight zero{};
  const Eight whole = zero + full;
  const Eight covered = block.covered < whole ? block.covered : whole;
  Look look;
  look_at(balls, block.nearest_ball, left, top, look);
  std::array<Eight, 3> rgb;
  shade(look, rgb);
  // What the nearest leaves of the covered part is the second's; those behind it look alike.
  const EightWhole is_front = look.share >= covered;
  if (!all_lanes(is_front)) {
    const Eight one = zero + 1;
    const Eight front = is_front ? one : look.share / covered;
    look_at(balls, block.second_ball, left, top, look);
    std::array<Eight, 3> behind;
    shade(look, behind);
    for (int channel = 0; channel < 3; ++channel) rgb[channel] = front * rgb[channel] + (1 - front) * behind[channel];
  }
  const Eight alpha = covered * (opacity * 255 / full);
  EightWhole packed;
  pack(rgb, alpha, packed);
  packed = covered > zero ? packed : EightWhole{};
  std::memcpy(texels, &packed, sizeof(packed));
}

}  // namespace

struct BallPixels::Loops {
  bool (*add)(Block* blocks, const Seen& seen, std::int32_t number, int left, int top);
  void (*resolve)(const Block& block, const Added* balls, float opacity, int left, int top, Texel* texels);
};

namespace {

bool add_narrow(Block* blocks, const Seen& seen, std::int32_t number, int left, int top) {
  return add_to_blocks(blocks, seen, number, left, top);
}
void resolve_narrow(const Block& block, const Added* balls, float opacity, int left, int top, Texel* texels) {
  resolve_block(block, balls, opacity, left, top, texels);
}

WEIR_WIDE bool add_wide(Block* blocks, const Seen& seen, std::int32_t number, int left, int top) {
  return add_to_blocks(blocks, seen, number, left, top);
}
WEIR_WIDE void resolve_wide(const Block& block, const Added* balls, float opacity, int left, int top, Texel* texels) {
  resolve_block(block, balls, opacity, left, top, texels);
}

}  // namespace

const BallPixels::Loops& BallPixels::loops(bool wide_registers) {
  static constexpr Loops narrow{add_narrow, resolve_narrow};
  static constexpr Loops wide{add_wide, resolve_wide};
  return wide_registers ? wide : narrow;
}

BallPixels::BallPixels(const PixelRange& pixels, bool wide_registers)
    : all_(pixels),
      loops_(loops(wide_registers)),
      columns_(across(pixels.right + 1 - pixels.left, square_width) * square_width / cell_side),
      rows_(across(pixels.bottom + 1 - pixels.top, square_height) * square_height / cell_side) {}

void BallPixels::begin(double radius, double focal, double typical_reach) {
  radius_ = static_cast<float>(radius);
  focal_ = static_cast<float>(focal);
  const std::size_t cells = static_cast<std::size_t>(columns_) * rows_;
  if (!blocks_) {
    // Not written to: memory on which no ball ever falls is never really there.
    blocks_.reset(static_cast<Block*>(std::aligned_alloc(alignof(Block), cells * cell_blocks * sizeof(Block))));
    if (!blocks_) throw std::bad_alloc();
  }
  added_.clear();
  touched_.assign(cells, 0);
  hidden_from_.assign(cells, nowhere_hidden);
  const double area = std::clamp(2 * typical_reach, 1.0 * cell_side, 1.0 * widest_area);
  area_shift_ = std::bit_width(static_cast<unsigned>(area) - 1U);
  area_columns_ = across(columns_ * cell_side, 1 << area_shift_);
  areas_.assign(static_cast<std::size_t>(area_columns_) * across(rows_ * cell_side, 1 << area_shift_), Area{});
  // Cells without a pixel of ours are never open.
  for (int top = 0; top <= all_.bottom - all_.top; top += cell_side)
    for (int left = 0; left <= all_.right - all_.left; left += cell_side) ++areas_[area_at(left, top)].open;
}

BallPixels::Seen BallPixels::seen_as(const ScreenBall& ball) const {
  const float size = radius_ * focal_ / ball.depth;
  const float drawn = std::max(size, least_ball);
  Seen seen;
  seen.x = ball.x;
  seen.y = ball.y;
  seen.front = ball.depth - radius_;
  seen.radius = radius_;
  seen.curve = radius_ / (drawn * drawn);
  seen.most = full * size * size / (drawn * drawn);
  seen.slope = seen.most * 0.5f / drawn;
  seen.middle = seen.most * (0.5f + 0.5f * drawn);
  seen.touched = 1.001f * drawn * (drawn + 1);  // and a little for rounding
  return seen;
}

PixelRange BallPixels::pixels_of(const ScreenBall& ball) const {
  const float reach = std::max(radius_ * focal_ / ball.depth, least_ball);
  const auto within = [](float at, int first, int last) {
    return static_cast<int>(std::min(std::max(at, static_cast<float>(first)), static_cast<float>(last)));
  };
  return {within(ball.x - reach, all_.left, all_.right), within(ball.y - reach, all_.top, all_.bottom),
          within(ball.x + reach, all_.left, all_.right), within(ball.y + reach, all_.top, all_.bottom)};
}

bool BallPixels::hides(const PixelRange& pixels, float front) const {
  const int first = std::max(pixels.left - all_.left, 0) >> area_shift_;
  const int last = std::min(pixels.right - all_.left, all_.right - all_.left) >> area_shift_;
  const int last_row = (pixels.bottom - all_.top) >> area_shift_;
  for (int row = (pixels.top - all_.top) >> area_shift_; row <= last_row; ++row) {
    const Area* areas = &areas_[static_cast<std::size_t>(row) * area_columns_];
    for (int column = first; column <= last; ++column)
      // Written so that what is not a number is not hidden.
      if (areas[column].open > 0 || !(front >= areas[column].hidden_from)) return false;
  }
  return true;
}

namespace {

void prefetch(const BallPixels::Block* blocks) {
  const char* bytes = reinterpret_cast<const char*>(blocks);
  for (std::size_t line = 0; line < 5; ++line) __builtin_prefetch(bytes + 64 * line, 1);
}

}  // namespace

void BallPixels::add(const ScreenBall& ball) {
  const auto number = static_cast<std::int32_t>(added_.size());
  added_.push_back({ball.x, ball.y, radius_ * focal_ / ball.depth, ball.color});
  const Seen seen = seen_as(ball);
  const PixelRange pixels = pixels_of(ball);
  constexpr float last_middle = cell_side - 0.5f;
  const int last_row = (pixels.bottom - all_.top) / cell_side;
  for (int row = (pixels.top - all_.top) / cell_side; row <= last_row; ++row) {
    const int top = all_.top + row * cell_side;
    // From the centre to the middle of the nearest pixels of the row, then how far the ball reaches along them.
    const float from_top = ball.y - static_cast<float>(top);
    const float off_y = std::max({0.5f - from_top, from_top - last_middle, 0.0f});
    const float reach = std::sqrt(std::max(seen.touched - off_y * off_y, 0.0f));
    const int left_most = std::max(static_cast<int>(ball.x - reach - 0.5f), pixels.left) - all_.left;
    const int right_most = std::min(static_cast<int>(ball.x + reach + 0.5f), pixels.right) - all_.left;
    for (int column = left_most / cell_side; column <= right_most / cell_side; ++column) {
      const std::size_t cell = cell_at(column, row);
      const float hidden_from = hidden_from_[cell];
      if (seen.front >= hidden_from) continue;
      Block* blocks = &blocks_[cell * cell_blocks];
      prefetch(blocks + columns_ * cell_blocks);  // the row below comes next
      if (touched_[cell] == 0) {
        touched_[cell] = 1;
        const Eight nothing = Eight{} + far;
        for (int k = 0; k < cell_blocks; ++k) blocks[k] = {nothing, nothing, Eight{}, EightWhole{}, EightWhole{}};
      }
      if (loops_.add(blocks, seen, number, all_.left + column * cell_side, top) && hidden_from == nowhere_hidden)
        close(column, row);
    }
  }
}

void BallPixels::close(int column, int row) {
  const std::size_t cell = cell_at(column, row);
  const Eight upper = blocks_[cell * cell_blocks].second;
  const Eight lower = blocks_[cell * cell_blocks + 1].second;
  const Eight further = upper > lower ? upper : lower;
  const auto larger_of = [&](int a, int b) { return std::max(further[a], further[b]); };
  const float furthest =
      std::max(std::max(larger_of(0, 1), larger_of(2, 3)), std::max(larger_of(4, 5), larger_of(6, 7)));
  hidden_from_[cell] = furthest;
  Area& area = areas_[area_at(column * cell_side, row * cell_side)];
  --area.open;
  area.hidden_from = std::max(area.hidden_from, furthest);
}

void BallPixels::mark(Squares& squares) const {
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      if (touched_.empty() || touched_[cell_at(column, row)] == 0) continue;
      const int square_row = (all_.top + row * cell_side) / square_height;
      std::uint8_t* line = &squares.filled()[static_cast<std::size_t>(square_row) * squares.columns()];
      const int left = all_.left + column * cell_side;
      line[left / square_width] = 1;
      // The chroma of a block takes from the pixel to its left.
      if ((left + cell_side) / square_width < squares.columns()) line[(left + cell_side) / square_width] = 1;
    }
}

void BallPixels::take(const Squares& squares, double opacity, Texel* texels) const {
  constexpr int square_columns = square_width / cell_side;
  constexpr int square_rows = square_height / cell_side;
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const int left = all_.left + column * cell_side;
      const int top = all_.top + row * cell_side;
      const std::uint32_t first =
          squares
              .first_texels()[static_cast<std::size_t>(top / square_height) * squares.columns() + left / square_width];
      if (first == Squares::empty) continue;
      const std::size_t cell = cell_at(column, row);
      for (int k = 0; k < cell_blocks; ++k) {
        const int line = row % square_rows * cell_blocks + k;
        Texel* to = texels + first + (line * square_blocks + column % square_columns) * block_texels;
        if (touched_[cell] == 0)
          std::fill_n(to, block_texels, Texel{});
        else
          loops_.resolve(blocks_[cell * cell_blocks + k], added_.data(), static_cast<float>(opacity), left,
                         top + k * block_height, to);
      }
    }
}

}  // namespace weir
