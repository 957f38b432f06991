// A growing array of integers for code that is built per instruction set. Growth is compiled once, for all sets.
#pragma once

#include <cstddef>
#include <cstdint>

namespace weir {

class IntBuffer {
 public:
  IntBuffer() = default;
  ~IntBuffer();
  IntBuffer(IntBuffer&& other) noexcept;
  IntBuffer& operator=(IntBuffer&& other) noexcept;

  const std::int32_t* data() const { return data_; }
  std::int32_t* data() { return data_; }
  std::size_t size() const { return size_; }

  // Room for `more` beyond size(), uninitialised.
  void reserve_more(std::size_t more) {
    if (size_ + more > capacity_) grow(size_ + more);
  }
  void set_size(std::size_t size) { size_ = size; }  // at most what was reserved

 private:
  void grow(std::size_t capacity);

  std::int32_t* data_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace weir
