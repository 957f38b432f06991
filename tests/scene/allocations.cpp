#include "scene/allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace weir {
namespace {
std::atomic<std::size_t> total = 0;

void* allocate(std::size_t size) {
  total += size;
  return std::malloc(size > 0 ? size : 1);
}

void* allocate_or_throw(std::size_t size) {
  if (void* const memory = allocate(size)) return memory;
  throw std::bad_alloc();
}
}  // namespace

std::size_t allocated_bytes() { return total; }

}  // namespace weir

// Every form but those for great alignments; were one left out, a sanitizer's own would be used.
void* operator new(std::size_t size) { return weir::allocate_or_throw(size); }
void* operator new[](std::size_t size) { return weir::allocate_or_throw(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return weir::allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return weir::allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
