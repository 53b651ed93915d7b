/// The commands of a session, for the window, tests and scripts alike.
#pragma once

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "session/session_document.h"

namespace brindle::tool {

class Session;

/// A command as an object: `{"command": "set_option", "name": "stripes", "values": ["60"]}`. It is
/// checked when it is applied or read from a file.
using SessionCommand = nlohmann::ordered_json;

/// A command of this name with these keys and values.
SessionCommand session_command(
    const std::string& name,
    std::initializer_list<std::pair<const char*, nlohmann::ordered_json>> values = {});

/// Commands as `docs/sessions.md` lists them; `session_command` makes those without values.
namespace commands {

SessionCommand open(const std::string& mesh, bool keep_strokes = false);

/// Flags have no values.
inline SessionCommand set_option(const std::string& name,
                                 const std::vector<std::string>& values = {}) {
  return session_command("set_option", {{"name", name}, {"values", values}});
}
inline SessionCommand clear_option(const std::string& name) {
  return session_command("clear_option", {{"name", name}});
}
inline SessionCommand set_options(const OptionValues& set,
                                  const std::vector<std::string>& clear = {}) {
  return session_command("set_options", {{"set", options_to_json(set)}, {"clear", clear}});
}
inline SessionCommand show(Shown shown) {
  return session_command("show", {{"shown", name_of(shown)}});
}

inline SessionCommand add_stroke(const FieldStroke& stroke) {
  return session_command("add_stroke", {{"stroke", stroke_to_json(stroke)}});
}
inline SessionCommand change_stroke(std::size_t index, const FieldStroke& stroke) {
  return session_command("change_stroke", {{"index", index}, {"stroke", stroke_to_json(stroke)}});
}
inline SessionCommand erase_stroke(std::size_t index) {
  return session_command("erase_stroke", {{"index", index}});
}
inline SessionCommand set_strokes(const std::vector<FieldStroke>& strokes) {
  return session_command("set_strokes", {{"strokes", strokes_to_json(strokes)}});
}
inline SessionCommand set_steering(const std::vector<FieldStroke>& strokes) {
  return session_command("set_steering", {{"strokes", strokes_to_json(strokes)}});
}

inline SessionCommand set_camera(const CameraView& camera) {
  return session_command("set_camera", {{"camera", camera_to_json(camera)}});
}
inline SessionCommand store_view(int key) { return session_command("store_view", {{"key", key}}); }
inline SessionCommand recall_view(int key) {
  return session_command("recall_view", {{"key", key}});
}
SessionCommand set_frequency_by_zoom(float share);

inline SessionCommand load(const SessionDocument& document) {
  return session_command("load", {{"document", document_to_json(document)}});
}
SessionCommand keep_phases(const std::shared_ptr<const std::vector<float>>& phases);

}  // namespace commands

/// The names of all commands, such as "set_option".
std::vector<std::string> command_names();

/// What a command does to a session; returns whether it did anything. Throws Error with the key and
/// the remedy for an object that is no command.
std::function<bool(Session&)> effect_of(const SessionCommand& command);

/// A list of commands, one line of JSON each; skips empty lines. Throws Error with the file, the
/// line and the remedy.
std::vector<SessionCommand> read_commands(const std::filesystem::path& path);
void write_commands(const std::filesystem::path& path, const std::vector<SessionCommand>& commands);

}  // namespace brindle::tool
