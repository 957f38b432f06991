// Screen tiles that the rasterisers have filled, and the offsets of their pixels in the buffer for the device.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace weir {

// What one fragment shades; as in compose.frag.
inline constexpr int block_width = 4;  // pixels
inline constexpr int block_height = 2;

// Pixels are made, and the device is told where there is anything to draw, square by square: so many blocks wide and
// high.
inline constexpr int square_blocks = 8;
inline constexpr int square_width = block_width * square_blocks;  // pixels
inline constexpr int square_height = block_height * square_blocks;

class Squares {
 public:
  // The first texel of a square without pixels: before all others stand those of one that is empty, so that nobody has
  // to ask.
  static constexpr std::uint32_t empty = 0;

  Squares(int width, int height);  // pixels

  int columns() const { return columns_; }
  int rows() const { return rows_; }

  // Row by row, 1 for each that there are pixels for; to be written between begin(), which sets all to 0, and close().
  std::vector<std::uint8_t>& filled() { return filled_; }
  void begin();
  // The number of texels of all filled squares and the empty one. Those filled or `stale` are to be drawn; then `stale`
  // says which are filled. An empty `stale` means all.
  std::size_t close(std::vector<std::uint8_t>& stale);

  // After close(). For each square its first texel.
  std::span<const std::uint32_t> first_texels() const { return first_; }
  // As compose.vert reads them: a square's column below 16 bits of its row.
  std::span<const std::uint32_t> to_draw() const { return to_draw_; }
  std::span<const std::uint32_t> to_draw(int row) const {
    return to_draw().subspan(first_to_draw_[row], first_to_draw_[row + 1] - first_to_draw_[row]);
  }

 private:
  int columns_;
  int rows_;
  std::vector<std::uint8_t> filled_;
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> to_draw_;
  std::vector<std::size_t> first_to_draw_;  // of each row, and the end
};

}  // namespace weir
