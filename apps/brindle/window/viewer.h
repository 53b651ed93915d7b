/// The window of `brindle view`.
#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "window/base/app_window.h"
#include "window/base/background_jobs.h"
#include "window/base/live_session.h"
#include "window/base/recording.h"
#include "window/base/window_settings.h"
#include "window/dialogs/export_dialog.h"
#include "window/dialogs/file_browser.h"
#include "window/dialogs/shape_dialog.h"
#include "window/panels/gallery_menu.h"
#include "window/panels/metric_panel.h"
#include "window/panels/option_panel.h"
#include "window/picture/picture_view.h"
#include "window/picture/stroke_tool.h"

namespace brindle::tool {

struct ViewerOptions {
  int width = 1280;  ///< of the window, in desktop units
  int height = 800;
  float scale = 0;                 ///< of text; 0: the desktop's
  std::optional<bool> dark;        ///< empty: as last time
  std::filesystem::path log;       ///< empty: none
  std::filesystem::path commands;  ///< empty: none
  std::filesystem::path output;    ///< writes a picture of the window, then closes it
  std::filesystem::path settings;  ///< empty: none
};

/// The window's parts: menus, keys, panels and the picture.
class Viewer {
 public:
  /// Opens the window. Throws Error on failure.
  Viewer(SessionDocument document, std::filesystem::path session_file,
         const ViewerOptions& options);
  ~Viewer();

  /// Runs until the user closes the window. Throws Error if OpenGL is lost or the initial document
  /// cannot be shown; unsaved work is then saved beside the settings, in a file that the message
  /// names.
  void run();

  /// Adds a mesh or a session to the recent files.
  void remember_opened(const std::string& name);

  /// Opens a session, a file of strokes, a mesh or a shape. On failure, nothing changes and a
  /// message is added.
  void open(const std::string& name);

 private:
  /// A question before an action that would lose unsaved work.
  struct LossQuestion {
    std::string text;
    std::string what;          ///< "quit", "open"
    std::function<void()> go;  ///< the action
    bool newly_asked = true;
  };

  void run_until_closed();
  std::string rescued() const;
  bool is_to_close();
  bool turn();
  double shortest_pause() const;
  double wait_seconds() const;
  void draw();
  void write_window_picture(Image picture);
  void draw_panels();
  void draw_options(float height);
  void draw_place_box();
  void draw_camera();
  void draw_metrics(float height);
  void draw_picture(float left, float right, float height);
  void draw_status();
  void draw_jobs();
  void draw_working();
  void draw_message();
  void draw_keys();
  void draw_question();

  void draw_menus();
  void draw_file_menu();
  void draw_recent_menu();
  void draw_shape_menu();
  void draw_save_items();
  void draw_export_items();
  void draw_edit_menu();
  void draw_view_menu();
  void draw_side_items();
  void draw_stored_views();
  void draw_gallery_menu() { gallery_.draw_menu(); }
  void draw_help_menu();
  bool item(const char* label, const char* keys, bool chosen = false, bool enabled = true);

  void follow_keys();
  void follow_control_key(const PressedKey& key);
  void follow_alt_key(const PressedKey& key);
  void follow_plain_key(const PressedKey& key);
  void follow_letter(int key);
  void take_dropped();
  void open_dropped();

  void ask_open();
  void open_mesh(const std::string& name);
  void unless_lost(const SessionDocument& after, const std::string& by, std::function<void()> go);
  void ask_save_session(std::function<void()> then = {});
  void save_session(const std::filesystem::path& path, std::function<void()> then = {});
  std::string forget_unread(const std::string& name);
  void ask_save_picture();
  void ask_save_window();
  using Export = void (*)(const LiveState&, const std::filesystem::path&, JobListener&);
  void ask_export(const std::string& title, std::vector<std::string> extensions, Export write);
  void ask_strokes(bool save);
  void open_strokes(const std::filesystem::path& path);
  void toggle_recording();
  void stop_recording();
  void set_camera(const CameraView& view);
  void solve_again();
  void paste_view();
  void show_view(const std::string& name);
  void cycle_view();
  void toggle_theme();
  void remember_settings();
  std::string stem() const;

  ViewerOptions options_;
  WindowSettings settings_;
  WindowLog log_;
  AppWindow window_;
  LiveSession live_;
  BackgroundJobs jobs_;
  FileBrowser browser_;
  ExportDialog export_;
  OptionPanel option_panel_;
  MetricPanel metric_panel_;
  ShapeDialog shapes_;
  StrokeTool tool_;
  PlaceHandles places_;
  PictureView picture_;
  GalleryMenu gallery_;
  std::unique_ptr<Recording> recording_;
  std::filesystem::path session_file_;
  std::filesystem::path window_picture_;   // to write after the next frame
  std::optional<SessionMessage> message_;  // shown over the picture
  double message_since_ = 0;
  bool show_keys_ = false;
  std::optional<LossQuestion> question_;  // waiting for an answer
  std::deque<std::filesystem::path> dropped_;
  bool may_quit_ = false;     // despite unsaved work
  bool quits_later_ = false;  // once files are written
  int frames_to_draw_ = 3;
  int frames_to_picture_ = 0;  // of the window, until dialogs are gone
  int frames_to_mark_ = 0;     // until the log's mark
  int marks_ = 0;
  double last_drawn_ = 0;
  std::size_t drawn_ = 0;
  double window_milliseconds_ = 0;
  float options_width_ = 0;
};

}  // namespace brindle::tool
