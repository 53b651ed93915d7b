/// A desktop window with Dear ImGui.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "brindle/image.h"

namespace brindle::tool {

/// The look of the whole window.
struct WindowLook {
  bool dark = true;
  float scale = 0;  ///< of text and widgets; 0: the desktop's
};

/// A GLFW key code; '?' wherever it is on the keyboard.
struct PressedKey {
  int key = 0;
  bool control = false;
  bool shift = false;
  bool alt = false;
};

/// One at a time. Belongs to the thread that creates it, which must be the main thread.
class AppWindow {
 public:
  /// `width` and `height` in desktop units. Throws Error with the remedy if there is no display or
  /// no OpenGL 3.2.
  AppWindow(const std::string& title, int width, int height, const WindowLook& look);
  ~AppWindow();
  AppWindow(const AppWindow&) = delete;
  AppWindow& operator=(const AppWindow&) = delete;

  /// Whether the user requested to close it since `keep_open`.
  bool closing() const;
  void keep_open();
  void ask_to_close();

  /// Waits for input, at most this long. Returns whether there was any.
  bool wait(double seconds);

  /// Starts a frame of Dear ImGui. The text and widgets that follow belong to it.
  void begin_frame();

  /// Draws it, and copies the window's opaque pixels to `copy`, if not null. Throws Error if OpenGL
  /// was lost.
  void end_frame(Image* copy = nullptr);

  void set_dark(bool dark);
  bool dark() const { return look_.dark; }

  /// Pixels of the framebuffer per unit of Dear ImGui.
  float pixels_per_unit() const;

  /// Text size relative to a standard display.
  float scale() const { return scale_; }

  /// Keys pressed since the last call, with repeats, even if already released.
  std::vector<PressedKey> take_keys();

  /// Mouse positions since the last call with the left button down, in Dear ImGui units, from the
  /// press on: strokes must not depend on the frame rate.
  std::vector<Eigen::Vector2f> take_trail();

  /// Files dropped since the last call.
  std::vector<std::filesystem::path> take_dropped();

  /// Closes the innermost open list or menu, after the frame's begin and before its widgets.
  /// Returns whether there was one.
  bool close_popup();

  void set_clipboard(const std::string& text);
  std::string clipboard() const;

  /// "llvmpipe (...), OpenGL 4.5 ..."
  std::string renderer() const;

 private:
  struct Desktop;

  void listen();
  void listen_to_keys();
  void set_up_imgui();
  Image pixels() const;
  void follow_display_scale();

  WindowLook look_;
  float scale_ = 1;
  std::unique_ptr<Desktop> desktop_;
};

}  // namespace brindle::tool
