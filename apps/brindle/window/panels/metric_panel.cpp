#include "window/panels/metric_panel.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include <imgui.h>

#include "brindle/base/text.h"
#include "window/base/theme.h"

namespace brindle::tool {
namespace {

constexpr std::size_t kMostValues = 200;
constexpr double kPause = 0.5;  // seconds without frames after which motion ends

void metric_row(const char* name, const std::string& value) {
  ImGui::TextDisabled("%s", name);
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(value.c_str()).x);
  ImGui::TextUnformatted(value.c_str());
}

std::string count_text(std::size_t count) {
  std::string text = std::to_string(count);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, " ");
  return text;
}

/// The rest of a name, without "(u)", for rows below "length of u".
std::string name_beside(const std::string& name) {
  return name.starts_with("  ") ? name.substr(0, name.rfind(" (")) : name;
}

/// Counts with all digits.
std::string text_of_metric(double value) {
  if (std::isnan(value)) return "none";
  return formatted(value == std::round(value) ? "%.0f" : "%.5g", value);
}

}  // namespace

void MetricPanel::note_frame() {
  const auto& frame = live_.frame();
  if (!frame || frame->number == noted_) return;
  noted_ = frame->number;
  const double now = ImGui::GetTime();
  if (!arrivals_.empty() && now - arrivals_.back() > kPause) arrivals_.clear();
  arrivals_.push_back(now);
  while (now - arrivals_.front() > 1) arrivals_.pop_front();
  const Report& report = frame->state->report();
  const std::array values = {static_cast<double>(report.quality.branches), report.energy,
                             report.quality.angle_error_mean_deg, frame->milliseconds,
                             frames_per_second()};
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::vector<float>& history = histories_[i].values;
    history.push_back(static_cast<float>(values[i]));
    if (history.size() > kMostValues) history.erase(history.begin());
  }
}

double MetricPanel::frames_per_second() const {
  if (arrivals_.size() < 2) return 0;
  return static_cast<double>(arrivals_.size() - 1) / (arrivals_.back() - arrivals_.front());
}

void MetricPanel::draw(double window_milliseconds, bool dark) {
  dark_ = dark;
  asks_to_solve_again_ = false;
  note_frame();
  const auto& frame = live_.frame();
  if (!frame) {
    ImGui::TextDisabled("no picture yet");
    return;
  }
  draw_counts(*frame);
  draw_notes(notes_of(*frame));
  ImGui::Separator();
  draw_times(*frame, window_milliseconds);
  ImGui::Separator();
  draw_histories();
}

void MetricPanel::draw_counts(const SessionFrame& frame) {
  const Report& report = frame.state->report();
  const PatternQuality& quality = report.quality;
  metric_row("vertices", count_text(report.vertices));
  metric_row("triangles", count_text(report.triangles));
  metric_row("branches", count_text(quality.branches));
  log_.note_widget("metric branches");
  metric_row("singularities", count_text(quality.field_singularities));
  metric_row("energy", formatted("%.5g", report.energy));
  metric_row("angle error", formatted("%.2f\u00b0", quality.angle_error_mean_deg));
  metric_row("spacing error", formatted("%.2f%%", 100 * quality.spacing_error_mean));
  if (report.waves.edges_per_period_median > 0) {
    metric_row("edges a period", formatted("%.3g", report.waves.edges_per_period_median));
    log_.note_widget("metric edges a period");
  }
  for (const auto& [name, value] : frame.state->metrics.shown) {
    metric_row(name_beside(name).c_str(), text_of_metric(value));
    log_.note_widget("metric " + name);
  }
  if (frame.state->phases) draw_followed(frame.state->metrics);
}

void MetricPanel::draw_followed(const LiveMetrics& metrics) {
  metric_row("phases moved", formatted("%.3f rad", metrics.phase_step));
  asks_to_solve_again_ = ImGui::Button("solve again (N)", {-FLT_MIN, 0});
  log_.note_widget("solve again");
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("stripes have followed those before; make them of the options alone");
  }
}

// Notes as the tool prints them; likely mistakes stand out.
void MetricPanel::draw_notes(const std::vector<std::string>& notes) {
  ImGui::PushTextWrapPos(0);
  std::size_t number = 0;
  for (const std::string& note : notes) {
    const bool warns = note.starts_with("warning:");
    const ImVec4 color =
        warns ? warning_color(dark_) : ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(note.c_str());
    ImGui::PopStyleColor();
    log_.note_widget("note " + std::to_string(++number));
  }
  ImGui::PopTextWrapPos();
}

void MetricPanel::draw_times(const SessionFrame& frame, double window_milliseconds) {
  const auto row = [](const char* name, double milliseconds) {
    metric_row(name, formatted("%.1f ms", milliseconds));
  };
  for (const auto& [name, milliseconds] : frame.state->metrics.milliseconds) {
    row(name.c_str(), milliseconds);
  }
  row("drawing", frame.draw_milliseconds);
  row("all together", frame.milliseconds);
  row("this window", window_milliseconds);
  const double rate = frames_per_second();
  metric_row("frames a second", rate > 0 ? formatted("%.1f", rate) : "-");
}

void MetricPanel::draw_histories() {
  const ImVec2 size(ImGui::GetContentRegionAvail().x, 2 * ImGui::GetFontSize());
  for (const History& history : histories_) {
    if (history.values.size() < 2) continue;
    ImGui::TextDisabled("%s", history.name);
    const auto [least, most] = std::ranges::minmax(history.values);
    const float margin = std::max(0.1f * (most - least), 1e-6f + 0.001f * std::abs(most));
    ImGui::PushID(history.name);
    ImGui::PlotLines("##plot", history.values.data(), static_cast<int>(history.values.size()), 0,
                     nullptr, least - margin, most + margin, size);
    ImGui::PopID();
  }
}

}  // namespace brindle::tool
