/// A document that commands change, and the way back.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "session/session_command.h"

namespace brindle::tool {

enum class MessageKind { note, warning, error };

struct SessionMessage {
  MessageKind kind;
  std::string text;
  std::uint64_t revision;  ///< of the document that it is about

  bool operator==(const SessionMessage&) const = default;
};

/// The one source of truth of a window: a document, undo and redo, messages. Knows nothing of
/// threads, patterns and pictures.
class Session {
 public:
  /// Of a document that `check_document` accepts; throws what that throws.
  explicit Session(SessionDocument document = {});

  const SessionDocument& document() const { return document_; }

  /// Grows whenever the document becomes another one, and never comes back to a number.
  std::uint64_t revision() const { return revision_; }

  /// Whether the pattern may follow the one shown before, so that stripes move calmly: after
  /// changes of one surface. Not after undo, redo, another surface or another document, whose
  /// pictures depend on the document alone.
  bool follows() const { return follows_; }

  /// Does it, or refuses: then all stays as it was, and a message says why.
  bool apply(const SessionCommand& command);

  /// The same as the commands.
  void begin_drag();
  void end_drag();
  bool dragging() const { return dragging_; }
  /// Edits alone: the camera stays where it is, unless what comes back is another surface or
  /// session, which has its own.
  bool undo();
  bool redo();
  bool can_undo() const { return !past_.empty(); }
  bool can_redo() const { return !future_.empty(); }

  /// The camera alone. Edits in between stay as they are; another surface or session begins anew.
  bool previous_view();
  bool next_view();
  bool has_previous_view() const { return !views_.past.empty(); }
  bool has_next_view() const { return !views_.future.empty(); }

  /// What undo and redo would change, in words: "number of stripes"; empty if nothing.
  std::string undo_name() const;
  std::string redo_name() const;

  /// The pattern is to be made of the document alone, whatever it followed. A step if the document
  /// has phases, which go.
  void solve_anew();

  /// The pattern that is shown of a revision becomes part of the document, so that it is what comes
  /// back when it is saved or undone. Without phases it was made of the document alone, and those
  /// that the document has go. No step of its own. Nothing if the document has gone on, or already
  /// has the one or the other. Returns whether it was done.
  bool keep_phases(std::uint64_t revision, std::shared_ptr<const std::vector<float>> phases);

  /// The last step or view turned out not to work: a file cannot be read, an array is not there.
  /// Takes the document back to what it was before and leaves the message; nothing can be redone of
  /// it. If the document has gone on since `revision`, or nothing can be undone, only the message
  /// stays. Returns whether the step was taken back.
  bool take_back(std::uint64_t revision, const std::string& why);

  /// The latest, at most a hundred, oldest first.
  const std::deque<SessionMessage>& messages() const { return messages_; }
  void add_message(MessageKind kind, std::string text);

 private:
  struct Step {
    SessionDocument document;  ///< before it, or, of those undone, after it
    std::string name;
    bool anew = false;  ///< another surface or session, with its camera
  };
  /// Cameras before and after the present one, the nearest last.
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

/// Whether a command moves the camera alone, which is no edit: `Session::previous_view` takes it
/// back.
bool turns_view(const SessionCommand& command);

/// Throws Error, naming it, if there is no such file or shape; what is in a file comes out when it
/// is read.
void check_can_open(const std::string& mesh);

/// The document after a command that changes it; throws CLI::ValidationError or Error, naming what
/// is wrong. Not for those that drag, undo, redo, keep phases and solve anew.
SessionDocument changed(const SessionDocument& document, const SessionCommand& command);

}  // namespace brindle::tool
