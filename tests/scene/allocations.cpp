#include "scene/allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace weir {
namespace {
std::atomic<std::size_t> total = 0;
}  // namespace

std::size_t allocated_bytes() { return total; }

}  // namespace weir

// Every form of new but those for great alignments ends here.
void* operator new(std::size_t size) {
  weir::total += size;
  if (void* const memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
