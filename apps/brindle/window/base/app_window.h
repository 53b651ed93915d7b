/// A window of the desktop with Dear ImGui in it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "brindle/image.h"

namespace brindle::tool {

/// Of the whole window.
struct WindowLook {
  bool dark = true;
  float scale = 0;  ///< of text and widgets; 0: what the desktop says
};

/// A key by GLFW's numbers; '?' wherever it is on the keyboard.
struct PressedKey {
  int key = 0;
  bool control = false;
  bool shift = false;
  bool repeated = false;
  bool alt = false;
};

/// One at a time. Belongs to the thread that makes it, which must be the program's first.
class AppWindow {
 public:
  /// `width` and `height` in the desktop's units. Throws Error, naming the remedy, if there is no
  /// display or no OpenGL 3.2 on it.
  AppWindow(const std::string& title, int width, int height, const WindowLook& look);
  ~AppWindow();
  AppWindow(const AppWindow&) = delete;
  AppWindow& operator=(const AppWindow&) = delete;

  /// Whether the user has asked to close it since `keep_open`.
  bool closing() const;
  void keep_open();
  void ask_to_close();

  /// Waits for input or this long, whichever comes first. True if there was any.
  bool wait(double seconds);

  /// Starts a frame of Dear ImGui. The text and widgets that follow belong to it.
  void begin_frame();

  /// Draws it, and copies the window's pixels, opaque, to `copy` if there is one. Throws Error if
  /// OpenGL was lost.
  void end_frame(Image* copy = nullptr);

  void set_title(const std::string& title);
  void set_dark(bool dark);
  bool dark() const { return look_.dark; }

  /// Pixels of the framebuffer per unit of Dear ImGui.
  float pixels_per_unit() const;

  /// How large text is beside that of a plain display.
  float scale() const { return scale_; }

  /// Keys pressed since the last call, those held repeated. They are here even if they were
  /// released before the next frame.
  std::vector<PressedKey> take_keys();

  /// Where the mouse was since the last call while its left button was down, in units of Dear
  /// ImGui, from where it was pressed: what is drawn must not depend on how often windows are.
  std::vector<Eigen::Vector2f> take_trail();

  /// Files dropped since the last call.
  std::vector<std::filesystem::path> take_dropped();

  /// Closes the innermost list or menu that is open, between frames' beginning and their widgets.
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
