#include "render/gl_objects.h"

#include <fmt/format.h>

#include "core/error.h"

namespace weir {

namespace {

template <class Create>
GLuint created(Create create) {
  GLuint id = 0;
  create(1, &id);
  return id;
}

void compile(GLuint program, GLenum stage, const std::string& source, const std::string& defines) {
  const std::size_t line_end = source.find('\n') + 1;  // the first line must be #version
  const std::string text = source.substr(0, line_end) + defines + "#line 2\n" + source.substr(line_end);
  const char* pointer = text.c_str();
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &pointer, nullptr);
  glCompileShader(shader);
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok == 0) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(length);
    glDeleteShader(shader);
    throw DeviceError(fmt::format("a shader does not compile on this driver:\n{}", log));
  }
  glAttachShader(program, shader);
  glDeleteShader(shader);  // deleted once it is detached
}

}  // namespace

GLuint BufferTraits::create() { return created(glCreateBuffers); }
void BufferTraits::destroy(GLuint id) { glDeleteBuffers(1, &id); }
GLuint VertexArrayTraits::create() { return created(glCreateVertexArrays); }
void VertexArrayTraits::destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
GLuint FramebufferTraits::create() { return created(glCreateFramebuffers); }
void FramebufferTraits::destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
void TextureTraits::destroy(GLuint id) { glDeleteTextures(1, &id); }
GLuint ProgramTraits::create() { return glCreateProgram(); }
void ProgramTraits::destroy(GLuint id) { glDeleteProgram(id); }

GlProgram build_program(const std::string& vertex_source, const std::string& fragment_source,
                        const std::string& defines) {
  GlProgram program;
  compile(program.id(), GL_VERTEX_SHADER, vertex_source, defines);
  compile(program.id(), GL_FRAGMENT_SHADER, fragment_source, defines);
  glLinkProgram(program.id());
  GLint ok = 0;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &ok);
  if (ok == 0) {
    std::string log(4096, '\0');
    GLsizei length = 0;
    glGetProgramInfoLog(program.id(), static_cast<GLsizei>(log.size()), &length, log.data());
    log.resize(length);
    throw DeviceError(fmt::format("the shaders do not link on this driver:\n{}", log));
  }
  return program;
}

GlTexture make_texture(GLenum format, int width, int height) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &id);
  GlTexture texture(id);
  glTextureStorage2D(id, 1, format, width, height);
  glTextureParameteri(id, GL_TEXTURE_MIN_FILTER, GL_NEAREST);  // integers cannot be interpolated
  glTextureParameteri(id, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

GlTexture make_buffer_texture(GLenum format, GLuint buffer) {
  GLuint id = 0;
  glCreateTextures(GL_TEXTURE_BUFFER, 1, &id);
  GlTexture texture(id);
  glTextureBuffer(id, format, buffer);
  return texture;
}

void check_drawn() {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  throw DeviceError(error == GL_OUT_OF_MEMORY
                        ? std::string("drawing failed with GL_OUT_OF_MEMORY: make the picture smaller")
                        : fmt::format("drawing failed with OpenGL error 0x{:04x}", error));
}

}  // namespace weir
