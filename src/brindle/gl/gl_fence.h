/// A place in the device's work that the processor can wait for.
#pragma once

#include <utility>

#include <epoxy/gl.h>

namespace brindle {

/// Must be set, awaited and destroyed in the same context, or one that shares its objects.
class GlFence {
 public:
  GlFence() = default;
  GlFence(GlFence&& other) noexcept : name_(std::exchange(other.name_, nullptr)) {}
  GlFence& operator=(GlFence&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlFence() { glDeleteSync(name_); }

  /// After all that was asked of the device so far.
  void set() { *this = GlFence(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)); }

  /// Waits until the device has come there; not at all if it was never set, or awaited before.
  void await() {
    constexpr GLuint64 kPatience = 10'000'000'000;  // nanoseconds between two looks
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
