#include "brindle/gl/gl_buffer.h"

#include "brindle/error.h"

namespace brindle {

GLint gl_limit(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

void check_gl(const std::string& job) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  while (glGetError() != GL_NO_ERROR) {
  }
  throw Error(job + " failed: " +
              (error == GL_OUT_OF_MEMORY ? "OpenGL is out of memory; take a smaller mesh or picture"
                                         : "OpenGL error " + std::to_string(error)));
}

GlBuffer make_buffer(std::size_t bytes, const void* data, std::string_view what, GLbitfield flags) {
  GlBuffer buffer;
  if (bytes == 0) return buffer;
  GLint64 largest = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest);
  if (bytes > static_cast<std::size_t>(largest)) {
    throw Error("this mesh is too large for OpenGL here: " + std::to_string(bytes) + " bytes of " +
                std::string(what) + ", and this driver's buffers hold " + std::to_string(largest) +
                "; take a smaller mesh");
  }
  GLuint name = 0;
  glCreateBuffers(1, &name);
  buffer = GlBuffer(name);
  glNamedBufferStorage(buffer, static_cast<GLsizeiptr>(bytes), data, flags);
  if (data == nullptr) {
    glClearNamedBufferData(buffer, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
    // NVIDIA's driver 580 lets glNamedBufferSubData of 64 KiB and more overtake a clear, which then
    // erases the data.
    glFinish();
  }
  check_gl("making room for " + std::string(what) + " (" + std::to_string(bytes) + " bytes)");
  return buffer;
}

}  // namespace brindle
