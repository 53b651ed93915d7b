/// What every renderer needs of OpenGL: buffers, framebuffers, limits and errors.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <vector>

#include "brindle/render/gl_name.h"

namespace brindle {

GLint gl_limit(GLenum name);

/// Throws Error if anything went wrong since the last check: "`job` failed: ...".
void check_gl(const std::string& job);

/// A buffer with these bytes; none for no bytes. Throws Error, naming `what`, if the driver's
/// buffers are smaller.
GlBuffer buffer_of_bytes(const void* bytes, std::size_t size, const char* what);

template <class Item>
GlBuffer buffer_of(std::span<const Item> items, const char* what) {
  return buffer_of_bytes(items.data(), items.size_bytes(), what);
}

template <class Item>
GlBuffer buffer_of(const std::vector<Item>& items, const char* what) {
  return buffer_of(std::span<const Item>(items), what);
}

/// A framebuffer with its textures: colours first, then depth if it has one.
struct Target {
  GlFramebuffer framebuffer;
  std::vector<GlTexture> textures;
};

/// `samples` 0 is no multisampling. Throws Error if the driver cannot draw into it.
Target target_of(std::initializer_list<GLenum> colors, bool depth, int width, int height,
                 int samples = 0);

}  // namespace brindle
