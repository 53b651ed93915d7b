#include "window/base/theme.h"

#include <array>
#include <cmath>
#include <filesystem>

#include <imgui.h>

namespace brindle::tool {
namespace {

constexpr float kTextHeight = 15;  // units of a standard display

constexpr std::array kFontFiles = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/usr/share/fonts/truetype/freefont/FreeSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf"};

// File names may be in many scripts.
constexpr std::array<ImWchar, 11> kGlyphs = {0x0020, 0x024f, 0x0370, 0x03ff, 0x0400, 0x04ff,
                                             0x2010, 0x2044, 0x2190, 0x21ff, 0};

ImVec4 gray(float value, float alpha = 1) { return {value, value, value * 1.03f, alpha}; }

// One accent colour for draggable widgets, selections and keyboard focus.
void color_accents(ImVec4* colors, const ImVec4& accent) {
  const auto with_alpha = [&](float alpha) { return ImVec4(accent.x, accent.y, accent.z, alpha); };
  colors[ImGuiCol_CheckMark] = accent;
  colors[ImGuiCol_SliderGrab] = with_alpha(0.8f);
  colors[ImGuiCol_SliderGrabActive] = accent;
  colors[ImGuiCol_PlotLines] = accent;
  colors[ImGuiCol_PlotHistogram] = with_alpha(0.8f);
  colors[ImGuiCol_NavHighlight] = accent;
  colors[ImGuiCol_TextSelectedBg] = with_alpha(0.35f);
  colors[ImGuiCol_HeaderHovered] = with_alpha(0.3f);
  colors[ImGuiCol_HeaderActive] = with_alpha(0.4f);
  colors[ImGuiCol_ButtonHovered] = with_alpha(0.35f);
  colors[ImGuiCol_ButtonActive] = with_alpha(0.5f);
  colors[ImGuiCol_ResizeGrip] = with_alpha(0);
  colors[ImGuiCol_ResizeGripHovered] = with_alpha(0.4f);
  colors[ImGuiCol_ResizeGripActive] = with_alpha(0.7f);
  colors[ImGuiCol_SeparatorHovered] = with_alpha(0.4f);
  colors[ImGuiCol_SeparatorActive] = with_alpha(0.7f);
}

void color_dark(ImVec4* colors) {
  ImGui::StyleColorsDark();
  colors[ImGuiCol_Text] = gray(0.92f);
  colors[ImGuiCol_TextDisabled] = gray(0.58f);
  colors[ImGuiCol_WindowBg] = gray(0.125f);
  colors[ImGuiCol_PopupBg] = gray(0.16f, 0.98f);
  colors[ImGuiCol_MenuBarBg] = gray(0.16f);
  colors[ImGuiCol_TitleBgActive] = gray(0.2f);
  colors[ImGuiCol_FrameBg] = gray(0.21f);
  colors[ImGuiCol_FrameBgHovered] = gray(0.26f);
  colors[ImGuiCol_FrameBgActive] = gray(0.3f);
  colors[ImGuiCol_Button] = gray(0.26f);
  colors[ImGuiCol_Header] = gray(0.2f);
  colors[ImGuiCol_Separator] = gray(0.27f);
  color_accents(colors, {0.35f, 0.66f, 0.95f, 1});
}

void color_light(ImVec4* colors) {
  ImGui::StyleColorsLight();
  colors[ImGuiCol_Text] = gray(0.1f);
  colors[ImGuiCol_TextDisabled] = gray(0.42f);
  colors[ImGuiCol_WindowBg] = gray(0.925f);
  colors[ImGuiCol_PopupBg] = gray(0.98f, 0.98f);
  colors[ImGuiCol_MenuBarBg] = gray(0.9f);
  colors[ImGuiCol_TitleBgActive] = gray(0.85f);
  colors[ImGuiCol_FrameBg] = {1, 1, 1, 1};
  colors[ImGuiCol_Border] = gray(0.74f);
  colors[ImGuiCol_Button] = gray(0.85f);
  colors[ImGuiCol_Header] = gray(0.87f);
  colors[ImGuiCol_Separator] = gray(0.78f);
  color_accents(colors, {0.1f, 0.4f, 0.75f, 1});
}

}  // namespace

ImVec4 warning_color(bool dark) {
  return dark ? ImVec4(1, 0.5f, 0.4f, 1) : ImVec4(0.7f, 0.1f, 0.05f, 1);
}

void load_fonts(float scale, float pixels_per_unit) {
  ImGuiIO& io = ImGui::GetIO();
  io.Fonts->Clear();
  const float height = std::round(kTextHeight * scale * pixels_per_unit);
  io.FontGlobalScale = 1 / pixels_per_unit;
  for (const char* file : kFontFiles) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) continue;
    if (io.Fonts->AddFontFromFileTTF(file, height, nullptr, kGlyphs.data()) != nullptr) return;
  }
  ImFontConfig config;
  config.SizePixels = height;
  io.Fonts->AddFontDefault(&config);
}

void apply_theme(bool dark, float scale) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  style.WindowPadding = {10, 8};
  style.FramePadding = {6, 3};
  style.ItemSpacing = {7, 5};
  style.FrameRounding = 3;
  style.GrabRounding = 3;
  style.PopupRounding = 4;
  style.ScrollbarSize = 12;
  style.WindowBorderSize = 0;
  style.GrabMinSize = 8;
  style.FrameBorderSize = dark ? 0.0f : 1.0f;
  (dark ? color_dark : color_light)(style.Colors);
  style.ScaleAllSizes(scale);
}

}  // namespace brindle::tool
