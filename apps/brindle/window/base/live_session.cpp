#include "window/base/live_session.h"

#include <utility>

#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/recipe/json_text.h"
#include "session/session_options.h"

namespace brindle::tool {
namespace {

constexpr auto kRest = std::chrono::milliseconds(300);
constexpr auto kMovingRest = std::chrono::milliseconds(400);

const char* kind_name(MessageKind kind) {
  return kind == MessageKind::error ? "error" : kind == MessageKind::warning ? "warning" : "note";
}

}  // namespace

LiveSession::LiveSession(SessionDocument document, WindowLog& log,
                         const std::filesystem::path& commands)
    : session_(std::move(document)),
      saved_(session_.document()),
      log_(log),
      size_(session_.document().size) {
  if (commands.empty()) return;
  commands_.open(commands);
  if (!commands_) {
    throw Error(shown(commands.native()) +
                ": cannot be written; choose a folder that is there and yours");
  }
}

SessionDocument LiveSession::document_as_shown() const {
  SessionDocument document = session_.document();
  document.size = size_;
  return document;
}

bool LiveSession::apply(const SessionCommand& command) {
  const bool done = session_.apply(command);
  if (log_.is_open()) {
    SessionCommand json = command;
    json.erase("phases");  // one number per vertex
    log_.write("command",
               {{"done", done}, {"revision", session_.revision()}, {"what", std::move(json)}});
  }
  if (done && commands_.is_open()) commands_ << json_text(command) << std::endl;
  log_messages();
  return done;
}

bool LiveSession::apply_dragged(const SessionCommand& command) {
  if (!session_.dragging()) apply(session_command("begin_drag"));
  return apply(command);
}

void LiveSession::end_drag() {
  if (!session_.dragging()) return;
  apply(session_command("end_drag"));
  if (at_rest()) keep_phases();
}

bool LiveSession::apply_value(ValueChange change, const SessionCommand& command) {
  if (change == ValueChange::none) return false;
  if (change == ValueChange::dragged) return apply_dragged(command);
  end_drag();
  return apply(command);
}

bool LiveSession::apply_moving(const SessionCommand& command) {
  last_moving_ = Clock::now();
  return apply_dragged(command);
}

void LiveSession::end_drag_at_rest(bool pressed) {
  if (!pressed && Clock::now() - last_moving_ >= kMovingRest) end_drag();
}

void LiveSession::add_message(MessageKind kind, const std::string& text) {
  session_.add_message(kind, text);
  log_messages();
}

void LiveSession::log_messages() {
  const auto& messages = session_.messages();
  if (messages.empty() || messages.back() == last_message_) return;
  last_message_ = messages.back();
  log_.write("message", {{"kind", kind_name(last_message_.kind)}, {"text", last_message_.text}});
}

void LiveSession::set_picture_size(PictureSize size) { size_ = size; }

bool LiveSession::at_rest() const {
  return frame_ && shown_revision_ == session_.revision() &&
         frame_->quality == PictureQuality::final && frame_->image.width == size_.width &&
         frame_->image.height == size_.height;
}

bool LiveSession::is_waiting() const {
  return worker_.busy() || asked_revision_ != session_.revision() || asked_size_ != size_ ||
         asked_quality_ != PictureQuality::final;
}

bool LiveSession::update() {
  const bool failed = take_failure();
  const bool taken = take_frame();
  request();
  return failed || taken;
}

bool LiveSession::take_frame() {
  const std::shared_ptr<const SessionFrame> newest = worker_.latest();
  if (!newest || newest->number == last_number_) return false;
  last_number_ = newest->number;
  log_frame(*newest);
  frame_ = newest;
  shown_revision_ = newest->revision;
  if (at_rest()) {
    keep_phases();
    for (const FrameTaker& taker : std::exchange(at_rest_takers_, {})) taker(frame_);
  }
  return true;
}

// Undo and saving restore the pattern that is shown.
void LiveSession::keep_phases() {
  if (session_.dragging()) return;
  const auto& phases = frame_->state->phases;
  if (!session_.keep_phases(frame_->revision, phases)) return;
  if (commands_.is_open()) commands_ << json_text(commands::keep_phases(phases)) << std::endl;
  log_.write("kept_phases", {{"frame", frame_->number}, {"revision", session_.revision()}});
  asked_revision_ = shown_revision_ = session_.revision();
}

bool LiveSession::take_failure() {
  std::optional<SessionFailure> failure = worker_.take_failure();
  if (!failure) return false;
  if (!failure->unread_mesh.empty() && unread_taker_) {
    failure->text += unread_taker_(failure->unread_mesh);
  }
  if (!frame_) first_failure_ = failure->text;
  at_rest_takers_.clear();
  const bool taken_back = session_.take_back(failure->revision, failure->text);
  log_.write("failure", {{"taken_back", taken_back}, {"revision", session_.revision()}});
  log_messages();
  return true;
}

void LiveSession::when_at_rest(FrameTaker taker) {
  if (at_rest()) return taker(frame_);
  at_rest_takers_.push_back(std::move(taker));
}

void LiveSession::request() {
  const auto now = Clock::now();
  if (asked_revision_ != session_.revision() || asked_size_ != size_) {
    last_change_ = now;
    // The first picture is drawn at final quality.
    return send(frame_ ? PictureQuality::interactive : PictureQuality::final);
  }
  const bool shown = shown_revision_ == session_.revision();
  if (asked_quality_ != PictureQuality::final && shown && now - last_change_ >= kRest) {
    send(PictureQuality::final);
  }
}

void LiveSession::send(PictureQuality quality) {
  asked_revision_ = session_.revision();
  asked_size_ = size_;
  asked_quality_ = quality;
  worker_.request({.document = document_as_shown(),
                   .revision = asked_revision_,
                   .quality = quality,
                   .follow = session_.follows() ? Follow::last : Follow::afresh});
}

std::vector<std::string> notes_of(const SessionFrame& frame) {
  std::vector<std::string> notes;
  for (const std::string& note : frame.state->notes) {
    notes.push_back(in_panel_words(note, frame.state->document.shown));
  }
  return notes;
}

void LiveSession::log_frame(const SessionFrame& frame) {
  if (!log_.is_open()) return;
  const LiveMetrics& metrics = frame.state->metrics;
  const Report& report = frame.state->report();
  auto stages = nlohmann::ordered_json::object();
  for (const auto& [name, milliseconds] : metrics.milliseconds) stages[name] = milliseconds;
  auto shown = nlohmann::ordered_json::object();
  for (const auto& [name, value] : metrics.shown) shown[name] = value;
  log_.write("frame", {{"number", frame.number},
                       {"revision", frame.revision},
                       {"final", frame.quality == PictureQuality::final},
                       {"width", frame.image.width},
                       {"height", frame.image.height},
                       {"vertices", report.vertices},
                       {"branches", report.quality.branches},
                       {"singularities", report.quality.field_singularities},
                       {"energy", report.energy},
                       {"spacing_error", report.quality.spacing_error_mean},
                       {"edges_per_period", report.waves.edges_per_period_median},
                       {"notes", notes_of(frame)},
                       {"nothing_left", frame.nothing_left},
                       {"shown", std::move(shown)},
                       {"followed", frame.state->phases != nullptr},
                       {"milliseconds", frame.milliseconds},
                       {"draw_milliseconds", frame.draw_milliseconds},
                       {"stages", std::move(stages)}});
}

}  // namespace brindle::tool
