#include "session/session_command.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "brindle/base/input_file.h"
#include "brindle/base/output_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/recipe/json_text.h"
#include "session/json_reader.h"
#include "session/session.h"
#include "session/session_options.h"

namespace brindle::tool {
namespace {

using Json = nlohmann::ordered_json;
using Effect = std::function<bool(Session&)>;
using Texts = std::vector<std::string>;

constexpr int kMostStrokes = 1 << 30;

Effect edit(DocumentEdit edit, EditKind kind = EditKind::step) {
  return [edit = std::move(edit), kind](Session& session) {
    session.edit(edit, kind);
    return true;
  };
}

Effect always(void (Session::*act)()) {
  return [act](Session& session) {
    (session.*act)();
    return true;
  };
}

/// The option's label in panels.
std::string label_of(const std::string& name, const SessionDocument& document) {
  const OptionInfo* option = find_session_option(name, document.shown);
  return option == nullptr ? name : std::string(option->words);
}

bool flag_in(const JsonReader& r, const char* key, bool standard) {
  return r.has(key) ? r.flag(key) : standard;
}

std::size_t index_in(const JsonReader& r) {
  return static_cast<std::size_t>(r.whole("index", 0, kMostStrokes));
}

FieldStroke& stroke_of(SessionDocument& document, std::size_t index) {
  const std::size_t count = document.strokes.size();
  if (index < count) return document.strokes[index];
  throw Error("there is no stroke " + std::to_string(index) +
              (count == 0 ? "; none is drawn" : "; the last one is " + std::to_string(count - 1)));
}

Effect open_of(const JsonReader& r) {
  return edit(
      [mesh = r.text("mesh"), keep_options = flag_in(r, "keep_options", true),
       keep_strokes = flag_in(r, "keep_strokes", false)](SessionDocument& d) {
        check_can_open(mesh);
        d.mesh = mesh;
        if (!keep_options) {
          d.options.clear();
          d.curves.clear();
          d.samples.clear();
        }
        if (!keep_strokes) {
          d.strokes.clear();
          d.steering.clear();
        }
        d.phases.reset();
        d.camera.center.reset();
        return "opening " + std::filesystem::path(mesh).filename().string();
      },
      EditKind::anew);
}

Effect set_option_of(const JsonReader& r) {
  return edit([name = r.text("name"),
               values = r.has("values") ? r.texts("values") : Texts()](SessionDocument& d) {
    options_with(name, d)[name] = values;
    return label_of(name, d);
  });
}

Effect clear_option_of(const JsonReader& r) {
  return edit([name = r.text("name")](SessionDocument& d) {
    options_with(name, d).erase(name);
    return label_of(name, d) + " left out";
  });
}

Effect set_options_of(const JsonReader& r) {
  return edit([set = r.has("set") ? options_from_json(r.at("set"), "set") : OptionValues(),
               clear = r.has("clear") ? r.texts("clear") : Texts()](SessionDocument& d) {
    std::string words;
    for (const std::string& name : clear) options_with(name, d).erase(name);
    for (const auto& [name, values] : set) {
      options_with(name, d)[name] = values;
      words += (words.empty() ? "" : ", ") + label_of(name, d);
    }
    return words.empty() ? "options left out" : words;
  });
}

Effect show_of(const JsonReader& r) {
  return edit([shown = shown_in(r)](SessionDocument& d) {
    d.shown = shown;
    return "showing " + std::string(name_of(shown));
  });
}

Effect add_stroke_of(const JsonReader& r) {
  return edit([stroke = stroke_from_json(r.at("stroke"), "stroke")](SessionDocument& d) {
    d.strokes.push_back(stroke);
    return "stroke";
  });
}

Effect change_stroke_of(const JsonReader& r) {
  return edit([index = index_in(r),
               stroke = stroke_from_json(r.at("stroke"), "stroke")](SessionDocument& d) {
    stroke_of(d, index) = stroke;
    return "change of a stroke";
  });
}

Effect erase_stroke_of(const JsonReader& r) {
  return edit([index = index_in(r)](SessionDocument& d) {
    stroke_of(d, index);
    d.strokes.erase(d.strokes.begin() + static_cast<std::ptrdiff_t>(index));
    return "erasing a stroke";
  });
}

Effect set_strokes_of(const JsonReader& r) {
  return edit([strokes = strokes_in(r)](SessionDocument& d) {
    d.strokes = strokes;
    return strokes.empty() ? "erasing all strokes" : "strokes of a file";
  });
}

Effect set_steering_of(const JsonReader& r) {
  return edit([strokes = strokes_in(r)](SessionDocument& d) {
    d.steering = strokes;
    return strokes.empty() ? "letting singularities go" : "steering";
  });
}

Effect set_camera_of(const JsonReader& r) {
  return edit(
      [camera = camera_from_json(r.at("camera"))](SessionDocument& d) {
        d.camera = camera;
        return "";
      },
      EditKind::view);
}

Effect set_size_of(const JsonReader& r) {
  return edit([size = size_in(r)](SessionDocument& d) {
    d.size = size;
    return "size of pictures";
  });
}

Effect store_view_of(const JsonReader& r) {
  return edit([key = r.whole("key", 1, kStoredViews)](SessionDocument& d) {
    d.views[static_cast<std::size_t>(key - 1)] = d.camera;
    return "storing view " + std::to_string(key);
  });
}

Effect recall_view_of(const JsonReader& r) {
  return edit(
      [key = r.whole("key", 1, kStoredViews)](SessionDocument& d) {
        const std::optional<CameraView>& view = d.views[static_cast<std::size_t>(key - 1)];
        if (!view) {
          throw Error("no view is stored under the key " + std::to_string(key) +
                      "; store one there first");
        }
        d.camera = *view;
        return "";
      },
      EditKind::view);
}

Effect set_frequency_by_zoom_of(const JsonReader& r) {
  return edit([share = r.number("share", 0, 1)](SessionDocument& d) {
    d.frequency_by_zoom = share;
    return "stripes by zoom";
  });
}

Effect load_of(const JsonReader& r) {
  return edit(
      [document = document_from_json(r.at("document"))](SessionDocument& d) {
        d = document;
        return "opening a session";
      },
      EditKind::anew);
}

Effect keep_phases_of(const JsonReader& r) {
  const bool none = r.at("phases").is_null();
  return [phases = none ? nullptr : phases_in(r)](Session& session) {
    return session.keep_phases(session.revision(), phases);
  };
}

/// A command of docs/sessions.md.
struct CommandRow {
  std::string name;
  Texts keys;  ///< besides its name
  Effect (*read)(const JsonReader&);
};

const std::vector<CommandRow>& command_rows() {
  static const std::vector<CommandRow> rows = {
      {"open", {"mesh", "keep_options", "keep_strokes"}, open_of},
      {"set_option", {"name", "values"}, set_option_of},
      {"clear_option", {"name"}, clear_option_of},
      {"set_options", {"set", "clear"}, set_options_of},
      {"show", {"shown"}, show_of},
      {"add_stroke", {"stroke"}, add_stroke_of},
      {"change_stroke", {"index", "stroke"}, change_stroke_of},
      {"erase_stroke", {"index"}, erase_stroke_of},
      {"set_strokes", {"strokes"}, set_strokes_of},
      {"set_camera", {"camera"}, set_camera_of},
      {"set_size", {"size"}, set_size_of},
      {"store_view", {"key"}, store_view_of},
      {"recall_view", {"key"}, recall_view_of},
      {"set_frequency_by_zoom", {"share"}, set_frequency_by_zoom_of},
      {"load", {"document"}, load_of},
      {"begin_drag", {}, [](const JsonReader&) { return always(&Session::begin_drag); }},
      {"end_drag", {}, [](const JsonReader&) { return always(&Session::end_drag); }},
      {"undo", {}, [](const JsonReader&) -> Effect { return &Session::undo; }},
      {"redo", {}, [](const JsonReader&) -> Effect { return &Session::redo; }},
      {"keep_phases", {"phases"}, keep_phases_of},
      {"solve_again", {}, [](const JsonReader&) { return always(&Session::solve_again); }},
      {"previous_view", {}, [](const JsonReader&) -> Effect { return &Session::previous_view; }},
      {"next_view", {}, [](const JsonReader&) -> Effect { return &Session::next_view; }},
      {"set_steering", {"strokes"}, set_steering_of}};
  return rows;
}

}  // namespace

SessionCommand session_command(const std::string& name,
                               std::initializer_list<std::pair<const char*, Json>> values) {
  SessionCommand command;
  command["command"] = name;
  for (const auto& [key, value] : values) command[key] = value;
  return command;
}

SessionCommand commands::open(const std::string& mesh, bool keep_strokes) {
  SessionCommand open = session_command("open", {{"mesh", mesh}});
  if (keep_strokes) open["keep_strokes"] = true;
  return open;
}

SessionCommand commands::set_frequency_by_zoom(float share) {
  return session_command("set_frequency_by_zoom", {{"share", short_number(share)}});
}

SessionCommand commands::keep_phases(const std::shared_ptr<const std::vector<float>>& phases) {
  return session_command("keep_phases", {{"phases", phases ? phases_to_json(*phases) : Json()}});
}

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const CommandRow& row : command_rows()) names.push_back(row.name);
  return names;
}

