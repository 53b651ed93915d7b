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
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels
};

/// Throws Error if the driver cannot draw into it.
Target target_of(std::initializer_list<GLenum> colors, bool depth, int width, int height);

/// Makes the target anew unless it has this size already. Throws as `target_of` does.
void fit_target(Target& target, std::initializer_list<GLenum> colors, bool depth, int width,
                int height);

}  // namespace brindle
