/// The commands of a session, for the window, tests and scripts alike.
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

/// Another surface. Removes phases and the camera's centre, and strokes unless the surfaces are
/// alike: a shape with another parameter, the next step of a series.
struct Open {
  std::string mesh;
  bool keep_options = true;   ///< otherwise, options are removed, too
  bool keep_strokes = false;  ///< at the same position in space

  bool operator==(const Open&) const = default;
};

/// Sets an option.
struct SetOption {
  std::string name;
  std::vector<std::string> values;  ///< empty for flags

  bool operator==(const SetOption&) const = default;
};

struct ClearOption {
  std::string name;

  bool operator==(const ClearOption&) const = default;
};

/// Changes options that depend on each other: removes those of `clear`, then sets those of `set`.
struct SetOptions {
  OptionValues set;
  std::vector<std::string> clear;

  bool operator==(const SetOptions&) const = default;
};

/// Changes what the picture shows. Options of other pictures are kept for later.
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

/// Replaces all strokes: those of a file, or none.
struct SetStrokes {
  std::vector<FieldStroke> strokes;

  bool operator==(const SetStrokes&) const = default;
};

/// Replaces all strokes that fix dragged singularities; none releases them.
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

/// Stores the camera under a key from 1 to 9.
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

/// Replaces the document, such as by one read from a file.
struct Load {
  SessionDocument document;

  bool operator==(const Load&) const = default;
};

/// Commands between these two are one undo step.
struct BeginDrag {
  bool operator==(const BeginDrag&) const = default;
};
struct EndDrag {
  bool operator==(const EndDrag&) const = default;
};

/// Undoes edits. The camera stays, unless another surface or session is restored.
struct Undo {
  bool operator==(const Undo&) const = default;
};
struct Redo {
  bool operator==(const Redo&) const = default;
};

/// Stores the shown pattern in the document, without a step; null: the pattern depends on the
/// document alone (`Session::keep_phases`).
struct KeepPhases {
  std::shared_ptr<const std::vector<float>> phases;

  bool operator==(const KeepPhases& other) const;
};

/// Makes the pattern from the document alone (`Session::solve_again`).
struct SolveAgain {
  bool operator==(const SolveAgain&) const = default;
};

/// Restores the camera before its last motion or recall, and back. Edits stay; undo and redo are
/// for these.
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
                 commands::KeepPhases, commands::SolveAgain, commands::PreviousView,
                 commands::NextView, commands::SetSteering>;

/// The name of a command in files, such as "set_option".
std::string_view command_name(const SessionCommand& command);

/// A command as an object: `{"command": "set_option", "name": "stripes", "values": ["60"]}`.
nlohmann::ordered_json command_to_json(const SessionCommand& command);
/// Throws Error with the key and the remedy.
SessionCommand command_from_json(const nlohmann::json& json);

/// A list of commands, one line of JSON each; skips empty lines. Throws Error with the file, the
/// line and the remedy.
std::vector<SessionCommand> read_commands(const std::filesystem::path& path);
void write_commands(const std::filesystem::path& path, const std::vector<SessionCommand>& commands);

}  // namespace brindle::tool
