/// A session and the thread that solves and draws it: what is asked for, and when.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "session/session.h"
#include "session/session_worker.h"
#include "window/base/window_log.h"

namespace brindle::tool {

/// How a widget has changed a value.
enum class ValueChange { none, dragged, typed };

/// What there is to say of the frame, in the words of the panels.
std::vector<std::string> notes_of(const SessionFrame& frame);

/// All that happens to the session goes through here. Nothing waits for the worker: changes are
/// drawn at interactive quality at once, and with care when nothing has changed for a while.
class LiveSession {
 public:
  /// `commands` is a file for all that is done, for `brindle render --replay`; empty: none.
  LiveSession(SessionDocument document, WindowLog& log, const std::filesystem::path& commands = {});

  const Session& session() const { return session_; }
  const SessionDocument& document() const { return session_.document(); }

  /// The document with the size of the picture in the window: what is saved. That size is no step
  /// to undo.
  SessionDocument document_as_shown() const;

  /// As `Session::apply`.
  bool apply(const SessionCommand& command);
  /// The same within a drag, which begins here if none has: all until `end_drag` is undone in one
  /// step.
  bool apply_dragged(const SessionCommand& command);
  void end_drag();

  /// What a widget has changed: what is dragged within a drag, what is typed as a step of its own.
  bool apply_value(ValueChange change, const SessionCommand& command);

  /// The same of what moves while no button is pressed, such as the wheel: a drag that ends by
  /// itself, once `end_drag_at_rest` finds that nothing has moved for a while.
  bool apply_moving(const SessionCommand& command);
  /// The drag goes on for a while, because what is done is not finished.
  void hold_drag() { last_moving_ = Clock::now(); }
  /// To be called once a frame. `pressed`: a button is, so that nothing ends.
  void end_drag_at_rest(bool pressed);

  /// Whether there is something to lose: options, strokes or stored views that differ from those
  /// that were there at first, opened or saved last.
  bool has_unsaved_work() const { return !same_work(session_.document(), saved_); }
  void note_saved() { saved_ = session_.document(); }
  /// What a document in place of this one would take away that is not saved (`lost_work`).
  std::vector<std::string_view> lost_by(const SessionDocument& after) const {
    return lost_work(session_.document(), saved_, after);
  }

  /// Hears of meshes that cannot be read, and says what else the message of it is to say.
  using UnreadTaker = std::function<std::string(const std::string& mesh)>;
  void when_unread(UnreadTaker taker) { unread_taker_ = std::move(taker); }

  bool undo() { return apply(commands::Undo{}); }
  bool redo() { return apply(commands::Redo{}); }
  bool previous_view() { return apply(commands::PreviousView{}); }
  bool next_view() { return apply(commands::NextView{}); }
  void add_message(MessageKind kind, const std::string& text);

  void set_picture_size(PictureSize size);

  /// Takes what the worker has made, and asks it for what is to be made. Returns whether there is
  /// anything new to show. To be called once a turn.
  bool update();

  /// Asks for what is to be made, as `update` does. To be called once widgets have changed the
  /// session, too: the worker then need not wait until the window is drawn.
  void request();

  /// Whether `update` may have something to do soon without any input.
  bool is_waiting() const;

  /// The newest frame; null before the first one.
  const std::shared_ptr<const SessionFrame>& frame() const { return frame_; }
  /// Whether the frame is the document's own, drawn with care.
  bool at_rest() const;
  const SessionWorker& worker() const { return worker_; }
  /// Gives up what the worker is at: the step that asked for it is taken back.
  void cancel_work() { worker_.cancel(); }

  /// Why there is no first frame; empty while there may be one.
  const std::string& first_failure() const { return first_failure_; }

  using FrameTaker = std::function<void(const std::shared_ptr<const SessionFrame>&)>;

  /// Calls `taker` with the final frame of the document, as soon as there is one.
  void when_at_rest(FrameTaker taker);

 private:
  using Clock = std::chrono::steady_clock;

  bool take_frame();
  bool take_failure();
  void keep_phases();
  void send(PictureQuality quality);
  void log_frame(const SessionFrame& frame);
  void log_messages();

  Session session_;
  SessionDocument saved_;
  WindowLog& log_;
  std::ofstream commands_;
  PictureSize size_;
  std::shared_ptr<const SessionFrame> frame_;
  std::uint64_t last_number_ = 0;     // of the worker's frames
  std::uint64_t shown_revision_ = 0;  // that the frame shows
  std::uint64_t asked_revision_ = 0;  // that was asked for last, in this size and quality
  PictureSize asked_size_{0, 0};
  PictureQuality asked_quality_ = PictureQuality::final;
  Clock::time_point last_change_;
  Clock::time_point last_moving_;  // by `apply_moving`
  std::vector<FrameTaker> at_rest_takers_;
  UnreadTaker unread_taker_;
  std::string first_failure_;
  SessionMessage last_message_{};
  SessionWorker worker_;  // last: its thread ends before what it was given goes
};

}  // namespace brindle::tool
