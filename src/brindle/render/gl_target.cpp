#include "brindle/render/gl_target.h"

#include <string>

#include "brindle/error.h"

namespace brindle {
namespace {

/// Nothing lies between its texels.
GlTexture texture_of(GLenum format, int width, int height) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  GlTexture texture(name);
  glTextureStorage2D(texture, 1, format, width, height);
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

Target target_of(std::initializer_list<GLenum> colors, bool depth, int width, int height) {
  Target target;
  target.width = width;
  target.height = height;
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  target.framebuffer = GlFramebuffer(name);
  std::vector<GLenum> attachments;
  for (const GLenum format : colors) {
    attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachments.size()));
    target.textures.push_back(texture_of(format, width, height));
    glNamedFramebufferTexture(target.framebuffer, attachments.back(), target.textures.back(), 0);
  }
  if (depth) {
    target.textures.push_back(texture_of(GL_DEPTH_COMPONENT32F, width, height));
    glNamedFramebufferTexture(target.framebuffer, GL_DEPTH_ATTACHMENT, target.textures.back(), 0);
  }
  glNamedFramebufferDrawBuffers(target.framebuffer, static_cast<GLsizei>(attachments.size()),
                                attachments.data());
  if (glCheckNamedFramebufferStatus(target.framebuffer, GL_DRAW_FRAMEBUFFER) !=
      GL_FRAMEBUFFER_COMPLETE) {
    throw Error("OpenGL cannot draw into a picture of " + std::to_string(width) + " x " +
                std::to_string(height) + " pixels; take a smaller one");
  }
  return target;
}

void fit_target(Target& target, std::initializer_list<GLenum> colors, bool depth, int width,
                int height) {
  if (target.framebuffer != 0 && target.width == width && target.height == height) return;
  target = {};  // gives its memory back first
  target = target_of(colors, depth, width, height);
}

}  // namespace brindle
