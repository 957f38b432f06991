#include "core/int_buffer.h"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <utility>

namespace weir {

IntBuffer::~IntBuffer() { std::free(data_); }

IntBuffer::IntBuffer(IntBuffer&& other) noexcept { *this = std::move(other); }

IntBuffer& IntBuffer::operator=(IntBuffer&& other) noexcept {
  std::swap(data_, other.data_);
  std::swap(size_, other.size_);
  std::swap(capacity_, other.capacity_);
  return *this;
}

void IntBuffer::grow(std::size_t capacity) {
  capacity = std::max(capacity, capacity_ + capacity_ / 2);
  void* grown = std::realloc(data_, capacity * sizeof(std::int32_t));
  if (grown == nullptr) throw std::bad_alloc();
  data_ = static_cast<std::int32_t*>(grown);
  capacity_ = capacity;
}

}  // namespace weir
