#include "brindle/render/gl_target.h"

#include <string>

#include "brindle/error.h"

namespace brindle {
namespace {

GlTexture texture_of(GLenum format, int width, int height, int samples = 0) {
  GLuint name = 0;
  glCreateTextures(samples > 0 ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, 1, &name);
  GlTexture texture(name);
  if (samples > 0) {
    glTextureStorage2DMultisample(texture, samples, format, width, height, GL_TRUE);
  } else {
    glTextureStorage2D(texture, 1, format, width, height);
  }
  return texture;
}

}  // namespace

Target target_of(std::initializer_list<GLenum> colors, bool depth, int width, int height,
                 int samples) {
  Target target;
  GLuint name = 0;
  glCreateFramebuffers(1, &name);
  target.framebuffer = GlFramebuffer(name);
  std::vector<GLenum> attachments;
  for (const GLenum format : colors) {
    attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachments.size()));
    target.textures.push_back(texture_of(format, width, height, samples));
    glNamedFramebufferTexture(target.framebuffer, attachments.back(), target.textures.back(), 0);
  }
  if (depth) {
    target.textures.push_back(texture_of(GL_DEPTH_COMPONENT32F, width, height, samples));
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

}  // namespace brindle
