#include "window/picture/light_tool.h"

#include <numbers>
#include <string>

#include "brindle/base/text.h"
#include "brindle/render/parsed_words.h"
#include "session/session_options.h"
#include "window/picture/camera_motion.h"

namespace brindle::tool {
namespace {

constexpr const char* kLightFrom = "light-from";
constexpr float kBall = 26, kBallRoom = 14;  // units of Dear ImGui

}  // namespace

LightDirection light_of(const SessionDocument& document) {
  const OptionValues options = shown_options(document);
  const auto found = options.find(kLightFrom);
  const OptionInfo* info = find_session_option(kLightFrom, document.shown);
  const auto light = found != options.end() && !found->second.empty()
                         ? parse_light_direction(found->second.front())
                         : parse_light_direction(info->standard);
  return light.value_or(LightDirection());
}

void LightTool::drag(const PicturePlace& place, const ImVec2& motion) {
  if (motion.x == 0 && motion.y == 0) return;
  const Eigen::Vector2f pixels = place.pixels_per_unit * Eigen::Vector2f(motion.x, motion.y);
  const LightDirection light =
      moved_light(light_of(live_.document()), pixels / static_cast<float>(place.size.height));
  live_.apply_dragged(
      commands::SetOption{kLightFrom,
                          {formatted("%.1f,%.1f", static_cast<double>(light.azimuth_deg),
                                     static_cast<double>(light.elevation_deg))}});
}

// A disc if the light is in front of the scene, a ring if it is behind.
void LightTool::draw_over(ImDrawList& list, const ImVec2& corner) const {
  constexpr float kRadians = std::numbers::pi_v<float> / 180;
  const LightDirection light = light_of(live_.document());
  const float azimuth = light.azimuth_deg * kRadians, elevation = light.elevation_deg * kRadians;
  const ImVec2 middle(corner.x - kBall - kBallRoom, corner.y + kBall + kBallRoom);
  const ImVec2 at(middle.x + kBall * std::cos(elevation) * std::sin(azimuth),
                  middle.y - kBall * std::sin(elevation));
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
