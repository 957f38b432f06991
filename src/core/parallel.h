// Loops over fixed blocks: blocks do not depend on the number of threads, so sums have the same bits for any number.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "core/thread_pool.h"

namespace weir {

// Small enough for load balance, large enough for negligible overhead.
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
    Result value;  // in a struct, as std::vector<bool> is not an array
  };
  std::vector<Part> parts(block_count(n), Part{start});
  parallel_blocks(n, pool,
                  [&](std::size_t b, std::size_t begin, std::size_t end) { parts[b].value = map(begin, end); });
  Result total = start;
  for (const Part& part : parts) total = combine(total, part.value);
  return total;
}

}  // namespace weir
