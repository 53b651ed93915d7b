#include "window/base/app_window.h"

#include <algorithm>
#include <utility>

#include <epoxy/gl.h>
// GLFW would include OpenGL's own header.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "brindle/error.h"
#include "window/base/theme.h"

namespace brindle::tool {
namespace {

struct ReleasedKey {
  int key;
  int code;
};

}  // namespace

struct AppWindow::Desktop {
  GLFWwindow* window = nullptr;
  std::vector<std::filesystem::path> dropped;
  std::vector<PressedKey> keys;
  std::vector<ReleasedKey> released;
  std::vector<Eigen::Vector2f> trail;
  bool has_input = false;
  bool imgui_set_up = false;
  bool may_be_lost = false;

  ~Desktop() {
    if (imgui_set_up) {
      ImGui_ImplOpenGL3_Shutdown();
      ImGui_ImplGlfw_Shutdown();
      ImGui::DestroyContext();
    }
    if (window != nullptr) glfwDestroyWindow(window);
    glfwTerminate();
  }
};

namespace {

constexpr const char* kWithoutWindow = "; 'brindle render' draws sessions without a window";

// GLFW's last error message, without the full stop.
std::string last_complaint() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description == nullptr ? "no reason is given" : description;
}

GLFWwindow* make_window(const std::string& title, int width, int height) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 2);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  // Reports a lost context instead of ending the program, if the driver can.
  glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);
  GLFWwindow* window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (window == nullptr) {
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_NO_ROBUSTNESS);
    window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  }
  return window;
}

// Key codes are positions on a US keyboard; letters follow the user's layout.
int letter_on(int key, int code) {
  if (key < GLFW_KEY_A || key > GLFW_KEY_Z) return key;
  const char* name = glfwGetKeyName(key, code);
  if (name == nullptr || name[1] != '\0' || name[0] < 'a' || name[0] > 'z') return key;
  return GLFW_KEY_A + (name[0] - 'a');
}

AppWindow* window_of(GLFWwindow* window) {
  return static_cast<AppWindow*>(glfwGetWindowUserPointer(window));
}

}  // namespace

AppWindow::AppWindow(const std::string& title, int width, int height, const WindowLook& look)
    : look_(look) {
  if (glfwInit() != GLFW_TRUE) {
    throw Error("cannot open a window: " + last_complaint() +
                "; start it where a display is (DISPLAY), or under xvfb-run" + kWithoutWindow);
  }
  desktop_ = std::make_unique<Desktop>();
  desktop_->window = make_window(title, width, height);
  if (desktop_->window == nullptr) {
    throw Error("cannot open a window with OpenGL 3.2: " + last_complaint() +
                "; install the graphics card's driver, or Mesa's software renderer "
                "(libgl1-mesa-dri)" +
                kWithoutWindow);
  }
  glfwMakeContextCurrent(desktop_->window);
  desktop_->may_be_lost =
      glfwGetWindowAttrib(desktop_->window, GLFW_CONTEXT_ROBUSTNESS) != GLFW_NO_ROBUSTNESS &&
      (epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness"));
  glfwSwapInterval(1);
  listen();
  set_up_imgui();
}

AppWindow::~AppWindow() = default;

void AppWindow::listen() {
  GLFWwindow* window = desktop_->window;
  glfwSetWindowUserPointer(window, this);
  static constexpr auto note = [](GLFWwindow* w) { window_of(w)->desktop_->has_input = true; };
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    note(w);
    if (glfwGetMouseButton(w, GLFW_MOUSE_BUTTON_LEFT) != GLFW_PRESS) return;
    window_of(w)->desktop_->trail.emplace_back(static_cast<float>(x), static_cast<float>(y));
  });
  glfwSetWindowRefreshCallback(window, note);
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { note(w); });
  glfwSetWindowCloseCallback(window, note);
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
    note(w);
    if (button == GLFW_MOUSE_BUTTON_LEFT && action == GLFW_PRESS) {
      Eigen::Vector2d at(0, 0);
      glfwGetCursorPos(w, &at.x(), &at.y());
      window_of(w)->desktop_->trail.emplace_back(at.cast<float>());
    }
    ImGui_ImplGlfw_MouseButtonCallback(w, button, action, modifiers);
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
    note(w);
    ImGui_ImplGlfw_ScrollCallback(w, x, y);
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    note(w);
    ImGui_ImplGlfw_CursorEnterCallback(w, entered);
  });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
    note(w);
    ImGui_ImplGlfw_WindowFocusCallback(w, focused);
  });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    note(w);
    auto& dropped = window_of(w)->desktop_->dropped;
    dropped.insert(dropped.end(), paths, paths + count);
  });
  listen_to_keys();
}

