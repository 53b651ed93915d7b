#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>

#include "brindle/base/elementary.h"
#include "brindle/base/standard.h"
#include "brindle/image.h"
#include "brindle/render/color_names.h"
#include "brindle/render/parsed_words.h"
#include "brindle/render/surface_light.h"
#include "brindle/renderer.h"

namespace brindle {
namespace {

float linear_of(float channel) {
  return channel <= 0.04045f ? channel / 12.92f
                             : elementary::pow((channel + 0.055f) / 1.055f, 2.4f);
}

float srgb_of(float light) {
  const float clamped = std::clamp(light, 0.0f, 1.0f);
  return clamped <= 0.0031308f ? 12.92f * clamped
                               : 1.055f * elementary::pow(clamped, 1 / 2.4f) - 0.055f;
}

/// From lightness, chroma and hue; the matrices are those of Ottosson's definition of Oklab.
Color oklch_color(float lightness, float chroma, float hue_deg) {
  const float hue = hue_deg * std::numbers::pi_v<float> / 180;
  const float a = chroma * elementary::cos(hue);
  const float b = chroma * elementary::sin(hue);
  const float l = elementary::pow(lightness + 0.3963377774f * a + 0.2158037573f * b, 3.0f);
  const float m = elementary::pow(lightness - 0.1055613458f * a - 0.0638541728f * b, 3.0f);
  const float s = elementary::pow(lightness - 0.0894841775f * a - 1.2914855480f * b, 3.0f);
  return {srgb_of(4.0767416621f * l - 3.3077115913f * m + 0.2309699292f * s),
          srgb_of(-1.2684380046f * l + 2.6097574011f * m - 0.3413193965f * s),
          srgb_of(-0.0041960863f * l - 0.7034186147f * m + 1.7076147010f * s)};
}

struct ColorStop {
  float chroma;
  float hue_deg;
};

// Chroma stays within what sRGB can show at each lightness.
constexpr std::array<ColorStop, 6> kErrorStops{
    {{0.03f, 95}, {0.10f, 80}, {0.15f, 58}, {0.17f, 33}, {0.14f, 5}, {0.08f, -40}}};
constexpr float kLightest = 0.95f;
constexpr float kDarkest = 0.25f;

Color color_of(std::uint32_t rgb) {
  const auto channel = [&](int shift) { return static_cast<float>(rgb >> shift & 255) / 255; };
  return {channel(16), channel(8), channel(0)};
}

/// Names are in small or capital letters.
std::optional<Color> named_color(std::string_view text) {
  std::string name(text);
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  const auto found = ranges::lower_bound(kColorNames, name, {}, &ColorName::name);
  if (found == kColorNames.end() || found->name != name) return {};
  return color_of(found->rgb);
}

/// Colours at equal steps, 0xrrggbb. Splines through them are within two levels of the full tables.
constexpr std::array<std::uint32_t, 10> kViridis{0x440154, 0x482878, 0x3e4a89, 0x31688e, 0x26828e,
                                                 0x1f9e89, 0x35b779, 0x6dcd59, 0xb4de2c, 0xfde725};
constexpr std::array<std::uint32_t, 10> kMagma{0x000004, 0x180f3e, 0x451077, 0x721f81, 0x9f2f7f,
                                               0xcd4071, 0xf1605d, 0xfd9567, 0xfec98d, 0xfcfdbf};
constexpr std::array<std::uint32_t, 10> kCividis{0x00204d, 0x00336f, 0x39486b, 0x575c6d, 0x707173,
                                                 0x8a8779, 0xa69d75, 0xc4b56c, 0xe4cf5b, 0xffea46};
constexpr std::array<std::uint32_t, 9> kCoolwarm{0x3b4cc0, 0x6282ea, 0x8db0fe, 0xb8d0f9, 0xdddddd,
                                                 0xf5c4ad, 0xf49a7b, 0xde604d, 0xb40426};

std::span<const std::uint32_t> colors_of(ColorMap map) {
  switch (map) {
    case ColorMap::viridis:
      return kViridis;
    case ColorMap::magma:
      return kMagma;
    case ColorMap::cividis:
      return kCividis;
    case ColorMap::coolwarm:
      return kCoolwarm;
  }
  return kViridis;
}

Vec3 level(std::uint32_t color) {
  return Vec3(static_cast<float>(color >> 16 & 0xff), static_cast<float>(color >> 8 & 0xff),
              static_cast<float>(color & 0xff)) /
         255;
}

/// Catmull-Rom spline between b and c.
Vec3 spline(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, float t) {
  return b + 0.5f * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

}  // namespace

std::optional<Color> parse_color(std::string_view text) {
  if (const auto named = named_color(text)) return named;
  if (text.starts_with('#')) text.remove_prefix(1);
  std::string digits(text);
  if (digits.size() == 3) {
    digits = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
  }
  if (digits.size() != 6) return {};
  std::array<float, 3> channels{};
  for (std::size_t c = 0; c < 3; ++c) {
    unsigned value = 0;
    const char* begin = digits.data() + 2 * c;
    const auto [end, failure] = std::from_chars(begin, begin + 2, value, 16);
    if (failure != std::errc() || end != begin + 2) return {};
    channels[c] = static_cast<float>(value) / 255;
  }
  return Color{channels[0], channels[1], channels[2]};
}

Vec3 linear_light(const Color& color) {
  return {linear_of(color.red), linear_of(color.green), linear_of(color.blue)};
}

Pixel pixel_of(const Eigen::Vector4f& light) {
  const float alpha = light.w();
  if (!(alpha > 0)) return {0, 0, 0, 0};
  const auto byte_of = [](float level) {
    return static_cast<std::uint8_t>(std::lround(255 * level));
  };
  return {byte_of(srgb_of(light.x() / alpha)), byte_of(srgb_of(light.y() / alpha)),
          byte_of(srgb_of(light.z() / alpha)), byte_of(std::min(alpha, 1.0f))};
}

Color error_color(float value) {
  const float t = value > 0 ? std::min(value, 1.0f) : 0.0f;  // false for NaN too
  const float place = t * (kErrorStops.size() - 1);
  const std::size_t left = std::min(static_cast<std::size_t>(place), kErrorStops.size() - 2);
  const float share = place - static_cast<float>(left);
  const ColorStop& a = kErrorStops[left];
  const ColorStop& b = kErrorStops[left + 1];
  return oklch_color(kLightest + t * (kDarkest - kLightest),
                     a.chroma + share * (b.chroma - a.chroma),
                     a.hue_deg + share * (b.hue_deg - a.hue_deg));
}

std::optional<ColorMap> parse_color_map(std::string_view name) {
  if (name == "viridis") return ColorMap::viridis;
  if (name == "magma") return ColorMap::magma;
  if (name == "cividis") return ColorMap::cividis;
  if (name == "coolwarm") return ColorMap::coolwarm;
  return std::nullopt;
}

Color map_color(ColorMap map, float place) {
  const std::span<const std::uint32_t> colors = colors_of(map);
  const auto last = static_cast<std::ptrdiff_t>(colors.size()) - 1;
  const float t = place > 0 ? std::min(place, 1.0f) : 0.0f;  // false for NaN too
  const auto left = std::min(static_cast<std::ptrdiff_t>(t * static_cast<float>(last)), last - 1);
  const auto at = [&](std::ptrdiff_t i) {
    return level(colors[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last))]);
  };
  // Linear extrapolation beyond the ends.
  const Vec3 before = left > 0 ? at(left - 1) : Vec3(2 * at(0) - at(1));
  const Vec3 after = left + 2 <= last ? at(left + 2) : Vec3(2 * at(last) - at(last - 1));
  const float share = t * static_cast<float>(last) - static_cast<float>(left);
  const Vec3 color =
      spline(before, at(left), at(left + 1), after, share).cwiseMax(0.0f).cwiseMin(1.0f);
  return {color.x(), color.y(), color.z()};
}

