// Input and output of the window.

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "brindle/base/file_names.h"
#include "brindle/base/input_file.h"
#include "brindle/base/output_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "cli/described_options.h"
#include "session/session_export.h"
#include "window/viewer.h"

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> opened_files() {
  std::vector<std::string> extensions = words_between_spaces(kMeshFiles);
  extensions.insert(extensions.end(), {".csv", ".json"});
  return extensions;
}

// Whether it is a file of strokes, which has no other keys.
bool holds_strokes_alone(const fs::path& path) {
  const auto json = nlohmann::json::parse(whole_input(path, "a session"), nullptr, false);
  return json.is_object() && json.contains("strokes") && !json.contains("mesh");
}

}  // namespace

std::string Viewer::stem() const {
  const std::string& mesh = live_.document().mesh;
  if (!session_file_.empty()) return session_file_.stem().string();
  if (!mesh.starts_with("shape:")) return fs::path(mesh).stem().string();
  return mesh.substr(6, mesh.find(',') - 6);
}

void Viewer::open(const std::string& name) {
  try {
    if (lower_extension(name) != ".json") return open_mesh(name);
    if (holds_strokes_alone(name)) return open_strokes(name);
    const SessionDocument document = read_session(name);
    unless_lost(document, shown(fs::path(name).filename().native()), [this, name, document] {
      if (!live_.apply(commands::load(document))) return;
      session_file_ = name;
      live_.note_saved();
      remember_opened(name);
    });
  } catch (const std::exception& error) {
    live_.add_message(MessageKind::error, error.what() + forget_unread(name));
  }
}

// The worker's thread reports unreadable files.
void Viewer::open_mesh(const std::string& name) {
  try {
    check_can_open(name);
  } catch (const Error& error) {
    return live_.add_message(MessageKind::error, error.what() + forget_unread(name));
  }
  SessionDocument after = live_.document();
  after.strokes.clear();  // as in `Open`
  after.steering.clear();
  unless_lost(after, shown(fs::path(name).filename().native()), [this, name] {
    // Shapes have their own menu.
    if (live_.apply(commands::open(name)) && !name.starts_with("shape:")) remember_opened(name);
  });
}

std::string Viewer::forget_unread(const std::string& name) {
  if (!forget(settings_, name)) return "";
  remember_settings();
  return "\nIt is no longer among the recent files.";
}

// Asks first if unsaved work would be lost.
void Viewer::unless_lost(const SessionDocument& after, const std::string& by,
                         std::function<void()> go) {
  const std::vector<std::string_view> lost = live_.lost_by(after);
  if (lost.empty()) return go();
  std::string words;
  for (const std::string_view part : lost) {
    words += (words.empty() ? "" : part == lost.back() ? " and " : ", ") + std::string(part);
  }
  question_ = LossQuestion{
      "The session has " + words + " that are not saved. Opening " + by + " takes their place.",
      "open", std::move(go)};
  frames_to_draw_ = std::max(frames_to_draw_, 1);
}

void Viewer::open_strokes(const fs::path& path) {
  try {
    live_.apply(commands::set_strokes(read_strokes(path)));
  } catch (const Error& error) {
    live_.add_message(MessageKind::error, error.what());
  }
}

void Viewer::take_dropped() {
  for (const fs::path& path : window_.take_dropped()) {
    log_.write("drop", {{"file", path.string()}});
    dropped_.push_back(path);
  }
  open_dropped();
}

// One after the other; questions about one are answered before the next.
void Viewer::open_dropped() {
  while (!dropped_.empty() && !question_ && !browser_.is_open()) {
    const fs::path path = std::move(dropped_.front());
    dropped_.pop_front();
    open(path.string());
  }
}

void Viewer::ask_open() {
  browser_.ask({.title = "Open a mesh, a session or strokes",
                .extensions = opened_files(),
                .done = [this](const fs::path& path) { open(path.string()); }});
}

