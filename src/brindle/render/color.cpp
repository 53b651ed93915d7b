#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

#include "brindle/base/elementary.h"
#include "brindle/base/standard.h"
#include "brindle/image.h"
#include "brindle/render/color_names.h"
#include "brindle/render/parsed_words.h"

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

}  // namespace brindle
