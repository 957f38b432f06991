// OpenGL objects that delete themselves; the context in which they were made must then be current.
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
struct TextureTraits {  // made by make_texture: what it is, is fixed at its birth
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

// `defines` stand behind the #version line of both stages. Throws DeviceError with the compiler's log.
GlProgram build_program(const std::string& vertex_source, const std::string& fragment_source,
                        const std::string& defines);

// Throws DeviceError if any call since the last check went wrong.
void check_drawn();

// One level of texels, read as they are.
GlTexture make_texture(GLenum format, int width, int height);
// A view of a buffer as texels of that format.
GlTexture make_buffer_texture(GLenum format, GLuint buffer);

}  // namespace weir
