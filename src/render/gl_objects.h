// Owning handles of OpenGL objects; destruction requires the context of their creation to be current.
#pragma once

#include <epoxy/gl.h>

#include <string>
#include <utility>

namespace weir {

template <class Traits>
class GlObject {
 public:
  GlObject() : id_(Traits::create()) {}
  explicit GlObject(GLuint id) : id_(id) {}
  GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~GlObject() {
    if (id_ != 0) Traits::destroy(id_);
  }
  GLuint id() const { return id_; }

 private:
  GLuint id_;
};

struct BufferTraits {
  static GLuint create();
  static void destroy(GLuint id);
};
struct VertexArrayTraits {
  static GLuint create();
  static void destroy(GLuint id);
};
struct FramebufferTraits {
  static GLuint create();
  static void destroy(GLuint id);
};
struct TextureTraits {  // see make_texture: format and size are immutable
  static void destroy(GLuint id);
};
struct ProgramTraits {
  static GLuint create();
  static void destroy(GLuint id);
};
using GlBuffer = GlObject<BufferTraits>;
using GlVertexArray = GlObject<VertexArrayTraits>;
using GlFramebuffer = GlObject<FramebufferTraits>;
using GlTexture = GlObject<TextureTraits>;
using GlProgram = GlObject<ProgramTraits>;

// `defines` are inserted after the #version line of both stages. Throws DeviceError with the compiler's log.
GlProgram build_program(const std::string& vertex_source, const std::string& fragment_source,
                        const std::string& defines);

// Throws DeviceError if any call since the last check failed.
void check_drawn();

// A texture of one level, without filtering.
GlTexture make_texture(GLenum format, int width, int height);
// A buffer texture of that format.
GlTexture make_buffer_texture(GLenum format, GLuint buffer);

}  // namespace weir
