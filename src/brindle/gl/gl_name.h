/// Owners of OpenGL objects and fences.
#pragma once

#include <utility>

#include <epoxy/gl.h>

namespace brindle {

/// Owns an OpenGL object name; 0 is none. `Delete` frees one.
template <void (*Delete)(GLuint)>
class GlName {
 public:
  GlName() = default;
  explicit GlName(GLuint name) : name_(name) {}
  ~GlName() {
    if (name_ != 0) Delete(name_);
  }
  GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  operator GLuint() const { return name_; }

 private:
  GLuint name_ = 0;
};

inline void delete_buffer(GLuint name) { glDeleteBuffers(1, &name); }
inline void delete_texture(GLuint name) { glDeleteTextures(1, &name); }
inline void delete_framebuffer(GLuint name) { glDeleteFramebuffers(1, &name); }
inline void delete_vertex_array(GLuint name) { glDeleteVertexArrays(1, &name); }

using GlBuffer = GlName<delete_buffer>;
using GlTexture = GlName<delete_texture>;
using GlFramebuffer = GlName<delete_framebuffer>;
using GlVertexArray = GlName<delete_vertex_array>;

/// A vertex array without attributes, for shaders that read buffers only.
inline GlVertexArray no_vertex_attributes() {
  GLuint name = 0;
  glCreateVertexArrays(1, &name);
  return GlVertexArray(name);
}

/// A fence that the host can wait for. Use it in one context, or in contexts that share objects.
class GlFence {
 public:
  GlFence() = default;
  GlFence(GlFence&& other) noexcept : name_(std::exchange(other.name_, nullptr)) {}
  GlFence& operator=(GlFence&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlFence() { glDeleteSync(name_); }

  /// Signals after all commands issued so far.
  void set() { *this = GlFence(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)); }

  /// Waits for the signal; returns at once if never set, or already awaited.
  void await() {
    constexpr GLuint64 kPatience = 10'000'000'000;  // nanoseconds per wait
    while (name_ &&
           glClientWaitSync(name_, GL_SYNC_FLUSH_COMMANDS_BIT, kPatience) == GL_TIMEOUT_EXPIRED) {
    }
    glDeleteSync(std::exchange(name_, nullptr));
  }

 private:
  explicit GlFence(GLsync name) : name_(name) {}

  GLsync name_ = nullptr;
};

}  // namespace brindle
