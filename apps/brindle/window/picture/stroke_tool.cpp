#include "window/picture/stroke_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <imgui.h>

#include "brindle/direction_field.h"
#include "session/session_options.h"
#include "window/base/value_slider.h"

namespace brindle::tool {
namespace {

constexpr double kCombStep = 5;     // pixels
constexpr double kNearStroke = 12;  // pixels
constexpr int kSplineParts = 8;
constexpr std::size_t kMostMoved = 24;

struct ToolName {
  const char* name;
  const char* help;
};
constexpr std::array<ToolName, kToolCount> kTools = {
    {{"Look",
      "drag to turn, Shift or the middle button to move, wheel to zoom, double click for "
      "the centre (V)"},
     {"Light",
      "drag to move the light of pictures; the right button turns the surface. Right click on "
      "'light from' in the panel to have it where it was (I)"},
     {"Comb",
      "draw on the surface; stripes run across what you draw or along it, as the box says (C)"},
     {"Spline", "click points; Enter or a double click ends it (S)"},
     {"Move", "drag strokes; the sliders change the one that is chosen (M)"},
     {"Erase", "click strokes, or drag over them (E)"},
     {"Steer",
      "drag singularities; dropped onto one of the other colour, both are gone. The line "
      "below says what became of it (G)"}}};

constexpr ImU32 kStrokeColor = IM_COL32(255, 176, 32, 255);
constexpr ImU32 kChosenColor = IM_COL32(255, 235, 120, 255);
constexpr ImU32 kRim = IM_COL32(20, 20, 24, 200);
// Positive: lines turn in the sense of the walk around it; negative: against it.
constexpr ImU32 kPositiveColor = IM_COL32(245, 120, 40, 255);
constexpr ImU32 kNegativeColor = IM_COL32(60, 140, 250, 255);
constexpr double kNearSingularity = 14;  // units of Dear ImGui
constexpr double kSteeringReach = 0.25;  // of the tool's radius
constexpr double kSteeringStrength = 4;  // relative to the tool's

void draw_line(ImDrawList& list, const std::vector<ImVec2>& points, ImU32 color, float width) {
  const int count = static_cast<int>(points.size());
  list.AddPolyline(points.data(), count, kRim, 0, width + 2.5f);
  list.AddPolyline(points.data(), count, color, 0, width);
}

/// Places the bar's next widget of this width beside the last one, or in a new row.
void go_on(float width, float gap = ImGui::GetStyle().ItemSpacing.x) {
  const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  if (ImGui::GetItemRectMax().x + gap + width < end) ImGui::SameLine(0, gap);
}

constexpr const char* kAlong = "stripes along strokes";
constexpr const char* kSingularities = "singularities";
constexpr const char* kLetGo = "let go";
constexpr float kSliderWidth = 7, kBarGap = 1.2f;  // letters

/// The pixel of a singularity on the visible side; occlusion is not tested.
std::optional<Eigen::Vector2d> seen_at(const FieldSingularity& singularity,
                                       const PicturePlace& place) {
  const Camera& camera = place.frame->camera;
  if (singularity.normal.dot(viewpoint_of(camera) - singularity.position) <= 0) return std::nullopt;
  if (camera.cuts_off(singularity.position)) return std::nullopt;
  return place.pixel_of(singularity.position);
}

float width_of_box(const char* label) {
  return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x +
         ImGui::CalcTextSize(label).x;
}

}  // namespace

void StrokeTool::choose(Tool tool) {
  finish_spline();
  // Even with the button down.
  drawn_.reset();
  steering_.reset();
  status_.clear();
  tool_ = tool;
  if (tool != Tool::move) chosen_.reset();
}

float StrokeTool::bar_height() const {
  const ImGuiStyle& style = ImGui::GetStyle();
  float width = 0;
  for (const ToolName& tool : kTools) {
    width += ImGui::CalcTextSize(tool.name).x + 2 * style.FramePadding.x + style.ItemSpacing.x;
  }
  width += 2 * kBarGap * ImGui::GetFontSize();
  width += 2 * (kSliderWidth * ImGui::GetFontSize() + style.ItemSpacing.x);
  width += width_of_box(kAlong) + style.ItemSpacing.x + width_of_box(kSingularities);
  const float room = ImGui::GetWindowContentRegionMax().x;
  const float lines = 1 + std::floor(width / std::max(room, 1.0f));
  return lines * ImGui::GetFrameHeight() + (lines - 1) * style.ItemSpacing.y;
}

void StrokeTool::draw_bar() {
  ImGui::BeginGroup();
  for (int i = 0; i < kToolCount; ++i) {
    if (i > 0) {
      go_on(ImGui::CalcTextSize(kTools[i].name).x + 2 * ImGui::GetStyle().FramePadding.x);
    }
    const bool chosen = static_cast<int>(tool_) == i;
    if (chosen)
      ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyle().Colors[ImGuiCol_ButtonActive]);
    if (ImGui::Button(kTools[i].name)) choose(static_cast<Tool>(i));
    if (chosen) ImGui::PopStyleColor();
    log_.note_widget(std::string("tool ") + kTools[i].name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", kTools[i].help);
  }
  if (draws()) draw_sliders();
  if (tool_ == Tool::comb || tool_ == Tool::spline) draw_along();
  if (tool_ == Tool::steer) draw_let_go();
  go_on(width_of_box(kSingularities), kBarGap * ImGui::GetFontSize());
  ImGui::Checkbox(kSingularities, &show_singularities_);
  log_.note_widget("show singularities");
  ImGui::EndGroup();
}

// Whether stripes run along or across strokes.
void StrokeTool::draw_along() {
  bool along = shown_options(live_.document()).contains("along");
  go_on(width_of_box(kAlong));
  if (ImGui::Checkbox(kAlong, &along)) {
    if (along) {
      live_.apply(commands::set_option("along"));
    } else {
      live_.apply(commands::clear_option("along"));
    }
  }
  log_.note_widget("stripes along strokes");
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("stripes run along what you draw; without, across it (--along)");
  }
}

