#include "session/session.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/shapes.h"
#include "session/session_options.h"
#include "session/stage_keys.h"

namespace brindle::tool {
namespace {

constexpr std::size_t kMostMessages = 100;
constexpr std::size_t kMostSteps = 1000;                   // and of views
constexpr std::size_t kMostPhases = std::size_t{1} << 26;  // of all steps together: 256 MB

/// With another camera. Phases are removed if waves depend on the camera.
SessionDocument seen_from(const CameraView& camera, SessionDocument document) {
  if (document.camera == camera) return document;
  SessionDocument seen = document;
  seen.camera = camera;
  if (seen.phases && pattern_key(document) != pattern_key(seen)) seen.phases.reset();
  return seen;
}

}  // namespace

void check_can_open(const std::string& mesh) {
  constexpr std::string_view kShape = "shape:";
  if (mesh.starts_with(kShape)) {
    const std::vector<std::string> known = shape_names();
    const std::string name = mesh.substr(kShape.size(), mesh.find(',') - kShape.size());
    if (std::ranges::find(known, name) != known.end()) return;
    const std::string meant = nearest(name, known);
    throw Error(mesh + ": there is no such shape" +
                (meant.empty() ? "" : "; did you mean shape:" + meant + "?"));
  }
  std::error_code ignored;
  if (std::filesystem::is_regular_file(mesh, ignored)) return;
  throw Error(shown(mesh) + ": there is no such file; check its name and folder");
}

Session::Session(SessionDocument document) : document_(std::move(document)) {
  check_document(document_);
}

bool Session::apply(const SessionCommand& command) {
  try {
    return effect_of(command)(*this);
  } catch (const std::exception& error) {
    add_message(MessageKind::error, error.what());
    return false;
  }
}

void Session::edit(const DocumentEdit& edit, EditKind kind) {
  SessionDocument after = document_;
  std::string name = edit(after);
  const bool anew = kind == EditKind::anew;
  if (!anew && pattern_key(document_) != pattern_key(after)) after.phases.reset();
  check_document(after);
  if (kind == EditKind::view) return turn(std::move(after));
  change(std::move(after), std::move(name), anew);
  if (anew) follows_ = false;
}

void Session::change(SessionDocument document, std::string name, bool anew) {
  if (document == document_) return;
  if (!drag_has_step_) {
    past_.push_back({document_, std::move(name), anew});
    drag_has_step_ = dragging_;
  }
  past_.back().anew |= anew;
  future_.clear();
  if (anew) views_ = {};
  last_change_ = Change::edit;
  go(std::move(document), true);
  forget_old_steps();
}

void Session::turn(SessionDocument document) {
  if (document.camera == document_.camera) return;
  if (!drag_has_view_) {
    views_.past.push_back(document_.camera);
    if (views_.past.size() > kMostSteps) views_.past.pop_front();
    drag_has_view_ = dragging_;
  }
  views_.future.clear();
  last_change_ = Change::view;
  go(std::move(document), true);
}

void Session::go(SessionDocument document, bool follows) {
  document_ = std::move(document);
  follows_ = follows;
  ++revision_;
}

void Session::begin_drag() {
  end_drag();
  dragging_ = true;
}

void Session::end_drag() {
  // A drag without net change is no undo step.
  if (drag_has_step_ && document_of(past_.back()) == document_) past_.pop_back();
  if (drag_has_view_ && !views_.past.empty() && views_.past.back() == document_.camera) {
    views_.past.pop_back();
  }
  dragging_ = drag_has_step_ = drag_has_view_ = false;
}

SessionDocument Session::document_of(Step step) const {
  return step.anew ? std::move(step.document)
                   : seen_from(document_.camera, std::move(step.document));
}

bool Session::move(std::deque<Step>& from, std::deque<Step>& to) {
  end_drag();
  if (from.empty()) return false;
  Step step = std::move(from.back());
  from.pop_back();
  to.push_back({document_, step.name, step.anew});
  if (step.anew) views_ = {};
  last_change_ = Change::none;
  go(document_of(std::move(step)), false);
  return true;
}

bool Session::move_view(std::deque<CameraView>& from, std::deque<CameraView>& to) {
  end_drag();
  if (from.empty()) return false;
  const CameraView camera = from.back();
  from.pop_back();
  to.push_back(document_.camera);
  last_change_ = Change::none;
  go(seen_from(camera, document_), true);
  return true;
}

bool Session::undo() { return move(past_, future_); }
bool Session::redo() { return move(future_, past_); }

bool Session::previous_view() { return move_view(views_.past, views_.future); }
bool Session::next_view() { return move_view(views_.future, views_.past); }

std::string Session::undo_name() const { return past_.empty() ? "" : past_.back().name; }
std::string Session::redo_name() const { return future_.empty() ? "" : future_.back().name; }

// Without kept phases there is no step, but the shown pattern may have continued others.
void Session::solve_again() {
  SessionDocument anew = document_;
  anew.phases.reset();
  change(std::move(anew), "solving again");
  go(document_, false);
}

bool Session::keep_phases(std::uint64_t revision,
                          std::shared_ptr<const std::vector<float>> phases) {
  if (revision != revision_) return false;
  if (!phases) return std::exchange(document_.phases, nullptr) != nullptr;
  if (document_.phases) return false;
  SessionDocument with_phases = document_;
  with_phases.phases = std::move(phases);
  try {
    check_document(with_phases);
  } catch (const std::exception& error) {
    add_message(MessageKind::error, error.what());
    return false;
  }
  document_ = std::move(with_phases);
  return true;
}

bool Session::take_back(std::uint64_t revision, const std::string& why) {
  messages_.push_back({MessageKind::error, why, revision});
  if (messages_.size() > kMostMessages) messages_.pop_front();
  if (revision != revision_) return false;
  if (last_change_ == Change::view && !views_.past.empty()) {
    const CameraView before = views_.past.back();
    views_.past.pop_back();
    drag_has_view_ = false;
    go(seen_from(before, document_), false);
  } else if (last_change_ == Change::edit && !past_.empty()) {
    Step step = std::move(past_.back());
    past_.pop_back();
    drag_has_step_ = false;
    if (step.anew) views_ = {};
    go(document_of(std::move(step)), false);
  } else {
    return false;
  }
  // If nothing was shown of it, the edit before may be at fault.
  last_change_ = future_.empty() ? Change::edit : Change::none;
  return true;
}

void Session::add_message(MessageKind kind, std::string text) {
  messages_.push_back({kind, std::move(text), revision_});
  if (messages_.size() > kMostMessages) messages_.pop_front();
}

/// Phases take most memory.
void Session::forget_old_steps() {
  std::size_t phases = 0;
  for (const Step& step : past_) phases += step.document.phases ? step.document.phases->size() : 0;
  while (past_.size() > kMostSteps || (phases > kMostPhases && past_.size() > 1)) {
    const auto& oldest = past_.front().document.phases;
    phases -= oldest ? oldest->size() : 0;
    past_.pop_front();
  }
}

}  // namespace brindle::tool
