#include "window/viewer.h"

#include <algorithm>
#include <cctype>
#include <cfloat>
#include <chrono>
#include <cmath>
#include <ctime>
#include <utility>

#include <imgui.h>

#include "brindle/base/text.h"
#include "brindle/error.h"
#include "window/base/theme.h"
#include "window/base/value_slider.h"

namespace brindle::tool {
namespace {

constexpr int kFramesAfterInput = 3;  // Dear ImGui needs some frames to settle
constexpr double kShortest = 1 / 60.0;
constexpr double kShortestBusy = 1 / 12.0;  // software renderers need the processor
constexpr double kPollWorker = 0.004;
constexpr double kIdle = 1;
constexpr double kMessageSeconds = 12;
constexpr double kLongStep = 0.7;  // seconds after which progress is shown

double seconds_now() {
  using Seconds = std::chrono::duration<double>;
  return Seconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Processor time of this thread.
double thread_seconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

constexpr ImGuiWindowFlags kPanel = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoCollapse |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

}  // namespace

Viewer::Viewer(SessionDocument document, std::filesystem::path session_file,
               const ViewerOptions& options)
    : options_(options),
      settings_(read_settings(options.settings)),
      log_(options.log.empty() ? WindowLog() : WindowLog(options.log)),
      window_("Brindle", options.width, options.height,
              {options.dark.value_or(settings_.dark), options.scale}),
      live_(std::move(document), log_, options.commands),
      jobs_(live_),
      browser_(settings_.folder),
      export_(live_, jobs_, browser_, log_),
      option_panel_(live_, browser_, log_),
      metric_panel_(live_, log_),
      shapes_(live_, log_, [this](const std::string& shape) { open_mesh(shape); }),
      tool_(live_, log_),
      places_(live_, log_),
      picture_(live_, tool_, places_, log_),
      gallery_(live_, jobs_, option_panel_, log_,
               [this](const SessionDocument& after, const std::string& by,
                      std::function<void()> go) { unless_lost(after, by, std::move(go)); }),
      session_file_(std::move(session_file)) {
  settings_.dark = window_.dark();
  live_.when_unread([this](const std::string& mesh) { return forget_unread(mesh); });
  log_.write("start", {{"window", window_.renderer()}, {"scale", window_.scale()}});
}

Viewer::~Viewer() = default;

void Viewer::run() {
  if (!options_.output.empty()) {
    live_.when_at_rest([this](const auto&) { window_picture_ = options_.output; });
  }
  try {
    run_until_closed();
  } catch (const Error& error) {
    throw Error(error.what() + rescued());
  }
  if (recording_) stop_recording();
  remember_settings();
  log_.write(
      "end",
      {{"busy", live_.worker().busy()}, {"drawn", drawn_}, {"thread_seconds", thread_seconds()}});
}

void Viewer::run_until_closed() {
  while (!is_to_close()) {
    if (turn()) draw();
    if (!live_.first_failure().empty()) throw Error(live_.first_failure());
  }
}

// Saves unsaved work when a window must close without asking; returns a text about where.
std::string Viewer::rescued() const {
  if (options_.settings.empty() || !live_.has_unsaved_work()) return "";
  const std::filesystem::path folder = options_.settings.parent_path();
  std::error_code ignored;
  std::filesystem::path path = folder / "rescued.json";
  for (int number = 2; std::filesystem::exists(path, ignored); ++number) {
    path = folder / ("rescued-" + std::to_string(number) + ".json");
  }
  try {
    std::filesystem::create_directories(folder, ignored);
    write_session(path, live_.document_as_shown());
    return "; what was not saved is in " + shown(path.native());
  } catch (const std::exception& error) {
    return std::string("; what was not saved is lost: ") + error.what();
  }
}

// Asks about unsaved work, and waits for files being written.
bool Viewer::is_to_close() {
  if (!window_.closing()) return false;
  const bool loses = !may_quit_ && options_.output.empty() && live_.has_unsaved_work();
  const std::vector<BackgroundJobs::Writing> jobs = jobs_.being_written();
  if (!loses && jobs.empty()) return true;
  window_.keep_open();
  if (!loses) {
    quits_later_ = true;
    live_.add_message(MessageKind::note, "the window closes once " +
                                             shown(jobs.front().path.filename().native()) +
                                             " is written; cancel that to close it at once");
    return false;
  }
  question_ = LossQuestion{"The session has changes that are not saved.", "quit", [this] {
                             may_quit_ = true;
                             window_.ask_to_close();
                           }};
  frames_to_draw_ = kFramesAfterInput;
  return false;
}

// Waits for events. Returns whether the window must be drawn.
bool Viewer::turn() {
  const bool input = window_.wait(wait_seconds());
  bool changed = live_.update();
  changed |= jobs_.update();
  if (gallery_.update()) frames_to_draw_ = std::max(frames_to_draw_, 1);
  const bool writing = !jobs_.being_written().empty();
  if (writing || live_.worker().step().seconds >= kLongStep)
    frames_to_draw_ = std::max(frames_to_draw_, 1);
  if (!writing && std::exchange(quits_later_, false)) window_.ask_to_close();
  take_dropped();
  if (recording_ && live_.frame()) recording_->show(live_.frame());
  if (recording_ && recording_->failed()) stop_recording();
  if (input) frames_to_draw_ = kFramesAfterInput;
  if (changed) last_drawn_ = 0;  // new content is shown at once
  if (changed || !window_picture_.empty()) frames_to_draw_ = std::max(frames_to_draw_, 1);
  const double pause = seconds_now() - last_drawn_;
  if (pause < shortest_pause() || (frames_to_draw_ == 0 && pause < kIdle)) return false;
  frames_to_draw_ = std::max(frames_to_draw_ - 1, 0);
  return true;
}

double Viewer::shortest_pause() const {
  return live_.worker().busy() || jobs_.busy() ? kShortestBusy : kShortest;
}

double Viewer::wait_seconds() const {
  if (frames_to_draw_ > 0) {
    return std::clamp(last_drawn_ + shortest_pause() - seconds_now(), 0.0, kPollWorker);
  }
  return live_.is_waiting() || jobs_.busy() || recording_ ? kPollWorker : kIdle;
}

void Viewer::draw() {
  const double start = seconds_now();
  window_.begin_frame();
  follow_keys();
  draw_menus();
  draw_panels();
  shapes_.draw();
  draw_keys();
  export_.is_open() ? export_.draw() : browser_.draw(log_);
  draw_question();
  live_.end_drag_at_rest(ImGui::IsAnyMouseDown() || option_panel_.is_held());
  live_.request();
  Image copy;
  const bool takes_picture = !window_picture_.empty() && --frames_to_picture_ < 0;
  window_.end_frame(takes_picture ? &copy : nullptr);
  if (copy.width > 0) write_window_picture(std::move(copy));
  log_.end_frame();
  if (frames_to_mark_ > 0 && --frames_to_mark_ == 0) log_.write("mark", {{"number", ++marks_}});
  last_drawn_ = seconds_now();
  ++drawn_;
  window_milliseconds_ += 0.1 * (1000 * (last_drawn_ - start) - window_milliseconds_);
}

void Viewer::write_window_picture(Image picture) {
  const std::filesystem::path path = std::exchange(window_picture_, {});
  if (path == options_.output) {
    write_png(path, picture);
    return window_.ask_to_close();
  }
  jobs_.start([path, picture = std::move(picture)] {
    write_png(path, picture);
    return "wrote " + shown(path.native());
  });
}

void Viewer::draw_panels() {
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  const float status = ImGui::GetFrameHeight() + 2;
  const float height = viewport->WorkSize.y - status;
  float left = 0;
  float right = 0;
  if (settings_.show_options) {
    draw_options(height);
    left = options_width_;
  }
  if (settings_.show_metrics) {
    right = std::round(13.5f * ImGui::GetFontSize());
    draw_metrics(height);
  }
  draw_picture(left, right, height);
  draw_status();
}

void Viewer::draw_options(float height) {
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  const float text = ImGui::GetFontSize();
  ImGui::SetNextWindowPos(viewport->WorkPos);
  ImGui::SetNextWindowSize({std::round(22 * text), height}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSizeConstraints({14 * text, height},
                                      {std::max(14 * text, viewport->WorkSize.x / 2), height});
  ImGui::Begin("options", nullptr, kPanel);
  options_width_ = ImGui::GetWindowWidth();
  gallery_.draw_panel();
  draw_place_box();
  draw_camera();
  option_panel_.draw();
  ImGui::End();
}

void Viewer::draw_metrics(float height) {
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  const float width = std::round(13.5f * ImGui::GetFontSize());
  ImGui::SetNextWindowPos(
      {viewport->WorkPos.x + viewport->WorkSize.x - width, viewport->WorkPos.y});
  ImGui::SetNextWindowSize({width, height});
  ImGui::Begin("metrics", nullptr, kPanel | ImGuiWindowFlags_NoResize);
  metric_panel_.draw(window_milliseconds_, window_.dark());
  if (metric_panel_.asks_to_solve_again()) solve_again();
  ImGui::End();
}

void Viewer::draw_picture(float left, float right, float height) {
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  ImGui::SetNextWindowPos({viewport->WorkPos.x + left, viewport->WorkPos.y});
  ImGui::SetNextWindowSize({viewport->WorkSize.x - left - right, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::Begin("picture", nullptr,
               kPanel | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoScrollbar |
                   ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  const float gap = ImGui::GetStyle().FramePadding.y;
  ImGui::SetCursorPos({2 * gap, gap});
  tool_.draw_bar();
  ImGui::SetCursorPos({0, tool_.bar_height() + 2 * gap});
  picture_.draw(window_.pixels_per_unit(), window_.take_trail());
  draw_message();
  draw_jobs();
  ImGui::End();
}

void Viewer::draw_place_box() {
  if (places_.empty()) return places_.set_follows(false);
  bool follows = places_.follows();
  if (ImGui::Checkbox("place at mouse", &follows)) places_.set_follows(follows);
  log_.note_widget("place at mouse");
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip(
        "the place that values are distances from follows the mouse over the surface (F);\n"
        "without, drag its handle");
  }
}

void Viewer::draw_question() {
  constexpr const char* kQuestion = "Not saved";
  if (!question_) return;
  if (std::exchange(question_->newly_asked, false)) ImGui::OpenPopup(kQuestion);
  ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
  if (!ImGui::BeginPopupModal(kQuestion, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) {
    return question_.reset();
  }
  const std::string what = question_->what;
  ImGui::PushTextWrapPos(28 * ImGui::GetFontSize());
  ImGui::TextUnformatted(question_->text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0, 0.3f * ImGui::GetFontSize()});
  std::function<void()> go;  // runs after the answer
  const auto button = [&](const std::string& label, const char* name) {
    const bool pressed = ImGui::Button(label.c_str());
    log_.note_widget(what + " " + name);
    ImGui::SameLine();
    if (pressed) {
      ImGui::CloseCurrentPopup();
      go = std::move(question_->go);
      question_.reset();
    }
    return pressed;
  };
  if (button("Save and " + what, "save")) {
    session_file_.empty() ? ask_save_session(std::move(go))
                          : save_session(session_file_, std::move(go));
  } else if (button(static_cast<char>(std::toupper(what[0])) + what.substr(1) + " without saving",
                    "discard")) {
    go();
  } else if (button("Cancel", "cancel")) {
  } else if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) {
    ImGui::CloseCurrentPopup();
    question_.reset();
  }
  ImGui::EndPopup();
}

void Viewer::draw_camera() {
  const bool open = ImGui::CollapsingHeader("Camera", ImGuiTreeNodeFlags_DefaultOpen);
  log_.note_widget("group Camera");
  if (!open) return;
  const CameraView& view = live_.document().camera;
  const float column = ImGui::GetStyle().WindowPadding.x + 0.44f * ImGui::GetContentRegionAvail().x;
  const auto labelled = [column](const char* label) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(column);
    ImGui::SetNextItemWidth(-FLT_MIN);
  };
  float zoom = view.zoom;
  labelled("zoom");
  const ValueChange zooms =
      slider_beside_number("##zoom", zoom, 0.1f, 100, "%.3g", ImGuiSliderFlags_Logarithmic);
  live_.apply_value(zooms, commands::set_camera(zoomed_to(view, zoom)));
  log_.note_widget("zoom");
  float share = live_.document().frequency_by_zoom;
  labelled("stripes by zoom");
  const ValueChange shares =
      slider_beside_number("##share", share, 0, 1, share == 0 ? "no" : "%.2f");
  live_.apply_value(shares, commands::set_frequency_by_zoom(share));
  log_.note_widget("frequency by zoom");
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip(
        "frequencies are multiplied by zoom to this power: 0 as they are, 1 as many\n"
        "stripes on the screen however near one is");
  }
  bool free = view.rotation.has_value();
  if (ImGui::Checkbox("free", &free)) set_camera(free ? freed(view) : upright(view));
  log_.note_widget("camera free");
  ImGui::SameLine();
  bool orthographic = view.projection == Projection::orthographic;
  if (ImGui::Checkbox("orthographic", &orthographic)) {
    CameraView changed = view;
    changed.projection = orthographic ? Projection::orthographic : Projection::perspective;
    set_camera(changed);
  }
  log_.note_widget("camera orthographic");
  ImGui::SameLine();
  if (ImGui::Button("fit")) set_camera({.projection = view.projection});
  log_.note_widget("camera fit");
}

// The present activity, and a hint to help.
void Viewer::draw_status() {
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  const float height = ImGui::GetFrameHeight() + 2;
  ImGui::SetNextWindowPos(
      {viewport->WorkPos.x, viewport->WorkPos.y + viewport->WorkSize.y - height});
  ImGui::SetNextWindowSize({viewport->WorkSize.x, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {10, 3});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin("status", nullptr,
               kPanel | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar(2);
  ImGui::TextUnformatted(live_.document().mesh.c_str());
  if (recording_) {
    ImGui::SameLine(0, 20);
    ImGui::TextColored({0.9f, 0.25f, 0.2f, 1}, "recording %.1f s (R stops)", recording_->seconds());
  }
  const std::string step = live_.worker().step().name;
  if (!step.empty()) {
    ImGui::SameLine(0, 20);
    ImGui::TextDisabled("%s ...", step.c_str());
  }
  const std::string steered = tool_.status();
  if (!steered.empty()) {
    ImGui::SameLine(0, 20);
    ImGui::TextUnformatted(steered.c_str());
    log_.note_widget("status of steering");
  }
  const char* help = "? keys";
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(help).x);
  ImGui::TextDisabled("%s", help);
  ImGui::End();
}

// The last message, for a while, at the lower edge of the picture.
void Viewer::draw_message() {
  const auto& messages = live_.session().messages();
  if (!messages.empty() && (!message_ || !(*message_ == messages.back()))) {
    message_ = messages.back();
    message_since_ = seconds_now();
  }
  if (!message_ || message_->text.empty() || seconds_now() - message_since_ > kMessageSeconds) {
    return;
  }
  const ImVec2 corner = ImGui::GetWindowPos();
  const float text = ImGui::GetFontSize();
  ImGui::SetNextWindowPos({corner.x + text / 2, corner.y + ImGui::GetWindowHeight() - text / 2},
                          ImGuiCond_Always, {0, 1});
  const float width = ImGui::GetWindowWidth() - text;
  ImGui::SetNextWindowSizeConstraints({0, 0}, {width, ImGui::GetWindowHeight() / 2});
  ImGui::Begin("message", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PushTextWrapPos(width - 3 * text);
  const bool bad = message_->kind == MessageKind::error;
  if (bad) ImGui::PushStyleColor(ImGuiCol_Text, warning_color(window_.dark()));
  ImGui::TextUnformatted(message_->text.c_str());
  if (bad) ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
  if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) message_since_ = 0;
  ImGui::End();
}

// The present step, once it takes long. Before the first picture, it cannot be reverted.
void Viewer::draw_working() {
  const WorkerStep step = live_.worker().step();
  if (step.seconds < kLongStep || step.name.empty()) return;
  const float text = ImGui::GetFontSize();
  ImGui::TextUnformatted(step.name.c_str());
  ImGui::ProgressBar(static_cast<float>(step.fraction), {12 * text, 0});
  if (!live_.frame()) return;
  ImGui::SameLine();
  if (ImGui::Button("Cancel##working")) live_.cancel_work();
  log_.note_widget("cancel working");
}

// Files and data in progress, at the upper right corner of the picture.
void Viewer::draw_jobs() {
  const std::vector<BackgroundJobs::Writing> jobs = jobs_.being_written();
  const bool works = live_.worker().step().seconds >= kLongStep;
  if (jobs.empty() && !works) return;
  const ImVec2 corner = ImGui::GetWindowPos();
  const float text = ImGui::GetFontSize();
  ImGui::SetNextWindowPos(
      {corner.x + ImGui::GetWindowWidth() - text / 2, corner.y + tool_.bar_height() + 1.5f * text},
      ImGuiCond_Always, {1, 0});
  ImGui::Begin("writing", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing);
  draw_working();
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const BackgroundJobs::Writing& job = jobs[i];
    ImGui::PushID(static_cast<int>(i));
    ImGui::TextUnformatted(shown(job.path.filename().native()).c_str());
    ImGui::ProgressBar(static_cast<float>(job.fraction), {12 * text, 0});
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", job.step.c_str());
    ImGui::SameLine();
    if (ImGui::Button("Cancel")) job.cancel();
    log_.note_widget("cancel writing " + job.path.filename().string());
    ImGui::PopID();
  }
  ImGui::End();
}

void Viewer::remember_opened(const std::string& name) {
  remember(settings_, name);
  remember_settings();
}

void Viewer::remember_settings() {
  settings_.dark = window_.dark();
  settings_.folder = browser_.folder().string();
  try {
    write_settings(options_.settings, settings_);
  } catch (const Error& error) {
    live_.add_message(MessageKind::warning, error.what());
  }
}

}  // namespace brindle::tool
