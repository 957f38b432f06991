#include "render/stream_buffer.h"

#include <algorithm>

#include "core/error.h"

namespace weir {

namespace {

constexpr GLuint64 forever = ~GLuint64{0};  // ns

}  // namespace

StreamBuffer::~StreamBuffer() {
  for (const Part& part : parts_) glDeleteSync(part.read);  // null is ignored
}

void* StreamBuffer::begin(std::size_t bytes) {
  const GLsync last = parts_[turn_].read;
  if (last != nullptr && glClientWaitSync(last, 0, 0) == GL_TIMEOUT_EXPIRED) turn_ = 1 - turn_;
  Part& part = parts_[turn_];
  if (part.read != nullptr) {
    glClientWaitSync(part.read, GL_SYNC_FLUSH_COMMANDS_BIT, forever);
    glDeleteSync(part.read);
    part.read = nullptr;
  }
  if (part.bytes < std::max<std::size_t>(bytes, 1)) grow(part, bytes + bytes / 4 + 4096);
  return part.memory;
}

void StreamBuffer::drawn() {
  GLsync& read = parts_[turn_].read;
  glDeleteSync(read);
  read = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

// Memory that stays mapped cannot change its size: the buffer becomes another.
void StreamBuffer::grow(Part& part, std::size_t bytes) const {
  constexpr GLbitfield access = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  part.buffer = GlBuffer();
  part.bytes = bytes;
  glNamedBufferStorage(part.buffer.id(), static_cast<GLsizeiptr>(bytes), nullptr, access);
  part.memory = glMapNamedBufferRange(part.buffer.id(), 0, static_cast<GLsizeiptr>(bytes), access);
  if (part.memory == nullptr) {
    part.bytes = 0;
    check_drawn();
    throw DeviceError("the driver has no memory for what is to be drawn");
  }
  part.texture = make_buffer_texture(format_, part.buffer.id());
  part.single = make_buffer_texture(GL_R32UI, part.buffer.id());
}

}  // namespace weir
