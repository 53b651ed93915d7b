/// OpenGL buffers and errors.
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

/// Throws Error with OpenGL's error since the last call; `job` describes the work in between.
void check_gl(const std::string& job);

/// A buffer of `bytes` bytes for shaders, a copy of `data` or zeros; none for 0 bytes. `flags` are
/// those of glNamedBufferStorage. Throws Error with `what`, its content, if it exceeds the driver's
/// limit or OpenGL is out of memory.
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
