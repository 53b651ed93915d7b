/// A session with its worker thread, and the timing of requests.
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

/// The kind of change by a widget.
enum class ValueChange { none, dragged, typed };

/// What there is to say of the frame, in the words of the panels.
std::vector<std::string> notes_of(const SessionFrame& frame);

/// All that happens to the session goes through here. Nothing waits for the worker: changes are
/// drawn at interactive quality at once, and with care when nothing has changed for a while.
class LiveSession {
 public:
  /// `commands`: a file that records all commands for `brindle render --replay`; empty: none.
  LiveSession(SessionDocument document, WindowLog& log, const std::filesystem::path& commands = {});

  const Session& session() const { return session_; }
  const SessionDocument& document() const { return session_.document(); }

  /// The document to save, with the size of the picture in the window. That size is no undo step.
  SessionDocument document_as_shown() const;

  /// As `Session::apply`.
  bool apply(const SessionCommand& command);
  /// The same within a drag, started if necessary: everything until `end_drag` is one undo step.
  bool apply_dragged(const SessionCommand& command);
  void end_drag();

  /// Applies a widget's change: dragged values within a drag, typed ones as a step.
  bool apply_value(ValueChange change, const SessionCommand& command);

  /// The same for motion without a pressed button, such as the wheel: a drag that
  /// `end_drag_at_rest` ends after a pause.
  bool apply_moving(const SessionCommand& command);
  /// Extends the drag while an action is incomplete.
  void hold_drag() { last_moving_ = Clock::now(); }
  /// Call it once per frame. `pressed`: a button is down, which prevents the end.
  void end_drag_at_rest(bool pressed);

  /// Whether options, strokes or stored views differ from those at the start or last opened or
  /// saved.
  bool has_unsaved_work() const { return !same_work(session_.document(), saved_); }
  void note_saved() { saved_ = session_.document(); }
  /// The unsaved work that would be lost with another document (`lost_work`).
  std::vector<std::string_view> lost_by(const SessionDocument& after) const {
    return lost_work(session_.document(), saved_, after);
  }

  /// Called with meshes that cannot be read; returns an addition to the message.
  using UnreadTaker = std::function<std::string(const std::string& mesh)>;
  void when_unread(UnreadTaker taker) { unread_taker_ = std::move(taker); }

  bool undo() { return apply(session_command("undo")); }
  bool redo() { return apply(session_command("redo")); }
  bool previous_view() { return apply(session_command("previous_view")); }
  bool next_view() { return apply(session_command("next_view")); }
  void add_message(MessageKind kind, const std::string& text);

  void set_picture_size(PictureSize size);

  /// Takes results of the worker and sends new requests. Returns whether there is anything new to
  /// show. Call it once per frame.
  bool update();

  /// Sends new requests, as `update` does. Call it again after widgets, so that the worker need not
  /// wait for the window to be drawn.
  void request();

  /// Whether `update` may soon have work without input.
  bool is_waiting() const;

  /// The newest frame; null before the first one.
  const std::shared_ptr<const SessionFrame>& frame() const { return frame_; }
  /// Whether the frame is the document's own, at final quality.
  bool at_rest() const;
  const SessionWorker& worker() const { return worker_; }
  /// Cancels the worker's job and reverts the step that requested it.
  void cancel_work() { worker_.cancel(); }

  /// Why there is no first frame; empty while there may be one.
  const std::string& first_failure() const { return first_failure_; }

  using FrameTaker = std::function<void(const std::shared_ptr<const SessionFrame>&)>;

  /// Calls `taker` with the document's final frame, once it exists.
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
  std::uint64_t shown_revision_ = 0;  // shown by the frame
  std::uint64_t asked_revision_ = 0;  // last requested, at this size and quality
  PictureSize asked_size_{0, 0};
  PictureQuality asked_quality_ = PictureQuality::final;
  Clock::time_point last_change_;
  Clock::time_point last_moving_;  // by `apply_moving`
  std::vector<FrameTaker> at_rest_takers_;
  UnreadTaker unread_taker_;
  std::string first_failure_;
  SessionMessage last_message_{};
  SessionWorker worker_;  // declared last: its thread ends before its inputs are destroyed
};

}  // namespace brindle::tool
