// Loops over fixed blocks: which elements share a block never depends on the number of threads, so sums keep their bits.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/thread_pool.h"

namespace weir {

// Small enough to balance, large enough that a block's bookkeeping vanishes.
constexpr std::size_t block_size = 256;

inline std::size_t block_count(std::size_t n) { return (n + block_size - 1) / block_size; }

// body(block, begin, end) for each block of 0 .. n, in any order. The body must not throw.
template <class Body>
void parallel_blocks(std::size_t n, ThreadPool& pool, const Body& body) {
  pool.for_each(block_count(n), [&](std::size_t b) {
    const std::size_t begin = b * block_size;
    body(b, begin, std::min(n, begin + block_size));
  });
}

// The blocks' results combined in their order: combine(total, part), part = map(begin, end).
template <class Result, class Map, class Combine>
Result parallel_reduce(std::size_t n, ThreadPool& pool, const Result& start, const Map& map, const Combine& combine) {
  struct Part {
    Result value;  // a struct of its own, so that Result may be bool
  };
  std::vector<Part> parts(block_count(n), Part{start});
  parallel_blocks(n, pool,
                  [&](std::size_t b, std::size_t begin, std::size_t end) { parts[b].value = map(begin, end); });
  Result total = start;
  for (const Part& part : parts) total = combine(total, part.value);
  return total;
}

}  // namespace weir