std::function<bool(Session&)> effect_of(const SessionCommand& command) {
  const JsonReader reader(command, "");
  const std::string name = reader.text("command");
  const auto row = std::ranges::find(command_rows(), name, &CommandRow::name);
  if (row != command_rows().end()) {
    Texts keys = row->keys;
    keys.insert(keys.begin(), "command");
    reader.allow(keys);
    return row->read(reader);
  }
  const std::string meant = nearest(name, command_names());
  std::string list;
  for (const std::string& one : command_names()) list += (list.empty() ? "" : ", ") + one;
  throw Error("'" + name + "' is no command" +
              (meant.empty() ? "" : " (did you mean '" + meant + "'?)") +
              "; commands are: " + list);
}

std::vector<SessionCommand> read_commands(const std::filesystem::path& path) {
  InputFile file(path);
  std::vector<SessionCommand> commands;
  while (const std::optional<std::string_view> line = file.next_line()) {
    if (line->find_first_not_of(" \t\r") == std::string_view::npos) continue;
    try {
      commands.push_back(parse_json(std::string(*line)));
      effect_of(commands.back());
    } catch (const std::exception& error) {
      throw Error(shown(path.native()) + ":" + std::to_string(file.line()) + ": " + error.what());
    }
  }
  return commands;
}

void write_commands(const std::filesystem::path& path,
                    const std::vector<SessionCommand>& commands) {
  write_file(path, [&](OutputStream& out) {
    for (const SessionCommand& command : commands) out << json_text(command) << '\n';
  });
}

}  // namespace brindle::tool
