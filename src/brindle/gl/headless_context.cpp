#include "brindle/headless_context.h"

#include <array>
#include <cstdio>
#include <cstring>
#include <utility>
#include <vector>

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include "brindle/base/system.h"
#include "brindle/error.h"

namespace brindle {

/// EGL displays are shared by the whole process and stay initialized: terminating one would break
/// other contexts.
struct HeadlessContext::State {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  std::string renderer;
  std::vector<std::string> errors;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (context == EGL_NO_CONTEXT) return;
    if (eglGetCurrentContext() == context) {
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display, context);
  }
};

namespace {

constexpr const char* kRemedy =
    "install a GPU driver with EGL or Mesa's software renderer "
    "(Debian and Ubuntu: libegl1 libopengl0 libgl1-mesa-dri)";

struct Candidate {
  std::string name;
  EGLDisplay display;
};

bool has_extension(const char* list, const char* name) {
  return list != nullptr && std::strstr(list, name) != nullptr;
}

/// Software devices come after the surfaceless platform, which may offer a better one.
std::vector<Candidate> candidate_displays(const char* client_extensions) {
  std::vector<Candidate> hardware;
  std::vector<Candidate> software;
  if (has_extension(client_extensions, "EGL_EXT_platform_device") &&
      has_extension(client_extensions, "EGL_EXT_device_enumeration")) {
    std::array<EGLDeviceEXT, 32> devices{};
    EGLint count = 0;
    if (!eglQueryDevicesEXT(devices.size(), devices.data(), &count)) count = 0;
    for (EGLint d = 0; d < count; ++d) {
      const bool soft = has_extension(eglQueryDeviceStringEXT(devices[d], EGL_EXTENSIONS),
                                      "EGL_MESA_device_software");
      (soft ? software : hardware)
          .push_back({"EGL device " + std::to_string(d) + (soft ? " (software)" : ""),
                      eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[d], nullptr)});
    }
  }
  std::vector<Candidate> candidates = std::move(hardware);
  if (has_extension(client_extensions, "EGL_MESA_platform_surfaceless")) {
    candidates.push_back(
        {"Mesa's surfaceless platform",
         eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)});
  }
  candidates.insert(candidates.end(), software.begin(), software.end());
  return candidates;
}

EGLContext create_context(EGLDisplay display, EGLint major, EGLint minor) {
  const std::array<EGLint, 9> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                         major,
                                         EGL_CONTEXT_MINOR_VERSION,
                                         minor,
                                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                         EGL_CONTEXT_OPENGL_DEBUG,
                                         EGL_TRUE,
                                         EGL_NONE};
  const std::array<EGLint, 5> wanted{EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                     EGL_NONE};
  EGLConfig config = EGL_NO_CONFIG_KHR;
  EGLint configs = 0;
  if (!eglChooseConfig(display, wanted.data(), &config, 1, &configs) || configs == 0) {
    config = EGL_NO_CONFIG_KHR;
  }
  return eglCreateContext(display, config, EGL_NO_CONTEXT, attributes.data());
}

std::string egl_failure(const char* step) {
  std::array<char, 16> code{};
  std::snprintf(code.data(), code.size(), "0x%04x", static_cast<unsigned>(eglGetError()));
  return std::string(step) + " failed (EGL error " + code.data() + ")";
}

/// The version of a display without 4.5: ", it has ..." or "".
std::string older_version(EGLDisplay display) {
  EGLContext context = create_context(display, 3, 2);
  if (context == EGL_NO_CONTEXT) return "";
  std::string found;
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    found = ", it has " + describe(gl_device());
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
  eglDestroyContext(display, context);
  return found;
}

/// A current context on the display, or EGL_NO_CONTEXT and the reason.
EGLContext open_context(EGLDisplay display, std::string& reason) {
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
    reason = egl_failure("opening it");
    return EGL_NO_CONTEXT;
  }
  if (!has_extension(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
    reason = "it cannot draw without a window";
    return EGL_NO_CONTEXT;
  }
  eglBindAPI(EGL_OPENGL_API);
  EGLContext context = create_context(display, 4, 5);
  if (context == EGL_NO_CONTEXT) {
    reason = egl_failure("creating an OpenGL 4.5 core context") + older_version(display);
    return EGL_NO_CONTEXT;
  }
  if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
    reason = egl_failure("making its OpenGL 4.5 core context current");
    eglDestroyContext(display, context);
    return EGL_NO_CONTEXT;
  }
  return context;
}

void GLAPIENTRY collect_error(GLenum, GLenum type, GLuint, GLenum severity, GLsizei,
                              const GLchar* message, const void* errors) {
  if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
  auto* list = static_cast<std::vector<std::string>*>(const_cast<void*>(errors));
  if (list->size() < 16) list->emplace_back(message);
}

}  // namespace

HeadlessContext::HeadlessContext() : state_(std::make_unique<State>()) {
  // Without one of them, libepoxy would end the program.
  if (!system::load_library("libEGL.so.1")) {
    throw Error(std::string("there is no EGL on this system; ") + kRemedy);
  }
  if (!system::load_library("libOpenGL.so.0") && !system::load_library("libGL.so.1")) {
    throw Error(std::string("there is no OpenGL on this system; ") + kRemedy);
  }
  std::string tried;
  for (const Candidate& candidate :
       candidate_displays(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS))) {
    std::string reason;
    state_->display = candidate.display;
    state_->context = open_context(candidate.display, reason);
    if (state_->context != EGL_NO_CONTEXT) break;
    tried += (tried.empty() ? "" : "; ") + candidate.name + ": " + reason;
  }
  if (state_->context == EGL_NO_CONTEXT) {
    throw Error("no OpenGL 4.5 core context without a window (" +
                (tried.empty() ? "EGL lists no device and no surfaceless platform" : tried) +
                "); " + kRemedy);
  }
  state_->renderer = describe(gl_device());
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(collect_error, &state_->errors);
}

HeadlessContext::~HeadlessContext() = default;
HeadlessContext::HeadlessContext(HeadlessContext&&) noexcept = default;
HeadlessContext& HeadlessContext::operator=(HeadlessContext&&) noexcept = default;

void HeadlessContext::make_current() const {
  if (!eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state_->context)) {
    throw Error("cannot make the OpenGL context current: " + egl_failure("eglMakeCurrent"));
  }
}

const std::string& HeadlessContext::renderer() const { return state_->renderer; }

void HeadlessContext::check_errors(std::string_view job) const {
  if (state_->errors.empty()) return;
  std::string message = std::string(job) + " failed on " + state_->renderer + ":";
  for (const std::string& error : state_->errors) message += " " + error + ";";
  state_->errors.clear();
  throw Error(message);
}

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
