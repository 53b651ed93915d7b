/// Framebuffers of OpenGL.
#pragma once

#include <initializer_list>
#include <vector>

#include "brindle/gl/gl_name.h"

namespace brindle {

/// A framebuffer with its textures: colours first, then depth if it has one.
struct Target {
  GlFramebuffer framebuffer;
  std::vector<GlTexture> textures;
};

/// `samples` 0 is no multisampling. Throws Error if the driver cannot draw into it.
Target target_of(std::initializer_list<GLenum> colors, bool depth, int width, int height,
                 int samples = 0);

}  // namespace brindle
