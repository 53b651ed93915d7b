#include "window/dialogs/export_dialog.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

#include <imgui.h>
#include <imgui_stdlib.h>

#include "brindle/base/text.h"
#include "pictures/drawing_file.h"
#include "window/base/theme.h"

namespace brindle::tool {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTitle = "Export picture";

// Labels in a column to the left of their widgets.
void label(const char* text) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(text);
  ImGui::SameLine(6 * ImGui::GetFontSize());
}

bool is_checked(WindowLog& log, const char* words, bool& value, bool enabled, const char* help) {
  ImGui::BeginDisabled(!enabled);
  const bool changed = ImGui::Checkbox(words, &value);
  ImGui::EndDisabled();
  log.note_widget(std::string("export ") + words);
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) ImGui::SetTooltip("%s", help);
  return changed;
}

std::vector<std::string> picture_extensions() {
  std::vector<std::string> extensions = {".png", ".svg"};
  if (drawing_refusal("a.pdf").empty()) extensions.emplace_back(".pdf");
  return extensions;
}

}  // namespace

void ExportDialog::open(const std::string& name) {
  is_open_ = newly_opened_ = takes_keys_ = true;
  name_ = name;
  confirmed_.clear();
  if (size_ == PrintSize()) {
    const PictureSize shown = live_.document_as_shown().size;
    size_ = {static_cast<double>(shown.width), static_cast<double>(shown.height)};
  }
}

fs::path ExportDialog::path() const {
  fs::path path = browser_.folder() / name_;
  if (!path.has_extension()) path += ".png";
  return path;
}

double ExportDialog::dpi() const { return is_drawing_file(path()) ? kDrawingDpi : dpi_; }

PictureChanges ExportDialog::changes() const {
  return {.size = pixels_of(size_, dpi()),
          .transparent =
              transparent_ && !is_drawing_file(path()) && live_.document().shown == Shown::stripes,
          .scaled_widths = scaled_widths_ && has_pixel_widths(live_.document()),
          .dpi = size_.millimetres && !is_drawing_file(path()) ? dpi_ : 0};
}

// Recomputed only after changes, because it accesses files.
const std::string& ExportDialog::refusal() {
  const auto& frame = live_.frame();
  Asked asked{path(), changes(), live_.session().revision(), frame ? frame->nothing_left : ""};
  if (asked == asked_) return refusal_;
  asked_ = std::move(asked);
  refusal_.clear();
  try {
    if (name_.empty()) throw Error("name the file");
    planned_picture(live_.document_as_shown(), asked_.changes, asked_.path);
    refusal_ = asked_.nothing_left;
  } catch (const std::exception& error) {
    refusal_ = error.what();
    constexpr std::string_view kOutput = "--output: ";  // the file name is shown above
    if (refusal_.starts_with(kOutput)) refusal_.erase(0, kOutput.size());
  }
  return refusal_;
}

void ExportDialog::draw() {
  if (!is_open_) return;
  if (std::exchange(newly_opened_, false)) ImGui::OpenPopup(kTitle);
  const float text = ImGui::GetFontSize();
  const ImGuiViewport* viewport = ImGui::GetMainViewport();
  ImGui::SetNextWindowPos(viewport->GetCenter(), ImGuiCond_Appearing, {0.5f, 0.5f});
  const float width = std::min(36 * text, 0.9f * viewport->WorkSize.x);
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, viewport->WorkSize.y});
  if (!ImGui::BeginPopupModal(kTitle, &is_open_, ImGuiWindowFlags_AlwaysAutoResize)) {
    is_open_ = false;
    return;
  }
  const bool choosing = browser_.is_open();
  const bool entered = draw_file();
  draw_size();
  draw_looks();
  draw_result();
  const bool done = draw_buttons(entered);
  browser_.draw(log_);
  const bool escaped = !choosing && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
  if (done || escaped || !is_open_) {
    ImGui::CloseCurrentPopup();
    is_open_ = false;
  }
  ImGui::EndPopup();
}

