// Arrays aligned to whole registers.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace weir {

// Size of the widest register and of a cache line.
constexpr std::size_t register_bytes = 64;

template <class T>
struct AlignedAllocator {
  using value_type = T;
  AlignedAllocator() = default;
  template <class U>
  explicit(false) AlignedAllocator(const AlignedAllocator<U>&) {}
  T* allocate(std::size_t n) {
    return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{register_bytes}));
  }
  void deallocate(T* memory, std::size_t) { ::operator delete (memory, std::align_val_t{register_bytes}); }
  friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }
};

template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

}  // namespace weir