// Releases the hidden strokes that fix singularities.
void StrokeTool::draw_let_go() {
  if (live_.document().steering.empty()) return;
  go_on(ImGui::CalcTextSize(kLetGo).x + 2 * ImGui::GetStyle().FramePadding.x);
  if (ImGui::Button(kLetGo)) {
    dropped_.reset();
    live_.apply(commands::set_steering({}));
    say("singularities are where the field has them of itself");
  }
  log_.note_widget("let go");
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("nothing holds singularities where they were dragged");
  }
}

void StrokeTool::draw_sliders() {
  const auto& strokes = live_.document().strokes;
  if (chosen_ && *chosen_ >= strokes.size()) chosen_.reset();
  float radius = chosen_ && diagonal_ > 0
                     ? static_cast<float>(100 * strokes[*chosen_].radius / diagonal_)
                     : radius_;
  float strength = chosen_ ? static_cast<float>(strokes[*chosen_].strength) : strength_;
  const float width = kSliderWidth * ImGui::GetFontSize();
  go_on(width, kBarGap * ImGui::GetFontSize());
  ImGui::SetNextItemWidth(width);
  ValueChange change =
      value_slider("##radius", radius, 0.5f, 40, "radius %.1f%%", ImGuiSliderFlags_Logarithmic);
  log_.note_widget("stroke radius");
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("how far from the line the field follows, of the surface's diagonal");
  }
  go_on(width);
  ImGui::SetNextItemWidth(width);
  const ValueChange second = value_slider("##strength", strength, 0.05f, 20, "strength %.2f",
                                          ImGuiSliderFlags_Logarithmic);
  if (second != ValueChange::none) change = second;
  log_.note_widget("stroke strength");
  if (change != ValueChange::none) change_strokes(change, radius, strength);
}

