#include "render/dots.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <new>

#include "render/four.h"

namespace weir {

namespace {

constexpr float full = 1024;  // of a pixel's area

// Of dots, the parts that fall on two columns (or rows) of pixels, if their centres lie so far beyond the middle of the
// first; or on three, so far beyond the middle of the second. They have the sum 1 and their centre there. A dot of less
// than a pixel takes two, a larger one is spread (0 .. 1) so far that no pixel has more than its own area of it.
template <int Side>
std::array<Four, Side> parts(Four beyond, float spread) {
  if constexpr (Side == 2) {
    return {1 - beyond, beyond};
  } else {
    const Four behind = larger(beyond, all(0));
    const Four before = behind - beyond;
    const Four first = (1 - spread) * before + spread * (0.25f - 0.5f * beyond);
    const Four last = (1 - spread) * behind + spread * (0.25f + 0.5f * beyond);
    return {first, 1 - first - last, last};
  }
}

// Larger than 0 for a dot of more than a pixel.
double spread_of(double radius) { return 2 - 2 / (std::sqrt(std::numbers::pi) * radius); }

}  // namespace

Dots::Dots(int width, int height)
    : width_(width),
      height_(height),
      square_stride_((width + square_width - 1) / square_width + 2),
      square_rows_((height + square_height - 1) / square_height + 2) {}

void Dots::add(std::span<const glm::vec4> particles, const glm::vec4& scale, const glm::vec4& offset, double radius,
               const Colormap& colors) {
  if (!sums_) {
    // From calloc: memory on which no dot ever falls is never really there.
    const std::size_t squares = square_stride_ * square_rows_;
    sums_.reset(static_cast<Sum*>(std::calloc(squares * square_width * square_height, sizeof(Sum))));
    if (!sums_) throw std::bad_alloc();
    filled_.assign(squares, 0);
  }
  if (spread_of(radius) > 0)
    add_to_pixels<3>(particles, scale, offset, radius, colors);
  else
    add_to_pixels<2>(particles, scale, offset, radius, colors);
}

template <int Side>
void Dots::add_to_pixels(std::span<const glm::vec4> particles, const glm::vec4& scale, const glm::vec4& offset,
                         double radius, const Colormap& colors) {
  std::array<Four, 256> lanes_of;
  for (std::size_t k = 0; k < colors.size(); ++k)
    lanes_of[k] = Four{static_cast<float>(colors[k] >> 16), static_cast<float>(colors[k] >> 8 & 0xff),
                       static_cast<float>(colors[k] & 0xff), 1};
  const auto area = static_cast<float>(full * std::numbers::pi * radius * radius);
  const auto spread = static_cast<float>(spread_of(radius));
  constexpr float reach = Side == 2 ? 0.5f : 1.0f;
  const Four right_end = all(static_cast<float>(width_) + reach);
  const Four lower_end = all(static_cast<float>(height_) + reach);
  // The first of the pixels whose middle is less than Side / 2 away, counted from the corner of the margin.
  constexpr float half = 0.5f * (Side - 1);
  constexpr float middle = Side == 2 ? 0.0f : 0.5f;
  const std::size_t square_stride = square_stride_;
  const std::size_t stride = square_stride * square_width;
  Sum* const sums = sums_.get();
  std::uint8_t* const filled = filled_.data();

  visit_by_four(particles, [&](const std::array<Four, 4>& four) {
    const Four x = four[0] * scale.x + offset.x;
    const Four y = four[1] * scale.y + offset.y;
    const Four place = four[3] * scale.w + offset.w;
    const FourWhole seen = (x > -reach) & (x < right_end) & (y > -reach) & (y < lower_end) & (place == place);
    const Four from_left = x + (square_width - half);
    const Four from_top = y + (square_height - half);
    const FourWhole column = truncated(from_left);
    const FourWhole row = truncated(from_top);
    const FourWhole color = truncated(larger(smaller(place, all(255)), all(0)) + 0.5f);
    const std::array<Four, Side> across = parts<Side>(from_left - floats(column) - middle, spread);
    const std::array<Four, Side> down = parts<Side>(from_top - floats(row) - middle, spread);
    std::array<std::array<Four, Side>, Side> shares;
    for (int r = 0; r < Side; ++r)
      for (int c = 0; c < Side; ++c) shares[r][c] = floats(truncated(area * down[r] * across[c] + 0.5f));
    // One to the right as well: the chroma of a block takes from the pixel to its left.
    const FourWhole left = column / square_width;
    const FourWhole right = (column + Side) / square_width;
    const FourWhole top = row / square_height;
    const FourWhole bottom = (row + (Side - 1)) / square_height;

    for (std::size_t k = 0; k < 4; ++k) {
      if (seen[k] == 0) continue;
      const Four lanes = lanes_of[color[k]];
      Sum* sum = sums + row[k] * stride + column[k];
      for (int r = 0; r < Side; ++r, sum += stride)
        for (int c = 0; c < Side; ++c) sum[c] += reinterpret_cast<Sum>(truncated(shares[r][c][k] * lanes));
      std::uint8_t* const upper = filled + top[k] * square_stride;
      std::uint8_t* const lower = filled + bottom[k] * square_stride;
      upper[left[k]] = upper[right[k]] = lower[left[k]] = lower[right[k]] = 1;
    }
  });
}

void Dots::mark(Squares& squares) {
  for (std::size_t row = 1; row + 1 < square_rows_; ++row)
    for (std::size_t column = 1; column + 1 < square_stride_; ++column)
      if (filled_[row * square_stride_ + column] != 0) squares.filled()[(row - 1) * squares.columns() + column - 1] = 1;
}

// Four pixels at once.
Texel Dots::resolved(const Sum* sums, float opacity) {
  std::array<Four, 4> four;
  for (std::size_t k = 0; k < 4; ++k) four[k] = floats(reinterpret_cast<FourWhole>(sums[k]));
  const auto [red, green, blue, share] = transposed(four);
  const Four part = 1 / larger(share, all(1));
  const Four alpha = smaller(share, all(full)) * (opacity * 255 / full);
  const auto byte = [](Four value) { return truncated(value + 0.5f); };
  return std::bit_cast<Texel>(byte(red * part) | byte(green * part) << 8 | byte(blue * part) << 16 | byte(alpha) << 24);
}

void Dots::take(const Squares& squares, double opacity, Texel* texels, const RowTaken& taken) {
  const std::size_t stride = square_stride_ * square_width;
  for (std::size_t row = 0; row + 2 < square_rows_; ++row) {
    for (std::size_t column = 0; column + 2 < square_stride_; ++column) {
      const std::uint32_t first = squares.first_texels()[row * squares.columns() + column];
      if (first == Squares::empty) continue;
      Texel* to = texels + first;
      Sum* top = &sums_[(row + 1) * square_height * stride + (column + 1) * square_width];
      for (int y = 0; y < square_height; y += block_height, top += block_height * stride)
        for (int x = 0; x < square_width; x += block_width)
          for (int line = 0; line < block_height; ++line) {
            Sum* sums = top + line * stride + x;
            *to++ = resolved(sums, static_cast<float>(opacity));
            std::fill_n(sums, block_width, Sum{});
          }
    }
    taken(static_cast<int>(row));
  }
  std::fill(filled_.begin(), filled_.end(), std::uint8_t{0});
}

}  // namespace weir
