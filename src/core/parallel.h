// Loops over fixed blocks: which elements share a block never depends on the number of threads, so sums keep their
// bits.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace weir {

// Small enough to balance, large enough that a block's bookkeeping vanishes.
constexpr std::size_t block_size = 256;

inline std::size_t block_count(std::size_t n) { return (n + block_size - 1) / block_size; }

// body(block, begin, end) for each block of 0 .. n, in any order, on `threads` threads. The body must not throw.
template <class Body>
void parallel_blocks(std::size_t n, int threads, const Body& body) {
  const auto blocks = static_cast<std::ptrdiff_t>(block_count(n));
  // No thread is woken that would find nothing to do.
  const int team = static_cast<int>(std::clamp<std::ptrdiff_t>(blocks / 4, 1, threads));
#pragma omp parallel for schedule(dynamic, 2) num_threads(team) if (team > 1)
  for (std::ptrdiff_t b = 0; b < blocks; ++b) {
    const std::size_t begin = static_cast<std::size_t>(b) * block_size;
    body(static_cast<std::size_t>(b), begin, std::min(n, begin + block_size));
  }
}

// The blocks' results combined in their order: combine(total, part), part = map(begin, end).
template <class Result, class Map, class Combine>
Result parallel_reduce(std::size_t n, int threads, Result total, const Map& map, const Combine& combine) {
  std::vector<Result> parts(block_count(n), total);
  parallel_blocks(n, threads, [&](std::size_t b, std::size_t begin, std::size_t end) { parts[b] = map(begin, end); });
  for (const Result& part : parts) total = combine(total, part);
  return total;
}

}  // namespace weir
