/// A document, changed by commands, with undo.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "session/session_command.h"

namespace brindle::tool {

enum class MessageKind { note, warning, error };

struct SessionMessage {
  MessageKind kind;
  std::string text;
  std::uint64_t revision;  ///< of its document

  bool operator==(const SessionMessage&) const = default;
};

/// Changes a document and returns the step's name, as after "Undo" in a menu. Throws
/// CLI::ValidationError or Error.
using DocumentEdit = std::function<std::string(SessionDocument&)>;

enum class EditKind {
  step,
  view,  ///< only moves the camera, which is no step: `Session::previous_view` reverts it
  anew   ///< another surface or session, with its camera
};

/// The single source of truth of a window: document, undo, redo, messages. Independent of threads,
/// patterns and pictures.
class Session {
 public:
  /// The document must pass `check_document`; throws what that throws.
  explicit Session(SessionDocument document = {});

  const SessionDocument& document() const { return document_; }

  /// Increases with each change of the document.
  std::uint64_t revision() const { return revision_; }

  /// Whether the pattern may continue the one shown before, for stable motion: after changes on one
  /// surface. False after undo, redo, another surface or another document, whose pictures depend on
  /// the document alone.
  bool follows() const { return follows_; }

  /// Applies the command, or rejects it with a message and changes nothing.
  bool apply(const SessionCommand& command);

  /// Changes the document. Throws what the edit and `check_document` throw; nothing changes then.
  void edit(const DocumentEdit& edit, EditKind kind);

  /// Edits between these two are one step.
  void begin_drag();
  void end_drag();
  bool dragging() const { return dragging_; }
  /// Edits only: the camera stays, unless another surface or session is restored with its own.
  bool undo();
  bool redo();
  bool can_undo() const { return !past_.empty(); }
  bool can_redo() const { return !future_.empty(); }

  /// The camera only. Edits stay; another surface or session clears the history.
  bool previous_view();
  bool next_view();
  bool has_previous_view() const { return !views_.past.empty(); }
  bool has_next_view() const { return !views_.future.empty(); }

  /// Names of the next undo and redo step: "number of stripes"; empty if there is none.
  std::string undo_name() const;
  std::string redo_name() const;

  /// Makes the next pattern depend on the document alone. A step if the document has phases, which
  /// are removed.
  void solve_again();

  /// Stores the phases of the shown pattern of a revision in the document, to be restored by saving
  /// or undo. Null phases mean that it depends on the document alone, and remove stored ones. This
  /// is no step. Does nothing if the document has changed or already has them. Returns whether it
  /// changed.
  bool keep_phases(std::uint64_t revision, std::shared_ptr<const std::vector<float>> phases);

  /// Reverts the last step or view after it failed, for example for an unreadable file or a missing
  /// array, and leaves the message; it cannot be redone. If the document has changed since
  /// `revision` or nothing can be undone, only the message is added. Returns whether the step was
  /// reverted.
  bool take_back(std::uint64_t revision, const std::string& why);

  /// The latest messages, at most a hundred, oldest first.
  const std::deque<SessionMessage>& messages() const { return messages_; }
  void add_message(MessageKind kind, std::string text);

 private:
  struct Step {
    SessionDocument document;  ///< before an undoable step, or after an undone one
    std::string name;
    bool anew = false;  ///< another surface or session, with its camera
  };
  /// Cameras before and after the present one, nearest last.
  struct Views {
    std::deque<CameraView> past, future;
  };
  enum class Change { none, edit, view };

  void change(SessionDocument document, std::string name, bool anew = false);
  void turn(SessionDocument document);
  void go(SessionDocument document, bool follows);
  SessionDocument document_of(Step step) const;
  bool move(std::deque<Step>& from, std::deque<Step>& to);
  bool move_view(std::deque<CameraView>& from, std::deque<CameraView>& to);
  void forget_old_steps();

  SessionDocument document_;
  std::deque<Step> past_, future_;
  Views views_;
  Change last_change_ = Change::none;  ///< that can be taken back
  std::deque<SessionMessage> messages_;
  std::uint64_t revision_ = 1;
  bool follows_ = false;
  bool dragging_ = false;
  bool drag_has_step_ = false;
  bool drag_has_view_ = false;
};

/// Throws Error with the name if there is no such file or shape; does not read files.
void check_can_open(const std::string& mesh);

}  // namespace brindle::tool
