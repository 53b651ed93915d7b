#include "session/session_command.h"

#include <array>
#include <utility>

#include "brindle/base/input_file.h"
#include "brindle/base/output_file.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/recipe/json_text.h"
#include "session/json_reader.h"

namespace brindle::tool {

bool commands::KeepPhases::operator==(const KeepPhases& other) const {
  return phases == other.phases || (phases && other.phases && *phases == *other.phases);
}

namespace {

using Json = nlohmann::ordered_json;

/// In the order of SessionCommand.
constexpr std::array<std::string_view, std::variant_size_v<SessionCommand>> kCommandNames = {
    "open",          "set_option",
    "clear_option",  "set_options",
    "show",          "add_stroke",
    "change_stroke", "erase_stroke",
    "set_strokes",   "set_camera",
    "set_size",      "store_view",
    "recall_view",   "set_frequency_by_zoom",
    "load",          "begin_drag",
    "end_drag",      "undo",
    "redo",          "keep_phases",
    "solve_again",   "previous_view",
    "next_view",     "set_steering"};

/// Adds a command's fields to its object.
struct CommandWriter {
  Json& json;

  void operator()(const commands::Open& c) const {
    json["mesh"] = c.mesh;
    if (!c.keep_options) json["keep_options"] = false;
    if (c.keep_strokes) json["keep_strokes"] = true;
  }
  void operator()(const commands::SetOption& c) const {
    json["name"] = c.name;
    json["values"] = c.values;
  }
  void operator()(const commands::ClearOption& c) const { json["name"] = c.name; }
  void operator()(const commands::SetOptions& c) const {
    json["set"] = options_to_json(c.set);
    json["clear"] = c.clear;
  }
  void operator()(const commands::Show& c) const { json["shown"] = name_of(c.what); }
  void operator()(const commands::AddStroke& c) const { json["stroke"] = stroke_to_json(c.stroke); }
  void operator()(const commands::ChangeStroke& c) const {
    json["index"] = c.index;
    json["stroke"] = stroke_to_json(c.stroke);
  }
  void operator()(const commands::EraseStroke& c) const { json["index"] = c.index; }
  void operator()(const commands::SetStrokes& c) const {
    json["strokes"] = strokes_to_json(c.strokes);
  }
  void operator()(const commands::SetSteering& c) const {
    json["strokes"] = strokes_to_json(c.strokes);
  }
  void operator()(const commands::SetCamera& c) const { json["camera"] = camera_to_json(c.camera); }
  void operator()(const commands::SetSize& c) const { json["size"] = size_to_json(c.size); }
  void operator()(const commands::StoreView& c) const { json["key"] = c.key; }
  void operator()(const commands::RecallView& c) const { json["key"] = c.key; }
  void operator()(const commands::SetFrequencyByZoom& c) const {
    json["share"] = short_number(c.share);
  }
  void operator()(const commands::Load& c) const {
    json["document"] = document_to_json(c.document);
  }
  void operator()(const commands::KeepPhases& c) const {
    json["phases"] = c.phases ? phases_to_json(*c.phases) : Json();
  }
  void operator()(const commands::BeginDrag&) const {}
  void operator()(const commands::EndDrag&) const {}
  void operator()(const commands::Undo&) const {}
  void operator()(const commands::Redo&) const {}
  void operator()(const commands::SolveAgain&) const {}
  void operator()(const commands::PreviousView&) const {}
  void operator()(const commands::NextView&) const {}
};

constexpr int kMostStrokes = 1 << 30;

commands::Open open_from(const JsonReader& reader) {
  reader.allow({"command", "mesh", "keep_options", "keep_strokes"});
  return {reader.text("mesh"), !reader.has("keep_options") || reader.flag("keep_options"),
          reader.has("keep_strokes") && reader.flag("keep_strokes")};
}

commands::SetOption set_option_from(const JsonReader& reader) {
  reader.allow({"command", "name", "values"});
  return {reader.text("name"),
          reader.has("values") ? reader.texts("values") : std::vector<std::string>()};
}

commands::SetOptions set_options_from(const JsonReader& reader) {
  reader.allow({"command", "set", "clear"});
  commands::SetOptions command;
  if (reader.has("set")) command.set = options_from_json(reader.at("set"), "set");
  if (reader.has("clear")) command.clear = reader.texts("clear");
  return command;
}

std::size_t index_from(const JsonReader& reader) {
  return static_cast<std::size_t>(reader.whole("index", 0, kMostStrokes));
}

int key_from(const JsonReader& reader) {
  reader.allow({"command", "key"});
  return reader.whole("key", 1, kStoredViews);
}

commands::KeepPhases keep_phases_from(const JsonReader& reader) {
  reader.allow({"command", "phases"});
  if (reader.at("phases").is_null()) return {};
  return {phases_in(reader)};
}

/// Commands without fields.
template <class Command>
Command bare(const JsonReader& reader) {
  reader.allow({"command"});
  return {};
}

using ReadCommand = SessionCommand (*)(const JsonReader&);

/// In the order of the names.
constexpr std::array<ReadCommand, std::variant_size_v<SessionCommand>> kReaders = {
    [](const JsonReader& r) -> SessionCommand { return open_from(r); },
    [](const JsonReader& r) -> SessionCommand { return set_option_from(r); },
    [](const JsonReader& r) -> SessionCommand {
      r.allow({"command", "name"});
      return commands::ClearOption{r.text("name")};
    },
    [](const JsonReader& r) -> SessionCommand { return set_options_from(r); },
    [](const JsonReader& r) -> SessionCommand {
      r.allow({"command", "shown"});
      return commands::Show{shown_in(r)};
    },
    [](const JsonReader& r) -> SessionCommand {
      r.allow({"command", "stroke"});
      return commands::AddStroke{stroke_from_json(r.at("stroke"), "stroke")};
    },
    [](const JsonReader& r) -> SessionCommand {
      r.allow({"command", "index", "stroke"});
      return commands::ChangeStroke{index_from(r), stroke_from_json(r.at("stroke"), "stroke")};
    },
    [](const JsonReader& r) -> SessionCommand {
      r.allow({"command", "index"});
      return commands::EraseStroke{index_from(r)};
    },
    [](const JsonReader& r) -> SessionCommand {
      r.allow({"command", "strokes"});
      return commands::SetStrokes{strokes_in(r)};
    },
    [](const JsonReader& r) -> SessionCommand {
      r.allow({"command", "camera"});
      return commands::SetCamera{camera_from_json(r.at("camera"))};
    },
    [](const JsonReader& r) -> SessionCommand {
      r.allow({"command", "size"});
      return commands::SetSize{size_in(r)};
    },
    [](const JsonReader& r) -> SessionCommand { return commands::StoreView{key_from(r)}; },
    [](const JsonReader& r) -> SessionCommand { return commands::RecallView{key_from(r)}; },
    [](const JsonReader& r) -> SessionCommand {
      r.allow({"command", "share"});
      return commands::SetFrequencyByZoom{r.number("share", 0, 1)};
    },
    [](const JsonReader& r) -> SessionCommand {
      r.allow({"command", "document"});
      return commands::Load{document_from_json(r.at("document"))};
    },
    [](const JsonReader& r) -> SessionCommand { return bare<commands::BeginDrag>(r); },
    [](const JsonReader& r) -> SessionCommand { return bare<commands::EndDrag>(r); },
    [](const JsonReader& r) -> SessionCommand { return bare<commands::Undo>(r); },
    [](const JsonReader& r) -> SessionCommand { return bare<commands::Redo>(r); },
    [](const JsonReader& r) -> SessionCommand { return keep_phases_from(r); },
    [](const JsonReader& r) -> SessionCommand { return bare<commands::SolveAgain>(r); },
    [](const JsonReader& r) -> SessionCommand { return bare<commands::PreviousView>(r); },
    [](const JsonReader& r) -> SessionCommand { return bare<commands::NextView>(r); },
    [](const JsonReader& r) -> SessionCommand {
      r.allow({"command", "strokes"});
      return commands::SetSteering{strokes_in(r)};
    },
};

}  // namespace

std::string_view command_name(const SessionCommand& command) {
  return kCommandNames[command.index()];
}

nlohmann::ordered_json command_to_json(const SessionCommand& command) {
  Json json = {{"command", command_name(command)}};
  std::visit(CommandWriter{json}, command);
  return json;
}

SessionCommand command_from_json(const nlohmann::json& json) {
  const JsonReader reader(json, "");
  const std::string name = reader.text("command");
  for (std::size_t i = 0; i < kCommandNames.size(); ++i) {
    if (kCommandNames[i] == name) return kReaders[i](reader);
  }
  const std::vector<std::string> known(kCommandNames.begin(), kCommandNames.end());
  const std::string meant = nearest(name, known);
  std::string list;
  for (const std::string& one : known) list += (list.empty() ? "" : ", ") + one;
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
      commands.push_back(command_from_json(parse_json(std::string(*line))));
    } catch (const std::exception& error) {
      throw Error(shown(path.native()) + ":" + std::to_string(file.line()) + ": " + error.what());
    }
  }
  return commands;
}

void write_commands(const std::filesystem::path& path,
                    const std::vector<SessionCommand>& commands) {
  write_file(path, [&](OutputStream& out) {
    for (const SessionCommand& command : commands) {
      out << json_text(command_to_json(command)) << '\n';
    }
  });
}

}  // namespace brindle::tool
