// Discs on the picture, sorted into bins: rectangles of whole blocks, each with a list of the discs that touch it. A
// disc has an entry in every bin that it touches, so whoever shades a block reads one list from end to end.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace weir {

// What one fragment shades; as in gather.frag.
inline constexpr int block_width = 4;  // pixels
inline constexpr int block_height = 2;

// The device is told square by square where there is anything to draw: 2^square_shift blocks wide and high.
inline constexpr int square_shift = 3;
inline constexpr int square_width = block_width << square_shift;  // pixels
inline constexpr int square_height = block_height << square_shift;

class Bins {
 public:
  // The first entry and the one past the last. Past before first: nothing to do, the target shows it already.
  struct Range {
    std::uint32_t first = 1;
    std::uint32_t past = 0;
  };

  Bins(int width, int height);  // pixels

  // Bins of 2^shift x 2^shift blocks, all empty.
  void reset(int shift);
  int shift() const { return shift_; }
  int columns() const { return columns_; }
  std::size_t size() const { return ranges_.size(); }

  // Counts discs {x, y, reach}, pixels: a disc touches no pixel whose square lies further than `reach` from its centre
  // across or down. Finite values, and each must touch the picture.
  template <class Disc>
  void count(std::span<const Disc> discs);
  // Counts so many entries of one bin.
  void count(std::size_t bin, std::uint32_t entries) { next_[bin] += entries; }
  // Calls visit(column, row) for each bin that a disc touches.
  template <class Disc, class Visit>
  void visit(const Disc& disc, const Visit& visit) const;

  // After all are counted: the number of entries. A bin that is neither filled nor `stale` is marked as nothing to do;
  // then `stale` says which are filled.
  std::size_t close(std::vector<std::uint8_t>& stale);
  std::span<const Range> ranges() const { return ranges_; }
  // Whether there is anything to do in a square of so many blocks; after close().
  bool any_to_do(int column, int row, int blocks) const;

  // Writes entry_of(disc) to its places, in the order of the discs within each bin.
  template <class Disc, class Entry, class EntryOf>
  void scatter(std::span<const Disc> discs, Entry* entries, const EntryOf& entry_of);

 private:
  std::size_t at(int column, int row) const { return static_cast<std::size_t>(row) * columns_ + column; }

  int width_;
  int height_;
  int shift_ = 0;
  int columns_ = 0;
  std::vector<std::uint32_t> next_;  // counts, then where the next entry goes
  std::vector<Range> ranges_;
};

template <class Disc, class Visit>
void Bins::visit(const Disc& disc, const Visit& visit) const {
  // The pixels that it touches, in -1 .. width: casting truncates towards zero, so the sum is kept positive. A block's
  // first chroma sample takes from the pixel left of the block, hence one more to the right.
  const int left = static_cast<int>(std::max(disc.x - disc.reach, -1.0f) + 1) - 1;
  const int right = static_cast<int>(std::min(disc.x + disc.reach, static_cast<float>(width_ - 1)) + 1);
  const int top = static_cast<int>(std::max(disc.y - disc.reach, 0.0f));
  const int bottom = static_cast<int>(std::min(disc.y + disc.reach, static_cast<float>(height_ - 1)));
  const int first = std::max(left, 0) / block_width >> shift_;
  const int last = std::min(right / block_width >> shift_, columns_ - 1);
  for (int row = top / block_height >> shift_; row <= bottom / block_height >> shift_; ++row)
    for (int column = first; column <= last; ++column) visit(column, row);
}

template <class Disc>
void Bins::count(std::span<const Disc> discs) {
  for (const Disc& disc : discs) visit(disc, [&](int column, int row) { ++next_[at(column, row)]; });
}

template <class Disc, class Entry, class EntryOf>
void Bins::scatter(std::span<const Disc> discs, Entry* entries, const EntryOf& entry_of) {
  for (const Disc& disc : discs) {
    const Entry entry = entry_of(disc);
    visit(disc, [&](int column, int row) { entries[next_[at(column, row)]++] = entry; });
  }
}

}  // namespace weir