namespace {

constexpr Color kBranchColor{0.84f, 0.15f, 0.16f};
constexpr Color kSingularityColor{0.95f, 0.62f, 0.07f};

Vec3 centre_of(const Mesh& mesh, const Triangle& triangle) {
  const Vec3& first = mesh.positions[triangle[0]];
  return first +
         ((mesh.positions[triangle[1]] - first) + (mesh.positions[triangle[2]] - first)) / 3;
}

}  // namespace

Overlay branch_overlay(const Mesh& mesh, std::span<const CornerPhases> corners) {
  Overlay overlay;
  overlay.triangle_colors.resize(mesh.triangle_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const TriangleKind kind = corners[t].kind;
    if (!is_branch(kind)) continue;
    const Color color = kind == TriangleKind::branch ? kBranchColor : kSingularityColor;
    overlay.triangle_colors[t] = {color, 0.85f};
    overlay.marks.push_back({centre_of(mesh, mesh.triangles[t]), color});
  }
  return overlay;
}

Overlay error_overlay(std::span<const float> values, float largest) {
  Overlay overlay;
  overlay.triangle_colors.reserve(values.size());
  for (const float value : values) {
    overlay.triangle_colors.push_back(value >= 0 ? TriangleColor{error_color(value / largest), 1}
                                                 : TriangleColor{});
  }
  return overlay;
}

}  // namespace brindle
