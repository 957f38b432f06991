// Texels that the processor writes anew for each picture. Two buffers, so that one can be filled while the device still reads
// the other; the same again if it does not. They only grow, for fresh memory costs a page fault every few kilobytes.
#pragma once

#include <array>
#include <cstring>
#include <span>

#include "render/gl_objects.h"

namespace weir {

class StreamBuffer {
 public:
  explicit StreamBuffer(GLenum format);
  ~StreamBuffer();
  StreamBuffer(const StreamBuffer&) = delete;
  StreamBuffer& operator=(const StreamBuffer&) = delete;

  // Memory for so many bytes, to be written only; what was there is lost. Waits until the device has drawn what it had been
  // given before the last call, if that was elsewhere. Throws DeviceError.
  void* map(std::size_t bytes);
  void unmap();
  template <class Item>
  void write(std::span<const Item> items) {
    std::memcpy(map(items.size_bytes()), items.data(), items.size_bytes());
    unmap();
  }

  GLuint texture() const { return parts_[turn_].texture.id(); }
  // The same as texels of one whole number each.
  GLuint single() const { return parts_[turn_].single.id(); }

 private:
  struct Part {
    explicit Part(GLenum format);
    GlBuffer buffer;
    GlTexture texture;
    GlTexture single;
    std::size_t bytes = 0;
    GLsync read = nullptr;  // once the device has read it
  };

  std::array<Part, 2> parts_;
  std::size_t turn_ = 0;
};

}  // namespace weir