// Of the selected stroke, or of future ones.
void StrokeTool::change_strokes(ValueChange change, float radius, float strength) {
  if (!(radius > 0 && strength > 0)) {
    return live_.add_message(MessageKind::error,
                             "a stroke's radius and strength must be above zero");
  }
  if (chosen_) {
    FieldStroke stroke = live_.document().strokes[*chosen_];
    stroke.radius = radius / 100.0 * diagonal_;
    stroke.strength = strength;
    if (!live_.apply_value(change, commands::change_stroke(*chosen_, stroke))) return;
  }
  radius_ = radius;
  strength_ = strength;
}

void StrokeTool::note_frame(const SessionFrame& frame) {
  if (noted_ == frame.state->job) return;
  noted_ = frame.state->job;
  const Mesh& mesh = frame.surface().mesh;
  diagonal_ = bounding_box(mesh).diagonal();
  const StripePattern& stripes = noted_->result.stripes();
  singularities_ = field_singularities(frame.surface(), stripes.corners, stripes.waves.directions);
}

std::vector<Eigen::Vector2d> StrokeTool::line_of(const PicturePlace& place,
                                                 const FieldStroke& stroke) const {
  std::vector<Eigen::Vector2d> line;
  for (const Eigen::Vector3d& point : stroke.points) {
    if (const auto pixel = place.pixel_of_place(point)) line.push_back(*pixel);
  }
  return line;
}

