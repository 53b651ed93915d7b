#include "brindle/gl_device.h"

#include <array>

#include <epoxy/gl.h>

namespace brindle {
namespace {

constexpr std::array<std::pair<const char*, GLenum>, 8> kLimits{
    {{"max_shader_storage_block_size", GL_MAX_SHADER_STORAGE_BLOCK_SIZE},
     {"max_compute_shader_storage_blocks", GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS},
     {"max_compute_work_group_invocations", GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS},
     {"max_compute_shared_memory_size", GL_MAX_COMPUTE_SHARED_MEMORY_SIZE},
     {"max_uniform_block_size", GL_MAX_UNIFORM_BLOCK_SIZE},
     {"max_texture_size", GL_MAX_TEXTURE_SIZE},
     {"max_viewport_dims", GL_MAX_VIEWPORT_DIMS},
     {"max_samples", GL_MAX_SAMPLES}}};

std::string gl_string(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text == nullptr ? "?" : reinterpret_cast<const char*>(text);
}

}  // namespace

GlDevice gl_device() {
  GlDevice device{gl_string(GL_RENDERER), gl_string(GL_VENDOR), gl_string(GL_VERSION), {}};
  for (const auto& [name, limit] : kLimits) {
    std::array<GLint64, 2> values{};  // viewports have two
    glGetInteger64v(limit, values.data());
    device.limits.emplace_back(name, values[0]);
  }
  if (epoxy_gl_version() < 43) return device;  // no compute shaders
  GLint groups = 0;
  glGetIntegeri_v(GL_MAX_COMPUTE_WORK_GROUP_COUNT, 0, &groups);
  device.limits.emplace_back("max_compute_work_group_count", groups);
  return device;
}

std::string describe(const GlDevice& device) {
  return device.renderer + ", OpenGL " + device.version;
}

}  // namespace brindle
