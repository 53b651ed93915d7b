#include "window/picture/place_handles.h"

#include <algorithm>

#include "window/picture/camera_motion.h"

namespace brindle::tool {
namespace {

constexpr double kNearHandle = 12;  // units of Dear ImGui
constexpr float kHandleSize = 7;
constexpr ImU32 kHandleColor = IM_COL32(90, 170, 255, 255);
constexpr ImU32 kHandleRim = IM_COL32(16, 24, 40, 230);

}  // namespace

std::optional<std::size_t> PlaceHandles::handle_at(const PicturePlace& place,
                                                   const Eigen::Vector2d& pixel) const {
  std::optional<std::size_t> nearest;
  double least = kNearHandle * place.pixels_per_unit;
  const std::vector<NamedPlace> places = named_places(shown_options(live_.document()));
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto handle = place.pixel_of_place(places[i].at);
    if (!handle || (*handle - pixel).norm() > least) continue;
    least = (*handle - pixel).norm();
    nearest = i;
  }
  return nearest;
}

SessionCommand PlaceHandles::moved(const NamedPlace& from, const Eigen::Vector3d& to) const {
  return commands::set_options(with_place_at(to, from, shown_options(live_.document())));
}

// At constant depth.
void PlaceHandles::drag(const PicturePlace& place, const Eigen::Vector2d& pixel) {
  const std::vector<NamedPlace> places = named_places(shown_options(live_.document()));
  if (chosen_ >= places.size()) return;
  const Eigen::Vector3d origin = place.frame->surface().mesh.origin;
  const Vec3 to = place_under(place.frame->camera, place.size, pixel,
                              (places[chosen_].at - origin).cast<float>());
  live_.apply_dragged(moved(places[chosen_], to.cast<double>() + origin));
}

void PlaceHandles::hover(const PicturePlace& place, const Eigen::Vector2d& pixel) {
  const std::vector<NamedPlace> places = named_places(shown_options(live_.document()));
  if (places.empty()) return;
  const auto hit = place.pick(pixel);
  if (hit) live_.apply_moving(moved(places[std::min(chosen_, places.size() - 1)], hit->place));
}

bool PlaceHandles::follow_mouse(const PicturePlace& place) {
  const ImGuiIO& io = ImGui::GetIO();
  const Eigen::Vector2d pixel = place.pixel(io.MousePos);
  const bool has_moved = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
  if (ImGui::IsItemActivated() && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    const auto handle = handle_at(place, pixel);
    dragging_ = handle.has_value();
    chosen_ = handle.value_or(chosen_);
  }
  if (!ImGui::IsItemActive()) dragging_ = false;
  if (!has_moved) return dragging_;
  if (dragging_) {
    drag(place, pixel);
  } else if (follows_ && ImGui::IsItemHovered() && !ImGui::IsAnyMouseDown()) {
    hover(place, pixel);
  }
  return dragging_;
}

void PlaceHandles::draw_over(ImDrawList& list, const PicturePlace& place) {
  std::size_t number = 0;
  for (const NamedPlace& named : named_places(shown_options(live_.document()))) {
    const auto pixel = place.pixel_of_place(named.at);
    ++number;
    if (!pixel) continue;
    const ImVec2 at = place.unit(*pixel);
    list.AddNgonFilled(at, kHandleSize + 2.5f, kHandleRim, 4);
    list.AddNgonFilled(at, kHandleSize, kHandleColor, 4);
    log_.note_place("place " + std::to_string(number), PicturePlace::around(at, kHandleSize));
  }
}

}  // namespace brindle::tool
