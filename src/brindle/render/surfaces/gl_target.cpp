#include "brindle/render/surfaces/gl_target.h"

#include <string>

#include <epoxy/gl.h>

#include "brindle/error.h"

namespace brindle {

GlTexture texture_2d(GLenum format, int width, int height, GLint filter, GLint wrap,
                     GLsizei levels) {
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  GlTexture texture(name);
  glTextureStorage2D(texture, levels, format, width, height);
  const bool blends_levels = levels > 1 && filter == GL_LINEAR;
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER,
                      blends_levels ? GL_LINEAR_MIPMAP_LINEAR : filter);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, filter);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_S, wrap);
  glTextureParameteri(texture, GL_TEXTURE_WRAP_T, wrap);
  return texture;
}

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
    target.textures.push_back(texture_2d(format, width, height, GL_NEAREST, GL_CLAMP_TO_EDGE));
    glNamedFramebufferTexture(target.framebuffer, attachments.back(), target.textures.back(), 0);
  }
  if (depth) {
    target.textures.push_back(
        texture_2d(GL_DEPTH_COMPONENT32F, width, height, GL_NEAREST, GL_CLAMP_TO_EDGE));
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
  target = {};  // frees its memory first
  target = target_of(colors, depth, width, height);
}

void fill_viewport(const ShaderProgram& program, GLuint no_attributes) {
  glUseProgram(program.name());
  glBindVertexArray(no_attributes);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

namespace {

/// The slice for positions relative to the camera's `origin`: normal and offset; positive points
/// are cut away. Zero without a slice.
Eigen::Vector4f slice_of(const Camera& camera) {
  if (!camera.slice) return {0, 0, 0, -1};
  Eigen::Vector4f slice;
  slice << camera.slice->normal(), camera.slice->signedDistance(camera.origin);
  return slice;
}

}  // namespace

void set_camera(const ShaderProgram& program, const Camera& camera, const Eigen::Vector4f& tile) {
  program.set("origin", camera.origin);
  program.set("view_from_world", camera.view_from_world);
  program.set("clip_from_view", camera.clip_from_view);
  program.set("slice", slice_of(camera));
  program.set("tile", tile);
}

SlicedDrawing::SlicedDrawing(const Camera& camera) : sliced_(camera.slice.has_value()) {
  if (sliced_) glEnable(GL_CLIP_DISTANCE0);
}

SlicedDrawing::~SlicedDrawing() {
  if (sliced_) glDisable(GL_CLIP_DISTANCE0);
}

}  // namespace brindle
