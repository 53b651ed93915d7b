/// Buffers on the device that OpenGL works on, and what went wrong there.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "brindle/gl/gl_name.h"

namespace brindle {

/// A limit of the current context, such as GL_MAX_TEXTURE_SIZE.
GLint gl_limit(GLenum name);

/// Throws Error with OpenGL's complaint about what was done since the last call; `job` says what
/// that was.
void check_gl(const std::string& job);

/// A buffer of `bytes` bytes that shaders can read and write, a copy of `data` or, without that,
/// zeros; none for no bytes. `flags` are those of glNamedBufferStorage. Throws Error, naming `what`
/// the buffer holds, if it is larger than shaders of this driver can see or OpenGL is out of
/// memory.
GlBuffer make_buffer(std::size_t bytes, const void* data, std::string_view what,
                     GLbitfield flags = 0);

/// A copy of `items`.
template <class Item>
GlBuffer buffer_of(std::span<const Item> items, std::string_view what) {
  return make_buffer(items.size_bytes(), items.data(), what);
}
template <class Item>
GlBuffer buffer_of(const std::vector<Item>& items, std::string_view what) {
  return buffer_of(std::span<const Item>(items), what);
}

}  // namespace brindle