void Viewer::ask_save_session(std::function<void()> then) {
  browser_.ask(
      {.title = "Save the session",
       .extensions = {".json"},
       .save = true,
       .name = stem() + ".json",
       .done = [this, then = std::move(then)](const fs::path& path) { save_session(path, then); }});
}

// Saves the document together with its final pattern.
void Viewer::save_session(const fs::path& path, std::function<void()> then) {
  live_.end_drag();
  live_.when_at_rest([this, path, then = std::move(then)](const auto&) {
    try {
      write_session(path, live_.document_as_shown());
      session_file_ = path;
      live_.note_saved();
      remember_opened(path.string());
      live_.add_message(MessageKind::note, "wrote " + shown(path.native()));
      if (then) then();
    } catch (const Error& error) {
      live_.add_message(MessageKind::error, error.what());
    }
  });
}

void Viewer::ask_save_picture() {
  browser_.ask({.title = "Save the picture",
                .extensions = {".png"},
                .save = true,
                .name = stem() + ".png",
                .refusal = picture_refusal,
                .done = [this](const fs::path& path) {
                  live_.when_at_rest(
                      [this, path](const std::shared_ptr<const SessionFrame>& frame) {
                        if (!frame->nothing_left.empty()) {
                          return live_.add_message(MessageKind::error, frame->nothing_left);
                        }
                        jobs_.start([path, frame] {
                          write_png(path, frame->image);
                          return "wrote " + shown(path.native());
                        });
                      });
                }});
}

void Viewer::ask_save_window() {
  browser_.ask({.title = "Save a picture of the window",
                .extensions = {".png"},
                .save = true,
                .name = stem() + "_window.png",
                .refusal = picture_refusal,
                .done = [this](const fs::path& path) {
                  live_.when_at_rest([this, path](const auto&) {
                    window_picture_ = path;
                    frames_to_picture_ = 2;
                  });
                }});
}

void Viewer::ask_export(const std::string& title, std::vector<std::string> extensions,
                        Export write) {
  const std::string name = stem() + "_stripes" + extensions.front();
  const auto save = [this, write](const fs::path& path) {
    live_.when_at_rest([this, path, write](const std::shared_ptr<const SessionFrame>& frame) {
      jobs_.write(path, [path, write, state = frame->state](JobListener& listener) {
        write(*state, path, listener);
      });
    });
  };
  browser_.ask({.title = title,
                .extensions = std::move(extensions),
                .save = true,
                .name = name,
                .done = save});
}

void Viewer::ask_strokes(bool save) {
  const auto write = [this](const fs::path& path) {
    try {
      write_strokes(path, all_strokes(live_.document()));
      live_.add_message(MessageKind::note, "wrote " + shown(path.native()));
    } catch (const Error& error) {
      live_.add_message(MessageKind::error, error.what());
    }
  };
  const auto read = [this](const fs::path& path) { open_strokes(path); };
  browser_.ask({.title = save ? "Save the strokes" : "Load strokes",
                .extensions = {".json"},
                .save = save,
                .name = save ? stem() + "_strokes.json" : "",
                .done = save ? std::function<void(const fs::path&)>(write) : read});
}

void Viewer::toggle_recording() {
  if (recording_) return stop_recording();
  if (!live_.frame()) return;
  try {
    check_video_available(stem() + ".mp4");
  } catch (const Error& error) {
    return live_.add_message(MessageKind::error, error.what());
  }
  browser_.ask({.title = "Record a video",
                .extensions = {".mp4"},
                .save = true,
                .name = stem() + ".mp4",
                .done = [this](const fs::path& path) {
                  try {
                    check_output_path(path);
                    recording_ = std::make_unique<Recording>(path, live_.frame());
                  } catch (const Error& error) {
                    live_.add_message(MessageKind::error, error.what());
                  }
                }});
}

// The encoder takes a while to finish.
void Viewer::stop_recording() {
  jobs_.start([recording = std::shared_ptr<Recording>(std::move(recording_))] {
    recording->finish();
    return "wrote " + shown(recording->path().native());
  });
}

}  // namespace brindle::tool