std::optional<std::size_t> StrokeTool::stroke_at(const PicturePlace& place,
                                                 const Eigen::Vector2d& pixel) {
  std::optional<std::size_t> nearest;
  double least = kNearStroke * place.pixels_per_unit;
  const auto& strokes = live_.document().strokes;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const double distance = distance_to_line(pixel, line_of(place, strokes[i]));
    if (distance > least) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

void StrokeTool::press(const PicturePlace& place, const Eigen::Vector2d& pixel) {
  note_frame(*place.frame);
  refused_ = false;
  last_pixel_ = pixel;
  switch (tool_) {
    case Tool::look:
    case Tool::light:
      return;
    case Tool::comb:
      end_comb();
      comb_to(place, pixel);
      return;
    case Tool::spline:
      return add_control(place, pixel);
    case Tool::move:
      chosen_ = stroke_at(place, pixel);
      if (chosen_) {
        moving_ = Moving{thinned(live_.document().strokes[*chosen_].points, kMostMoved), pixel};
      }
      return;
    case Tool::erase:
      return erase_at(place, pixel);
    case Tool::steer:
      return begin_steering(place, pixel);
  }
}

void StrokeTool::drag(const PicturePlace& place, const std::vector<Eigen::Vector2d>& pixels) {
  if (refused_) return;
  for (const Eigen::Vector2d& pixel : pixels) {
    if (tool_ == Tool::comb) extend_comb(place, pixel);
    if (tool_ == Tool::erase) erase_at(place, pixel);
  }
  if (tool_ == Tool::comb) set_comb();
  if (tool_ == Tool::move) move_chosen(place, pixels.back());
  if (tool_ == Tool::steer) steer(place, pixels.back());
}

void StrokeTool::release() {
  if (tool_ == Tool::comb) end_comb();
  moving_.reset();
  drop_singularity();
  refused_ = false;
}

// Adds the stroke that is being drawn, if new, and sets its points.
void StrokeTool::set_points(Points points) {
  const FieldStroke stroke{std::move(points), radius_ / 100.0 * diagonal_, strength_};
  if (drawn_ && *drawn_ < live_.document().strokes.size()) {
    refused_ = !live_.apply_dragged(commands::change_stroke(*drawn_, stroke));
    return;
  }
  refused_ = !live_.apply_dragged(commands::add_stroke(stroke));
  if (!refused_) drawn_ = live_.document().strokes.size() - 1;
}

void StrokeTool::extend_comb(const PicturePlace& place, const Eigen::Vector2d& pixel) {
  const double step = kCombStep * place.pixels_per_unit;
  if ((pixel - last_pixel_).norm() < step) return;
  for (const Eigen::Vector2d& next : pixels_between(last_pixel_, pixel, step)) comb_to(place, next);
  last_pixel_ = pixel;
}

// Where the mouse leaves the surface the stroke ends; where it comes back the next one begins.
void StrokeTool::comb_to(const PicturePlace& place, const Eigen::Vector2d& pixel) {
  const auto pick_place = [&](const Eigen::Vector2d& at) -> std::optional<Eigen::Vector3d> {
    const auto hit = place.pick(at);
    return hit ? std::optional(hit->place) : std::nullopt;
  };
  const auto there = pick_place(pixel);
  if (!there) return end_comb();
  if (!comb_.empty()) {
    if (comb_.back() == *there) return;
    if (leaves_surface({combed_, comb_.back()}, {pixel, *there}, pick_place)) end_comb();
  }
  comb_.push_back(*there);
  combed_ = pixel;
}

void StrokeTool::set_comb() {
  if (comb_.size() < 2 || refused_) return;
  const auto& strokes = live_.document().strokes;
  if (drawn_ && *drawn_ < strokes.size() && strokes[*drawn_].points == comb_) return;
  set_points(comb_);
}

void StrokeTool::end_comb() {
  set_comb();
  comb_.clear();
  drawn_.reset();
}

void StrokeTool::add_control(const PicturePlace& place, const Eigen::Vector2d& pixel) {
  // Undone in the meantime.
  if (drawn_ && *drawn_ + 1 != live_.document().strokes.size()) finish_spline();
  const auto hit = place.pick(pixel);
  if (!hit || (!controls_.empty() && controls_.back() == hit->place)) return;
  controls_.push_back(hit->place);
  if (controls_.size() < 2) return;
  set_points(on_surface(place, catmull_rom(controls_, kSplineParts), {0, 0}));
  if (refused_) controls_.pop_back();
}

bool StrokeTool::finish_spline() {
  if (controls_.empty()) return false;
  controls_.clear();
  drawn_.reset();
  return true;
}

// Points moved by pixels and projected onto the visible surface; others keep their depth.
Points StrokeTool::on_surface(const PicturePlace& place, const Points& points,
                              const Eigen::Vector2d& shift) const {
  Points result;
  for (const Eigen::Vector3d& point : points) {
    const auto pixel = place.pixel_of_place(point);
    const auto hit = pixel ? place.pick(*pixel + shift) : std::nullopt;
    if (hit) {
      result.push_back(hit->place);
    } else if (shift.isZero()) {
      result.push_back(point);
    }
  }
  return result;
}

void StrokeTool::move_chosen(const PicturePlace& place, const Eigen::Vector2d& pixel) {
  if (!moving_ || !chosen_ || *chosen_ >= live_.document().strokes.size()) return;
  if (pixel == last_pixel_) return;
  last_pixel_ = pixel;
  FieldStroke stroke = live_.document().strokes[*chosen_];
  stroke.points = on_surface(place, moving_->points, pixel - moving_->from);
  if (stroke.points.size() < 2) return;
  refused_ = !live_.apply_dragged(commands::change_stroke(*chosen_, stroke));
}

void StrokeTool::erase_at(const PicturePlace& place, const Eigen::Vector2d& pixel) {
  if (const auto index = stroke_at(place, pixel)) {
    live_.apply_dragged(commands::erase_stroke(*index));
  }
}

// The nearest one on the visible side.
const FieldSingularity* StrokeTool::singularity_at(const PicturePlace& place,
                                                   const Eigen::Vector2d& pixel) const {
  const FieldSingularity* nearest = nullptr;
  double least = kNearSingularity * place.pixels_per_unit;
  for (const FieldSingularity& singularity : singularities_) {
    const auto at = seen_at(singularity, place);
    if (!at || (*at - pixel).norm() > least) continue;
    least = (*at - pixel).norm();
    nearest = &singularity;
  }
  return nearest;
}

// Strokes are along the field; waves are turned from it.
DirectionField StrokeTool::field_directions(const LiveState& state) const {
  const WaveOptions& waves = state.parsed->arguments().waves;
  const float turn_deg = waves.rotate_deg + (waves.along ? 90.0f : 0.0f);
  return rotated(state.job->result.stripes().waves.directions, state.job->surface->normals,
                 -turn_deg * std::numbers::pi_v<float> / 180);
}

double StrokeTool::steering_reach() const {
  return kSteeringReach * static_cast<double>(radius_) / 100 * diagonal_;
}

void StrokeTool::say(std::string status) {
  if (!status.empty()) log_.write("steered", {{"text", status}});
  status_ = std::move(status);
  said_of_ = live_.document().steering;
}

void StrokeTool::begin_steering(const PicturePlace& place, const Eigen::Vector2d& pixel) {
  const FieldSingularity* singularity = singularity_at(place, pixel);
  const WaveOptions& waves = place.frame->state->parsed->arguments().waves;
  if (singularity == nullptr) return;
  dropped_.reset();
  if (!is_smooth(waves) || waves.cross) {
    return say(in_panel_words(
        "the singularity stays: only --field smooth and --field curvature follow strokes, and no "
        "cross field does",
        live_.document().shown));
  }
  say("");
  steering_ = Steering{.singularity = *singularity,
                       .state = place.frame->state,
                       .directions = field_directions(*place.frame->state),
                       .held = live_.document().steering};
}

void StrokeTool::steer(const PicturePlace& place, const Eigen::Vector2d& pixel) {
  if (!steering_ || pixel == last_pixel_) return;
  last_pixel_ = pixel;
  const Surface& surface = *steering_->state->job->surface;
  const auto hit = place.pick(pixel);
  if (!hit || hit->triangle >= surface.mesh.triangle_count()) {
    steering_->why_not = "you dropped the singularity beside the surface; it is ";
    return;
  }
  steering_->why_not.clear();
  // Those at the start of the drag: a singularity that it meets is gone meanwhile.
  std::size_t to = hit->triangle;
  steering_->meets = false;
  const StripePattern& before = steering_->state->job->result.stripes();
  for (const FieldSingularity& other :
       field_singularities(surface, before.corners, before.waves.directions)) {
    const auto at = place.pixel_of(other.position);
    const bool meets = at && (*at - pixel).norm() < kNearSingularity * place.pixels_per_unit;
    if (!meets || other.sign != -steering_->singularity.sign) continue;
    to = other.triangle;
    steering_->meets = true;
  }
  lead(steering_->singularity, to);
}

void StrokeTool::lead(const FieldSingularity& singularity, std::size_t to) {
  const std::vector<FieldStroke> strokes =
      strokes_that_move(singularity, to, *steering_->state->job->surface, steering_->directions,
                        steering_reach(), kSteeringStrength * static_cast<double>(strength_));
  if (strokes.empty()) {
    steering_->why_not =
        "no way over the surface leads there: another part, or too far round; the singularity is ";
    return;
  }
  refused_ = !live_.apply_dragged(commands::set_steering(with_steering(steering_->held, strokes)));
  if (!refused_) steering_->to = to;
}

void StrokeTool::drop_singularity() {
  if (!steering_) return;
  const Steering steered = *std::exchange(steering_, std::nullopt);
  if (!steered.why_not.empty()) {
    return say(steered.why_not + (steered.to ? "at the last place on its way" : "where it was"));
  }
  if (!steered.to || refused_) return;
  const StripePattern& before = steered.state->job->result.stripes();
  const std::size_t count =
      field_singularities(*steered.state->job->surface, before.corners, before.waves.directions)
          .size();
  dropped_ = Dropped{{*steered.to, steered.singularity.sign, steered.meets, count},
                     steering_reach(),
                     live_.session().revision()};
}

// The field is solved globally. Once solved, a nearby singularity is moved on from there, and the
// outcome is reported.
void StrokeTool::note_arrival(const SessionFrame& frame) {
  if (!dropped_) return;
  if (live_.session().revision() != dropped_->revision) return dropped_.reset();
  live_.hold_drag();
  if (frame.revision != dropped_->revision) return;
  const Arrival arrival =
      arrival_of(dropped_->what, frame.surface(), singularities_, dropped_->reach);
  if (!arrival.there && !dropped_->is_led_on && arrival.nearest != nullptr) {
    const Dropped dropped = *dropped_;
    steering_ = Steering{.singularity = *arrival.nearest,
                         .state = frame.state,
                         .directions = field_directions(*frame.state),
                         .held = live_.document().steering};
    refused_ = false;
    lead(steering_->singularity, dropped.what.to);
    const bool led = steering_->to.has_value();
    steering_.reset();
    if (led) {
      dropped_ = Dropped{dropped.what, dropped.reach, live_.session().revision(), true};
      return;
    }
  }
  say(arrival_words(dropped_->what, arrival, diagonal_));
  dropped_.reset();
}

bool StrokeTool::erase_chosen() {
  if (!chosen_ || *chosen_ >= live_.document().strokes.size()) return false;
  return live_.apply(commands::erase_stroke(*std::exchange(chosen_, std::nullopt)));
}

void StrokeTool::draw_over(ImDrawList& list, const PicturePlace& place, bool hovered) {
  note_frame(*place.frame);
  note_arrival(*place.frame);
  if (show_singularities_ || tool_ == Tool::steer) draw_singularities(list, place);
  if (!draws()) return;
  draw_strokes(list, place);
  if (hovered) draw_cursor(list, place);
}

void StrokeTool::draw_strokes(ImDrawList& list, const PicturePlace& place) {
  const auto& strokes = live_.document().strokes;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    std::vector<ImVec2> line;
    for (const Eigen::Vector2d& pixel : line_of(place, strokes[i])) {
      line.push_back(place.unit(pixel));
    }
    if (line.size() < 2) continue;
    draw_line(list, line, chosen_ == i ? kChosenColor : kStrokeColor, chosen_ == i ? 3 : 2);
    list.AddCircleFilled(line.front(), 3, kStrokeColor);
    list.AddCircleFilled(line.back(), 3, kStrokeColor);
  }
  for (const Eigen::Vector3d& control : controls_) {
    const auto pixel = place.pixel_of_place(control);
    if (!pixel) continue;
    list.AddCircleFilled(place.unit(*pixel), 5, kRim);
    list.AddCircleFilled(place.unit(*pixel), 3.5f, kChosenColor);
  }
}

