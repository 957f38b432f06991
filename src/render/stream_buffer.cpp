#include "render/stream_buffer.h"

#include <algorithm>

#include "core/error.h"

namespace weir {

namespace {

constexpr GLuint64 forever = ~GLuint64{0};  // ns

}  // namespace

StreamBuffer::Part::Part(GLenum format)
    : texture(make_buffer_texture(format, buffer.id())), single(make_buffer_texture(GL_R32UI, buffer.id())) {}

StreamBuffer::StreamBuffer(GLenum format) : parts_{Part(format), Part(format)} {}

StreamBuffer::~StreamBuffer() {
  for (const Part& part : parts_) glDeleteSync(part.read);  // null is ignored
}

void* StreamBuffer::map(std::size_t bytes) {
  // All that has been asked of the device, as far as it concerns this part.
  GLsync& last = parts_[turn_].read;
  last = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  if (glClientWaitSync(last, GL_SYNC_FLUSH_COMMANDS_BIT, 0) == GL_TIMEOUT_EXPIRED) turn_ = 1 - turn_;
  Part& part = parts_[turn_];
  if (part.read != nullptr) {
    glClientWaitSync(part.read, GL_SYNC_FLUSH_COMMANDS_BIT, forever);
    glDeleteSync(part.read);
    part.read = nullptr;
  }
  if (part.bytes < std::max<std::size_t>(bytes, 1)) {  // a buffer of nothing cannot be mapped
    part.bytes = bytes + bytes / 4 + 4096;
    glNamedBufferData(part.buffer.id(), static_cast<GLsizeiptr>(part.bytes), nullptr, GL_STREAM_DRAW);
  }
  // Unsynchronized: we have waited for what matters, the driver would wait for all that has been drawn.
  void* memory = glMapNamedBufferRange(part.buffer.id(), 0, static_cast<GLsizeiptr>(part.bytes),
                                       GL_MAP_WRITE_BIT | GL_MAP_UNSYNCHRONIZED_BIT);
  if (memory == nullptr) {
    check_drawn();
    throw DeviceError("the driver has no memory for what is to be drawn");
  }
  return memory;
}

void StreamBuffer::unmap() { glUnmapNamedBuffer(parts_[turn_].buffer.id()); }

}  // namespace weir
