#include "brindle/color_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "brindle/render/parsed_words.h"

namespace brindle {
namespace {

/// Colours at equal distances, 0xrrggbb. A spline through so few is within two levels of the maps'
/// full tables.
constexpr std::array<std::uint32_t, 10> kViridis{0x440154, 0x482878, 0x3e4a89, 0x31688e, 0x26828e,
                                                 0x1f9e89, 0x35b779, 0x6dcd59, 0xb4de2c, 0xfde725};
constexpr std::array<std::uint32_t, 10> kMagma{0x000004, 0x180f3e, 0x451077, 0x721f81, 0x9f2f7f,
                                               0xcd4071, 0xf1605d, 0xfd9567, 0xfec98d, 0xfcfdbf};
constexpr std::array<std::uint32_t, 10> kCividis{0x00204d, 0x00336f, 0x39486b, 0x575c6d, 0x707173,
                                                 0x8a8779, 0xa69d75, 0xc4b56c, 0xe4cf5b, 0xffea46};
constexpr std::array<std::uint32_t, 9> kCoolwarm{0x3b4cc0, 0x6282ea, 0x8db0fe, 0xb8d0f9, 0xdddddd,
                                                 0xf5c4ad, 0xf49a7b, 0xde604d, 0xb40426};

constexpr std::string_view kNames = "viridis|magma|cividis|coolwarm";

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

/// Catmull and Rom's spline between b and c.
Vec3 spline(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, float t) {
  return b + 0.5f * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

}  // namespace

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
  // Straight on beyond the ends.
  const Vec3 before = left > 0 ? at(left - 1) : Vec3(2 * at(0) - at(1));
  const Vec3 after = left + 2 <= last ? at(left + 2) : Vec3(2 * at(last) - at(last - 1));
  const float share = t * static_cast<float>(last) - static_cast<float>(left);
  const Vec3 color =
      spline(before, at(left), at(left + 1), after, share).cwiseMax(0.0f).cwiseMin(1.0f);
  return {color.x(), color.y(), color.z()};
}

}  // namespace brindle