void StrokeTool::draw_singularities(ImDrawList& list, const PicturePlace& place) {
  for (const FieldSingularity& singularity : singularities_) {
    const auto pixel = seen_at(singularity, place);
    if (!pixel) continue;
    list.AddCircle(place.unit(*pixel), 6, kRim, 0, 4);
    list.AddCircle(place.unit(*pixel), 6, singularity.sign > 0 ? kPositiveColor : kNegativeColor, 0,
                   2.5f);
    log_.note_place("singularity " + std::to_string(&singularity - singularities_.data()),
                    PicturePlace::around(place.unit(*pixel), 6));
  }
}

// The stroke's radius at the mouse.
void StrokeTool::draw_cursor(ImDrawList& list, const PicturePlace& place) {
  if (tool_ != Tool::comb && tool_ != Tool::spline) return;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto hit = place.pick(place.pixel(mouse));
  if (!hit) return;
  const Vec3 right = place.frame->camera.view_from_world.block<1, 3>(0, 0).transpose();
  const auto reach = static_cast<float>(radius_ / 100 * diagonal_);
  const auto side = place.pixel_of(hit->position + reach * right);
  if (!side) return;
  const ImVec2 edge = place.unit(*side);
  list.AddCircle(mouse, std::abs(edge.x - mouse.x), kRim, 0, 3);
  list.AddCircle(mouse, std::abs(edge.x - mouse.x), kStrokeColor, 0, 1.2f);
}

}  // namespace brindle::tool
