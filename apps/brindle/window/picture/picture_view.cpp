#include "window/picture/picture_view.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include <imgui.h>

#include "brindle/base/text.h"
#include "brindle/render/parsed_words.h"
#include "session/session_options.h"

namespace brindle::tool {
namespace {

constexpr const char* kLightFrom = "light-from";
constexpr float kBall = 26, kBallRoom = 14;  // units of Dear ImGui

/// The light direction of the document's pictures.
LightDirection light_of(const SessionDocument& document) {
  const OptionValues options = shown_options(document);
  const auto found = options.find(kLightFrom);
  const OptionInfo* info = find_session_option(kLightFrom, document.shown);
  const auto light = found != options.end() && !found->second.empty()
                         ? parse_light_direction(found->second.front())
                         : parse_light_direction(info->standard);
  return light.value_or(LightDirection());
}

}  // namespace

PictureView::~PictureView() { glDeleteTextures(1, &texture_); }

// Only for new pictures; reallocates the texture if the size changes.
void PictureView::upload() {
  if (uploaded_ == live_.frame()) return;
  uploaded_ = live_.frame();
  legend_ = view_legend(*uploaded_->state);
  const Image& image = uploaded_->image;
  if (texture_ == 0) {
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  glBindTexture(GL_TEXTURE_2D, texture_);
  if (image.width != width_ || image.height != height_) {
    width_ = image.width;
    height_ = image.height;
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width_, height_, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 nullptr);
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE,
                  image.pixels.data());
}

void PictureView::draw(float pixels_per_unit, const std::vector<Eigen::Vector2f>& trail) {
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const PictureSize size{static_cast<int>(std::lround(room.x * pixels_per_unit)),
                         static_cast<int>(std::lround(room.y * pixels_per_unit))};
  if (size.width < 16 || size.height < 16) return;
  live_.set_picture_size(size);
  ImGui::InvisibleButton("picture", room,
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                             ImGuiButtonFlags_MouseButtonRight);
  log_.note_widget("picture");
  if (!live_.frame()) return;
  upload();
  // A picture of another size is centred until the right one is ready.
  const auto left = std::floor((room.x - static_cast<float>(width_) / pixels_per_unit) / 2);
  const auto top = std::floor((room.y - static_cast<float>(height_) / pixels_per_unit) / 2);
  const PicturePlace place{.corner = {corner.x + left, corner.y + top},
                           .pixels_per_unit = pixels_per_unit,
                           .size = {width_, height_},
                           .frame = uploaded_.get()};
  const bool hovered = ImGui::IsItemHovered();
  const ImVec2 end(corner.x + room.x, corner.y + room.y);
  ImGui::GetWindowDrawList()->PushClipRect(corner, end, true);
  show(place);
  tool_.draw_over(*ImGui::GetWindowDrawList(), place, hovered);
  places_.draw_over(*ImGui::GetWindowDrawList(), place);
  if (tool_.tool() == Tool::light) draw_light({end.x, corner.y});
  note_mouse(place, hovered);
  show_values(corner, end);
  show_legend(corner);
  show_why_empty(corner, room);
  ImGui::GetWindowDrawList()->PopClipRect();
  follow_mouse(place, trail);
  if (hovered) follow_wheel();
}

// Finding the triangle is slow on large surfaces: only once the mouse rests, and once per position
// and picture.
void PictureView::note_mouse(const PicturePlace& place, bool hovered) {
  const bool final = uploaded_->quality == PictureQuality::final;
  const ImVec2& moved = ImGui::GetIO().MouseDelta;
  if (!hovered || !final || ImGui::IsAnyMouseDown() || moved.x != 0 || moved.y != 0) {
    under_mouse_.clear();
    picked_frame_.reset();
    return;
  }
  const Eigen::Vector2d pixel = place.pixel(ImGui::GetIO().MousePos);
  if (picked_frame_ == uploaded_ && pixel == picked_pixel_) return;
  picked_frame_ = uploaded_;
  picked_pixel_ = pixel;
  const auto hit = place.pick(pixel);
  under_mouse_ = hit ? values_at(*uploaded_->state, *hit) : std::vector<PickedValue>();
}

// In the lower left corner, names beside values.
void PictureView::show_values(const ImVec2& corner, const ImVec2& end) const {
  if (under_mouse_.empty()) return;
  float names = 0, texts = 0;
  for (const auto& [name, text] : under_mouse_) {
    names = std::max(names, ImGui::CalcTextSize(name.c_str()).x);
    texts = std::max(texts, ImGui::CalcTextSize(text.c_str()).x);
  }
  const float line = ImGui::GetTextLineHeight(), gap = 0.5f * line;
  const float height = line * static_cast<float>(under_mouse_.size());
  const ImVec2 lower(corner.x + gap, end.y - height - 2 * gap);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec4 behind = ImGui::GetStyleColorVec4(ImGuiCol_PopupBg);
  list.AddRectFilled({lower.x - gap / 2, lower.y - gap / 2},
                     {lower.x + names + gap + texts + gap / 2, lower.y + height + gap / 2},
                     ImGui::GetColorU32({behind.x, behind.y, behind.z, 0.8f}),
                     ImGui::GetStyle().FrameRounding);
  ImVec2 at = lower;
  for (const auto& [name, text] : under_mouse_) {
    list.AddText(at, ImGui::GetColorU32(ImGuiCol_TextDisabled), name.c_str());
    list.AddText({at.x + names + gap, at.y}, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
    log_.note_place("value " + name + " " + text, PicturePlace::around(at, 1));
    at.y += line;
  }
}

namespace {

ImU32 packed(const Color& color) {
  return ImGui::GetColorU32({color.red, color.green, color.blue, 1});
}

float width_of(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

}  // namespace

// In the upper left corner, over a picture without its own legend.
void PictureView::show_legend(const ImVec2& corner) const {
  if (legend_.empty()) return;
  const float line = ImGui::GetTextLineHeightWithSpacing(), gap = 0.5f * line;
  const bool scaled = !legend_.scale.empty();
  float width = width_of(legend_.title);
  if (scaled) width = std::max(width, width_of(legend_.lowest + legend_.highest) + 2 * line);
  for (const ViewLegend::Entry& entry : legend_.entries) {
    width = std::max(width, line + width_of(entry.meaning));
  }
  const float lines = static_cast<float>(legend_.entries.size()) + (legend_.title.empty() ? 0 : 1) +
                      (scaled ? 2 : 0);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImVec2 at(corner.x + 2 * gap, corner.y + 2 * gap);
  const ImVec4 behind = ImGui::GetStyleColorVec4(ImGuiCol_PopupBg);
  list.AddRectFilled({at.x - gap, at.y - gap}, {at.x + width + gap, at.y + lines * line + gap / 2},
                     ImGui::GetColorU32({behind.x, behind.y, behind.z, 0.8f}),
                     ImGui::GetStyle().FrameRounding);
  const auto text = [&](float x, const std::string& words) {
    list.AddText({x, at.y}, ImGui::GetColorU32(ImGuiCol_Text), words.c_str());
    log_.note_place("legend " + words, PicturePlace::around({x, at.y}, 1));
  };
  if (!legend_.title.empty()) {
    text(at.x, legend_.title);
    at.y += line;
  }
  const float step = scaled ? width / static_cast<float>(legend_.scale.size()) : 0;
  for (std::size_t i = 0; i < legend_.scale.size(); ++i) {
    const float left = at.x + static_cast<float>(i) * step;
    list.AddRectFilled({left, at.y}, {left + step, at.y + 0.8f * line}, packed(legend_.scale[i]));
  }
  if (scaled) {
    at.y += line;
    text(at.x, legend_.lowest);
    text(at.x + width - width_of(legend_.highest), legend_.highest);
    at.y += line;
  }
  for (const ViewLegend::Entry& entry : legend_.entries) {
    list.AddCircleFilled({at.x + 0.35f * line, at.y + 0.4f * line}, 0.3f * line,
                         packed(entry.color));
    text(at.x + line, entry.meaning);
    at.y += line;
  }
}

// In the middle of the picture.
void PictureView::show_why_empty(const ImVec2& corner, const ImVec2& room) const {
  const std::string& why = uploaded_->nothing_left;
  if (why.empty()) return;
  const float line = ImGui::GetTextLineHeight();
  const float width = std::min(30 * ImGui::GetFontSize(), room.x - 2 * line);
  const ImVec2 size = ImGui::CalcTextSize(why.c_str(), nullptr, false, width);
  const ImVec2 at(corner.x + (room.x - size.x) / 2, corner.y + (room.y - size.y) / 2);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec4 behind = ImGui::GetStyleColorVec4(ImGuiCol_PopupBg);
  list.AddRectFilled(
      {at.x - line / 2, at.y - line / 2}, {at.x + size.x + line / 2, at.y + size.y + line / 2},
      ImGui::GetColorU32({behind.x, behind.y, behind.z, 0.9f}), ImGui::GetStyle().FrameRounding);
  list.AddText(nullptr, 0, at, ImGui::GetColorU32(ImGuiCol_Text), why.c_str(), nullptr, width);
  log_.note_place("why empty", PicturePlace::around(at, 1));
}

void PictureView::show(const PicturePlace& place) {
  const ImVec2 end = place.unit({place.size.width, place.size.height});
  const auto id = std::uintptr_t{texture_};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (shown_options(live_.document()).contains("transparent")) {
    // The background of transparent pictures.
    list.AddRectFilled(place.corner, end, ImGui::GetColorU32(ImGuiCol_FrameBg));
  }
  list.AddImage(reinterpret_cast<ImTextureID>(id), place.corner, end);
}

void PictureView::follow_mouse(const PicturePlace& place,
                               const std::vector<Eigen::Vector2f>& trail) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool draws = tool_.draws();
  const bool moves_place = places_.follow_mouse(place);
  if (draws && !moves_place) follow_tool(place, trail);
  if (ImGui::IsItemActive() && !drawing_ && !moves_place &&
      (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
    if (tool_.tool() == Tool::light && ImGui::IsMouseDown(ImGuiMouseButton_Left) && !io.KeyShift) {
      return drag_light(place, io.MouseDelta);
    }
    look(io.MouseDelta, ImGui::IsMouseDown(ImGuiMouseButton_Middle) || io.KeyShift, place);
  }
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    if (!draws) centre_at(place);
    tool_.finish_spline();
  }
}

void PictureView::follow_tool(const PicturePlace& place,
                              const std::vector<Eigen::Vector2f>& trail) {
  std::vector<Eigen::Vector2d> pixels;
  for (const Eigen::Vector2f& at : trail) pixels.push_back(place.pixel({at.x(), at.y()}));
  if (pixels.empty()) pixels.push_back(place.pixel(ImGui::GetIO().MousePos));
  if (ImGui::IsItemActivated() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    drawing_ = true;
    tool_.press(place, pixels.front());
  }
  if (!drawing_) return;
  tool_.drag(place, pixels);
  if (ImGui::IsItemActive()) return;
  drawing_ = false;
  tool_.release();
}

void PictureView::look(const ImVec2& motion, bool moves, const PicturePlace& place) {
  const CameraView& view = live_.document().camera;
  const Eigen::Vector2f pixels = place.pixels_per_unit * Eigen::Vector2f(motion.x, motion.y);
  if (moves) {
    if (const auto center = middle()) {
      live_.apply_dragged(commands::set_camera(
          moved(view, place.frame->camera, view.center.value_or(*center), place.size, pixels)));
    }
    return;
  }
  live_.apply_dragged(
      commands::set_camera(turned(view, pixels / static_cast<float>(place.size.height))));
}

std::optional<Vec3> PictureView::middle() const {
  if (!live_.frame()) return std::nullopt;
  return middle_of(live_.frame()->camera, bounding_box(live_.frame()->surface().mesh).center());
}

void PictureView::follow_wheel() {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseWheel == 0 || io.KeyCtrl) return;
  live_.apply_moving(commands::set_camera(zoomed(live_.document().camera, io.MouseWheel)));
}

void PictureView::centre_at(const PicturePlace& place) {
  const auto hit = place.pick(place.pixel(ImGui::GetIO().MousePos));
  CameraView view = live_.document().camera;
  if (hit) {
    view.center = hit->position;
  } else {
    view.center.reset();
  }
  live_.apply(commands::set_camera(view));
}

// As if it were on a ball.
void PictureView::drag_light(const PicturePlace& place, const ImVec2& motion) {
  if (motion.x == 0 && motion.y == 0) return;
  const Eigen::Vector2f pixels = place.pixels_per_unit * Eigen::Vector2f(motion.x, motion.y);
  const LightDirection light =
      moved_light(light_of(live_.document()), pixels / static_cast<float>(place.size.height));
  live_.apply_dragged(commands::set_option(
      kLightFrom, {formatted("%.1f,%.1f", static_cast<double>(light.azimuth_deg),
                             static_cast<double>(light.elevation_deg))}));
}

// A disc if the light is in front of the scene, a ring if it is behind.
void PictureView::draw_light(const ImVec2& corner) const {
  constexpr float kRadians = std::numbers::pi_v<float> / 180;
  const LightDirection light = light_of(live_.document());
  const float azimuth = light.azimuth_deg * kRadians, elevation = light.elevation_deg * kRadians;
  const ImVec2 middle(corner.x - kBall - kBallRoom, corner.y + kBall + kBallRoom);
  const ImVec2 at(middle.x + kBall * std::cos(elevation) * std::sin(azimuth),
                  middle.y - kBall * std::sin(elevation));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec4 behind = ImGui::GetStyleColorVec4(ImGuiCol_PopupBg);
  const ImU32 color = IM_COL32(255, 190, 40, 255), rim = ImGui::GetColorU32(ImGuiCol_Text);
  list.AddCircleFilled(middle, kBall, ImGui::GetColorU32({behind.x, behind.y, behind.z, 0.8f}));
  list.AddCircle(middle, kBall, rim);
  if (std::cos(azimuth) >= 0) {
    list.AddCircleFilled(at, 5, color);
  } else {
    list.AddCircle(at, 5, color, 0, 2);
  }
  list.AddCircle(at, 6.5f, rim);
  log_.note_place("light", PicturePlace::around(at, 6));
}

}  // namespace brindle::tool
