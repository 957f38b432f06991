// Buffers that the processor writes for each picture, mapped into memory of the device. Two, so that one can be written
// while the device reads the other; the same one is reused if it is idle. They never shrink: fresh memory costs page
// faults.
#pragma once

#include <array>
#include <cstring>
#include <span>

#include "render/gl_objects.h"

namespace weir {

class StreamBuffer {
 public:
  explicit StreamBuffer(GLenum format) : format_(format) {}
  ~StreamBuffer();
  StreamBuffer(const StreamBuffer&) = delete;
  StreamBuffer& operator=(const StreamBuffer&) = delete;

  // Memory for so many bytes, to be written before the next drawing and not read; what was there is lost. Waits until
  // the device has drawn what it had been given before the last call, if it still draws that. Throws DeviceError.
  void* begin(std::size_t bytes);
  // To be called after whatever draws from it.
  void drawn();
  template <class Item>
  void write(std::span<const Item> items) {
    std::memcpy(begin(items.size_bytes()), items.data(), items.size_bytes());
  }

  GLuint texture() const { return parts_[turn_].texture.id(); }
  // The same as texels of one whole number each.
  GLuint single() const { return parts_[turn_].single.id(); }

 private:
  struct Part {
    GlBuffer buffer;
    GlTexture texture{0};
    GlTexture single{0};
    std::size_t bytes = 0;
    void* memory = nullptr;
    GLsync read = nullptr;  // after the last drawing from it; null: none since begin()
  };
  void grow(Part& part, std::size_t bytes) const;

  GLenum format_;
  std::array<Part, 2> parts_;
  std::size_t turn_ = 0;
};

}  // namespace weir