// Dear ImGui reads keys once per frame: a release waits until the press was seen.
void AppWindow::listen_to_keys() {
  GLFWwindow* window = desktop_->window;
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned character) {
    Desktop& desktop = *window_of(w)->desktop_;
    desktop.has_input = true;
    if (character == '?') desktop.keys.push_back({'?'});
    ImGui_ImplGlfw_CharCallback(w, character);
  });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int code, int action, int modifiers) {
    Desktop& desktop = *window_of(w)->desktop_;
    desktop.has_input = true;
    if (action == GLFW_RELEASE) {
      desktop.released.push_back({key, code});
      return;
    }
    std::erase_if(desktop.released, [key](const auto& released) { return released.key == key; });
    desktop.keys.push_back({letter_on(key, code), (modifiers & GLFW_MOD_CONTROL) != 0,
                            (modifiers & GLFW_MOD_SHIFT) != 0, (modifiers & GLFW_MOD_ALT) != 0});
    ImGui_ImplGlfw_KeyCallback(w, key, code, action, modifiers);
  });
}

void AppWindow::set_up_imgui() {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // settings are in one place (window_settings)
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  ImGui_ImplGlfw_InitForOpenGL(desktop_->window, false);
  ImGui_ImplOpenGL3_Init("#version 150");
  desktop_->imgui_set_up = true;
  scale_ = 0;
  follow_display_scale();
}

// Windows move between displays.
void AppWindow::follow_display_scale() {
  float scale = look_.scale;
  if (scale <= 0) {
    float vertical = 1;
    glfwGetWindowContentScale(desktop_->window, &scale, &vertical);
    // If units are larger than pixels, the desktop already enlarges text.
    scale = std::clamp(std::max(scale, vertical) / pixels_per_unit(), 0.5f, 4.0f);
  }
  if (scale == scale_) return;
  scale_ = scale;
  load_fonts(scale_, pixels_per_unit());
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  apply_theme(look_.dark, scale_);
}

bool AppWindow::closing() const { return glfwWindowShouldClose(desktop_->window) == GLFW_TRUE; }

void AppWindow::keep_open() { glfwSetWindowShouldClose(desktop_->window, GLFW_FALSE); }

void AppWindow::ask_to_close() { glfwSetWindowShouldClose(desktop_->window, GLFW_TRUE); }

bool AppWindow::wait(double seconds) {
  desktop_->has_input = false;
  if (seconds > 0) {
    glfwWaitEventsTimeout(seconds);
  } else {
    glfwPollEvents();
  }
  return desktop_->has_input;
}

void AppWindow::begin_frame() {
  follow_display_scale();
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGui::NewFrame();
}

void AppWindow::end_frame(Image* copy) {
  ImGui::Render();
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(desktop_->window, &width, &height);
  glViewport(0, 0, width, height);
  const ImVec4 color = ImGui::GetStyle().Colors[ImGuiCol_WindowBg];
  glClearColor(color.x, color.y, color.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  for (const ReleasedKey& released : std::exchange(desktop_->released, {})) {
    ImGui_ImplGlfw_KeyCallback(desktop_->window, released.key, released.code, GLFW_RELEASE, 0);
  }
  if (copy != nullptr) *copy = pixels();
  glfwSwapBuffers(desktop_->window);
  if (desktop_->may_be_lost && glGetGraphicsResetStatus() != GL_NO_ERROR) {
    throw Error("OpenGL was lost: the graphics driver was reset; start brindle view again");
  }
}

Image AppWindow::pixels() const {
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(desktop_->window, &width, &height);
  Image image(width, height);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadBuffer(GL_BACK);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
  for (int y = 0; y < height / 2; ++y) {
    const auto row = image.pixels.begin() + std::ptrdiff_t{y} * width;
    std::swap_ranges(row, row + width,
                     image.pixels.begin() + std::ptrdiff_t{height - 1 - y} * width);
  }
  for (Pixel& pixel : image.pixels) pixel.alpha = 255;
  return image;
}

void AppWindow::set_dark(bool dark) {
  look_.dark = dark;
  apply_theme(dark, scale_);
}

float AppWindow::pixels_per_unit() const {
  int units = 0;
  int pixels = 0;
  int ignored = 0;
  glfwGetWindowSize(desktop_->window, &units, &ignored);
  glfwGetFramebufferSize(desktop_->window, &pixels, &ignored);
  return units > 0 && pixels > 0 ? static_cast<float>(pixels) / static_cast<float>(units) : 1;
}

std::vector<PressedKey> AppWindow::take_keys() { return std::exchange(desktop_->keys, {}); }

std::vector<Eigen::Vector2f> AppWindow::take_trail() { return std::exchange(desktop_->trail, {}); }

std::vector<std::filesystem::path> AppWindow::take_dropped() {
  return std::exchange(desktop_->dropped, {});
}

bool AppWindow::close_popup() {
  const int open = ImGui::GetCurrentContext()->OpenPopupStack.Size;
  if (open > 0) ImGui::ClosePopupToLevel(open - 1, true);
  return open > 0;
}

void AppWindow::set_clipboard(const std::string& text) {
  glfwSetClipboardString(desktop_->window, text.c_str());
}

std::string AppWindow::clipboard() const {
  const char* text = glfwGetClipboardString(desktop_->window);
  return text == nullptr ? "" : text;
}

std::string AppWindow::renderer() const {
  const auto text = [](GLenum name) {
    return std::string(reinterpret_cast<const char*>(glGetString(name)));
  };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

}  // namespace brindle::tool
