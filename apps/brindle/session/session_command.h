/// What can be done to a session. The window, tests and scripts do nothing else.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <nlohmann/json.hpp>

#include "session/session_document.h"

namespace brindle::tool::commands {

/// Another surface. Phases and the camera's centre were the old one's and go, and so do strokes,
/// unless it is one like the old: a shape with another parameter, the next step of a series.
struct Open {
  std::string mesh;
  bool keep_options = true;   ///< else all options go, too
  bool keep_strokes = false;  ///< they stay where they are in space

  bool operator==(const Open&) const = default;
};

/// Gives an option, in place of what it was.
struct SetOption {
  std::string name;
  std::vector<std::string> values;  ///< empty for flags

  bool operator==(const SetOption&) const = default;
};

struct ClearOption {
  std::string name;

  bool operator==(const ClearOption&) const = default;
};

/// Several options at once, for those that need each other: first all of `clear` go, then `set` is
/// given.
struct SetOptions {
  OptionValues set;
  std::vector<std::string> clear;

  bool operator==(const SetOptions&) const = default;
};

/// What the picture shows. Options that another picture has alone stay as they are until it is
/// shown again.
struct Show {
  Shown what;

  bool operator==(const Show&) const = default;
};

struct AddStroke {
  FieldStroke stroke;

  bool operator==(const AddStroke&) const = default;
};

struct ChangeStroke {
  std::size_t index;
  FieldStroke stroke;

  bool operator==(const ChangeStroke&) const = default;
};

struct EraseStroke {
  std::size_t index;

  bool operator==(const EraseStroke&) const = default;
};

/// All strokes at once: those of a file, or none.
struct SetStrokes {
  std::vector<FieldStroke> strokes;

  bool operator==(const SetStrokes&) const = default;
};

/// All strokes that hold singularities where they were dragged; none lets them go.
struct SetSteering {
  std::vector<FieldStroke> strokes;

  bool operator==(const SetSteering&) const = default;
};

struct SetCamera {
  CameraView camera;

  bool operator==(const SetCamera&) const = default;
};

struct SetSize {
  PictureSize size;

  bool operator==(const SetSize&) const = default;
};

/// Keeps the camera under a key from 1 to 9.
struct StoreView {
  int key;

  bool operator==(const StoreView&) const = default;
};

struct RecallView {
  int key;

  bool operator==(const RecallView&) const = default;
};

struct SetFrequencyByZoom {
  float share;

  bool operator==(const SetFrequencyByZoom&) const = default;
};

/// Another document in place of this one, such as one that was read from a file.
struct Load {
  SessionDocument document;

  bool operator==(const Load&) const = default;
};

/// What is done between these two is undone in one step.
struct BeginDrag {
  bool operator==(const BeginDrag&) const = default;
};
struct EndDrag {
  bool operator==(const EndDrag&) const = default;
};

/// Of edits, which leave the camera as it is unless they open another surface or session.
struct Undo {
  bool operator==(const Undo&) const = default;
};
struct Redo {
  bool operator==(const Redo&) const = default;
};

/// The pattern that is shown becomes part of the document, without a step of its own; null: it was
/// made of the document alone (`Session::keep_phases`).
struct KeepPhases {
  std::shared_ptr<const std::vector<float>> phases;

  bool operator==(const KeepPhases& other) const;
};

/// The pattern is made of the document alone, as if nothing had come before
/// (`Session::solve_anew`).
struct SolveAnew {
  bool operator==(const SolveAnew&) const = default;
};

/// The camera as it was before it was last turned, moved or recalled, and back again. Edits stay:
/// these are what undo and redo are for.
struct PreviousView {
  bool operator==(const PreviousView&) const = default;
};
struct NextView {
  bool operator==(const NextView&) const = default;
};

}  // namespace brindle::tool::commands

namespace brindle::tool {

using SessionCommand =
    std::variant<commands::Open, commands::SetOption, commands::ClearOption, commands::SetOptions,
                 commands::Show, commands::AddStroke, commands::ChangeStroke, commands::EraseStroke,
                 commands::SetStrokes, commands::SetCamera, commands::SetSize, commands::StoreView,
                 commands::RecallView, commands::SetFrequencyByZoom, commands::Load,
                 commands::BeginDrag, commands::EndDrag, commands::Undo, commands::Redo,
                 commands::KeepPhases, commands::SolveAnew, commands::PreviousView,
                 commands::NextView, commands::SetSteering>;

/// "set_option", the name of a command in files.
std::string_view command_name(const SessionCommand& command);

/// One object a command: `{"command": "set_option", "name": "stripes", "values": ["60"]}`.
nlohmann::ordered_json command_to_json(const SessionCommand& command);
/// Throws Error naming the key and what to do.
SessionCommand command_from_json(const nlohmann::json& json);

/// A list of commands, one line of JSON each; empty lines are passed over. Throws Error naming the
/// file, the line and what to do.
std::vector<SessionCommand> read_commands(const std::filesystem::path& path);
void write_commands(const std::filesystem::path& path, const std::vector<SessionCommand>& commands);

}  // namespace brindle::tool
