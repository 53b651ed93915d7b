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

std::size_t checked_index(const SessionDocument& document, std::size_t index) {
  const std::size_t count = document.strokes.size();
  if (index < count) return index;
  throw Error("there is no stroke " + std::to_string(index) +
              (count == 0 ? "; none is drawn" : "; the last one is " + std::to_string(count - 1)));
}

std::size_t checked_key(int key) {
  if (key >= 1 && key <= kStoredViews) return static_cast<std::size_t>(key - 1);
  throw Error("views are stored under the keys 1 to " + std::to_string(kStoredViews) + ", not " +
              std::to_string(key));
}

/// Applies a command to a document.
struct Changer {
  SessionDocument& document;

  void operator()(const commands::Open& c) const {
    check_can_open(c.mesh);
    document.mesh = c.mesh;
    if (!c.keep_options) {
      document.options.clear();
      document.curves.clear();
      document.samples.clear();
    }
    if (!c.keep_strokes) {
      document.strokes.clear();
      document.steering.clear();
    }
    document.phases.reset();
    document.camera.center.reset();
  }
  void operator()(const commands::SetOption& c) const {
    options_with(c.name, document)[c.name] = c.values;
  }
  void operator()(const commands::ClearOption& c) const {
    options_with(c.name, document).erase(c.name);
  }
  void operator()(const commands::SetOptions& c) const {
    for (const std::string& name : c.clear) options_with(name, document).erase(name);
    for (const auto& [name, values] : c.set) options_with(name, document)[name] = values;
  }
  void operator()(const commands::Show& c) const { document.shown = c.what; }
  void operator()(const commands::AddStroke& c) const { document.strokes.push_back(c.stroke); }
  void operator()(const commands::ChangeStroke& c) const {
    document.strokes[checked_index(document, c.index)] = c.stroke;
  }
  void operator()(const commands::EraseStroke& c) const {
    const std::size_t index = checked_index(document, c.index);
    document.strokes.erase(document.strokes.begin() + static_cast<std::ptrdiff_t>(index));
  }
  void operator()(const commands::SetStrokes& c) const { document.strokes = c.strokes; }
  void operator()(const commands::SetSteering& c) const { document.steering = c.strokes; }
  void operator()(const commands::SetCamera& c) const { document.camera = c.camera; }
  void operator()(const commands::SetSize& c) const { document.size = c.size; }
  void operator()(const commands::StoreView& c) const {
    document.views[checked_key(c.key)] = document.camera;
  }
  void operator()(const commands::RecallView& c) const {
    const std::optional<CameraView>& view = document.views[checked_key(c.key)];
    if (!view) {
      throw Error("no view is stored under the key " + std::to_string(c.key) +
                  "; store one there first");
    }
    document.camera = *view;
  }
  void operator()(const commands::SetFrequencyByZoom& c) const {
    document.frequency_by_zoom = c.share;
  }
  void operator()(const commands::Load& c) const { document = c.document; }
  template <class Other>
  void operator()(const Other&) const {
    throw Error("this command changes no document");
  }
};

/// Name of a command after "Undo" in a menu.
struct StepWords {
  Shown shown;

  std::string of_option(const std::string& name) const {
    const OptionInfo* option = find_session_option(name, shown);
    return option == nullptr ? name : std::string(option->words);
  }
  std::string operator()(const commands::Open& c) const {
    return "opening " + std::filesystem::path(c.mesh).filename().string();
  }
  std::string operator()(const commands::SetOption& c) const { return of_option(c.name); }
  std::string operator()(const commands::ClearOption& c) const {
    return of_option(c.name) + " left out";
  }
  std::string operator()(const commands::SetOptions& c) const {
    std::string words;
    for (const auto& [name, values] : c.set) words += (words.empty() ? "" : ", ") + of_option(name);
    return words.empty() ? "options left out" : words;
  }
  std::string operator()(const commands::Show& c) const {
    return "showing " + std::string(name_of(c.what));
  }
  std::string operator()(const commands::AddStroke&) const { return "stroke"; }
  std::string operator()(const commands::ChangeStroke&) const { return "change of a stroke"; }
  std::string operator()(const commands::EraseStroke&) const { return "erasing a stroke"; }
  std::string operator()(const commands::SetStrokes& c) const {
    return c.strokes.empty() ? "erasing all strokes" : "strokes of a file";
  }
  std::string operator()(const commands::SetSteering& c) const {
    return c.strokes.empty() ? "letting singularities go" : "steering";
  }
  std::string operator()(const commands::SetSize&) const { return "size of pictures"; }
  std::string operator()(const commands::StoreView& c) const {
    return "storing view " + std::to_string(c.key);
  }
  std::string operator()(const commands::SetFrequencyByZoom&) const { return "stripes by zoom"; }
  std::string operator()(const commands::Load&) const { return "opening a session"; }
  std::string operator()(const commands::SolveAgain&) const { return "solving again"; }
  /// Commands that are no steps.
  template <class Other>
  std::string operator()(const Other&) const {
    return "";
  }
};

bool starts_anew(const SessionCommand& command) {
  return std::holds_alternative<commands::Open>(command) ||
         std::holds_alternative<commands::Load>(command);
}

/// With another camera. Phases are removed if waves depend on the camera.
SessionDocument seen_from(const CameraView& camera, SessionDocument document) {
  if (document.camera == camera) return document;
  SessionDocument seen = document;
  seen.camera = camera;
  if (seen.phases && pattern_key(document) != pattern_key(seen)) seen.phases.reset();
  return seen;
}

}  // namespace

bool turns_view(const SessionCommand& command) {
  return std::holds_alternative<commands::SetCamera>(command) ||
         std::holds_alternative<commands::RecallView>(command);
}

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

SessionDocument changed(const SessionDocument& document, const SessionCommand& command) {
  SessionDocument result = document;
  std::visit(Changer{result}, command);
  if (!starts_anew(command) && pattern_key(document) != pattern_key(result)) result.phases.reset();
  check_document(result);
  return result;
}

Session::Session(SessionDocument document) : document_(std::move(document)) {
  check_document(document_);
}

bool Session::apply(const SessionCommand& command) {
  if (std::holds_alternative<commands::BeginDrag>(command)) return begin_drag(), true;
  if (std::holds_alternative<commands::EndDrag>(command)) return end_drag(), true;
  if (std::holds_alternative<commands::Undo>(command)) return undo();
  if (std::holds_alternative<commands::Redo>(command)) return redo();
  if (std::holds_alternative<commands::PreviousView>(command)) return previous_view();
  if (std::holds_alternative<commands::NextView>(command)) return next_view();
  if (std::holds_alternative<commands::SolveAgain>(command)) return solve_again(), true;
  if (const auto* keep = std::get_if<commands::KeepPhases>(&command)) {
    return keep_phases(revision_, keep->phases);
  }
  try {
    SessionDocument after = changed(document_, command);
    if (turns_view(command)) return turn(std::move(after)), true;
    change(std::move(after), std::visit(StepWords{document_.shown}, command), starts_anew(command));
    if (starts_anew(command)) follows_ = false;
    return true;
  } catch (const std::exception& error) {
    add_message(MessageKind::error, error.what());
    return false;
  }
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
  change(std::move(anew), StepWords{document_.shown}(commands::SolveAgain{}));
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