// Returns whether Enter was pressed in the name field.
bool ExportDialog::draw_file() {
  label("file");
  const float button = 6 * ImGui::GetFontSize();
  ImGui::SetNextItemWidth(-button - ImGui::GetStyle().ItemSpacing.x);
  if (std::exchange(takes_keys_, false)) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputTextWithHint("##name", "name or path", &name_,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  log_.note_widget("export name");
  ImGui::SameLine();
  const bool choose = ImGui::Button("Choose...", {-FLT_MIN, 0});
  log_.note_widget("export choose");
  if (choose) {
    browser_.ask({.title = "Choose a file for the picture",
                  .extensions = picture_extensions(),
                  .save = true,
                  .name = name_,
                  .verb = "Choose",
                  .done = [this](const fs::path& chosen) {
                    name_ = chosen.filename().string();
                    confirmed_ = chosen;
                  }});
  }
  label("");
  std::string known;
  for (const std::string& extension : picture_extensions()) known += extension + "  ";
  ImGui::TextDisabled("%sin %s", known.c_str(), shown(browser_.folder().native()).c_str());
  return entered;
}

void ExportDialog::draw_side(const char* name, double side,
                             PrintSize (*of_side)(double, const PrintSize&, PictureSize)) {
  ImGui::SetNextItemWidth(6 * ImGui::GetFontSize());
  const std::string id = std::string("##") + name;
  const bool edited =
      ImGui::InputDouble(id.c_str(), &side, 0, 0, size_.millimetres ? "%.4g" : "%.0f");
  log_.note_widget(std::string("export ") + name);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", name);
  if (!edited) return;
  if (keeps_proportions_) {
    size_ = of_side(side, size_, live_.document_as_shown().size);
  } else {
    (of_side == of_width ? size_.width : size_.height) =
        size_.millimetres ? side : std::round(side);
  }
}

void ExportDialog::draw_size() {
  label("size");
  draw_side("width", size_.width, of_width);
  ImGui::SameLine();
  ImGui::TextUnformatted("x");
  ImGui::SameLine();
  draw_side("height", size_.height, of_height);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(8 * ImGui::GetFontSize());
  const bool millimetres = size_.millimetres;
  if (ImGui::BeginCombo("##unit", millimetres ? "millimetres" : "pixels")) {
    if (ImGui::Selectable("pixels", !millimetres)) size_ = in_pixels(size_, dpi());
    log_.note_widget("export pixels");
    if (ImGui::Selectable("millimetres", millimetres)) size_ = in_millimetres(size_, dpi());
    log_.note_widget("export millimetres");
    ImGui::EndCombo();
  }
  log_.note_widget("export unit");
  label("");
  if (is_checked(log_, "proportions of the window", keeps_proportions_, true,
                 "width and height follow each other") &&
      keeps_proportions_) {
    size_ = of_width(size_.width, size_, live_.document_as_shown().size);
  }
  label("resolution");
  ImGui::SetNextItemWidth(6 * ImGui::GetFontSize());
  const bool drawing = is_drawing_file(path());
  ImGui::BeginDisabled(drawing);
  double resolution = dpi();
  if (ImGui::InputDouble("##dpi", &resolution, 0, 0, "%.6g")) dpi_ = resolution;
  ImGui::EndDisabled();
  log_.note_widget("export dpi");
  ImGui::SameLine();
  ImGui::TextDisabled(drawing ? "pixels an inch, as all drawings have" : "pixels an inch");
}

void ExportDialog::draw_looks() {
  const bool stripes = live_.document().shown == Shown::stripes;
  label("look");
  const bool drawing = is_drawing_file(path());
  bool transparent = transparent_ || drawing;
  if (is_checked(log_, "transparent background", transparent, stripes && !drawing,
                 drawing   ? "drawings have no background"
                 : stripes ? "--transparent: what lies behind shows through"
                           : "pictures of curves and samples have a background")) {
    transparent_ = transparent;
  }
  label("");
  const bool widths = has_pixel_widths(live_.document());
  bool scaled = scaled_widths_ || !widths;
  if (is_checked(log_, "widths grow with the size", scaled, widths,
                 widths ? "widths in pixels grow with the picture, so that it looks like the "
                          "window;\nelse they keep their pixels, and lines come out thinner"
                        : "no width is measured in pixels: all grows with the size")) {
    scaled_widths_ = scaled;
  }
}

void ExportDialog::draw_result() {
  const PictureSize pixels = pixels_of(size_, dpi());
  const PrintSize paper = in_millimetres(
      {static_cast<double>(pixels.width), static_cast<double>(pixels.height)}, dpi());
  label("result");
  std::string result = formatted("%d x %d pixels", pixels.width, pixels.height);
  if (paper.millimetres) {
    result +=
        formatted(", %.1f x %.1f mm at %.6g pixels an inch", paper.width, paper.height, dpi());
  }
  ImGui::TextUnformatted(result.c_str());
  log_.note_widget("export result " + result);
  const std::string& why = refusal();
  std::error_code ignored;
  const bool replaces = why.empty() && confirmed_ == path() && fs::exists(path(), ignored);
  // Reserve two lines, so that buttons stay in place.
  const float top = ImGui::GetCursorPosY();
  label("");
  ImGui::PushTextWrapPos(0);
  if (replaces) {
    ImGui::Text("%s is there already.", shown(path().filename().native()).c_str());
    log_.note_widget("export replace");
  } else if (!why.empty()) {
    ImGui::TextColored(warning_color(ImGui::GetStyleColorVec4(ImGuiCol_WindowBg).x < 0.5f), "%s",
                       why.c_str());
    log_.note_widget("export problem");
  } else {
    ImGui::NewLine();
  }
  ImGui::PopTextWrapPos();
  ImGui::SetCursorPosY(
      std::max(ImGui::GetCursorPosY(), top + 2 * ImGui::GetTextLineHeightWithSpacing()));
}

// Returns whether the dialog should close.
bool ExportDialog::draw_buttons(bool entered) {
  ImGui::Dummy({0, 0.2f * ImGui::GetFontSize()});
  label("");
  const bool refused = !refusal().empty();
  std::error_code ignored;
  const bool exists = fs::exists(path(), ignored);
  ImGui::BeginDisabled(refused);
  const bool pressed = ImGui::Button(exists && confirmed_ == path() ? "Replace it" : "Export");
  ImGui::EndDisabled();
  log_.note_widget("export done");
  ImGui::SameLine();
  const bool cancelled = ImGui::Button("Cancel");
  log_.note_widget("export cancel");
  if (!(pressed || entered) || refused) return cancelled;
  if (exists && confirmed_ != path()) {
    confirmed_ = path();
    takes_keys_ = true;
    return false;
  }
  start();
  return true;
}

// Writes the final picture, once it exists.
void ExportDialog::start() {
  live_.end_drag();
  live_.when_at_rest([this, path = path(), changes = changes()](const auto&) {
    try {
      const SessionDocument planned = planned_picture(live_.document_as_shown(), changes, path);
      jobs_.write(path, [planned, path, dpi = changes.dpi](JobListener& listener) {
        export_picture(planned, path, dpi, listener);
      });
    } catch (const std::exception& error) {
      live_.add_message(MessageKind::error, error.what());
    }
  });
}

}  // namespace brindle::tool
