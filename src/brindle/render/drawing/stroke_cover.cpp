#include "brindle/render/drawing/stroke_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "brindle/base/elementary.h"
#include "brindle/corner_phases.h"
#include "brindle/fragment_phase.h"

namespace brindle {
namespace {

using Corners = std::array<CornerWave, 3>;

/// NaN where a corner has no value, as the surface is plain there.
float blended_value(std::span<const float> values, const Triangle& t, const Vec3& weights) {
  return weights[0] * values[t[0]] + weights[1] * values[t[1]] + weights[2] * values[t[2]];
}

/// The phase over 2 pi; a quarter is a peak.
float turns_of(Complex z) {
  return elementary::atan2(z.imag(), z.real()) / (2 * std::numbers::pi_v<float>);
}

/// How many turns the phase makes in a pixel, where it rises fastest.
float turns_per_pixel(const Corners& corners, const SeenPoint& point) {
  std::array<FragmentWave, 4> waves;
  fragment_phases(corners, point.beside, waves);
  std::array<float, 4> turns;
  for (std::size_t i = 0; i < 4; ++i) turns[i] = turns_of(waves[i].z);
  const auto gain = [&](float from, float to) {
    const float difference = to - from;
    return (difference - std::floor(difference + 0.5f)) / point.step;
  };
  return std::hypot(gain(turns[1], turns[0]), gain(turns[3], turns[2]));
}

bool pulse_covers(float turns, float width) {
  return width > 0 && std::abs(turns - std::floor(turns + 0.5f)) <= 0.5f * width;
}

float smooth_rise(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

/// Whether strokes cover the phase `turns` from a peak, or those that grow between them.
bool levels_cover(const Strokes& strokes, float turns, float width, float footprint) {
  const bool in_pixels = strokes.unit == WidthUnit::pixels;
  if (!(strokes.spacing > 0)) {
    return pulse_covers(turns, std::min(in_pixels ? width * footprint : width, 1.0f));
  }
  const float octaves = std::max(-std::log2(std::max(footprint * strokes.spacing, 1e-9f)), 0.0f);
  const float level = std::min(std::floor(octaves), 8.0f);
  const float grown = smooth_rise(0.3f, 1.0f, octaves - level > 1 ? 1.0f : octaves - level);
  const float finer = std::exp2(level);
  const float own = in_pixels ? width * footprint * finer : width * (1 - 0.5f * grown);
  const float between = in_pixels ? own * grown : 0.5f * width * grown;
  return pulse_covers(turns * finer, std::min(own, 1.0f)) ||
         pulse_covers(turns * finer - 0.5f, std::min(between, 1.0f));
}

bool is_plain(const Strokes& strokes, const Corners& corners, const Triangle& t) {
  for (std::size_t m = 0; m < 3; ++m) {
    if (corners[m].wave.direction.isZero(0)) return true;
    for (const auto& values : {strokes.widths, strokes.opacities, strokes.color_places}) {
      if (!values.empty() && std::isnan(values[t[m]])) return true;
    }
  }
  return false;
}

bool strokes_cover(const Strokes& strokes, const Corners& corners, const SeenPoint& point,
                   float tone) {
  const FragmentWave wave = fragment_phase(corners, point.barycentric);
  if (wave.direction.isZero(0) && wave.z == Complex(0)) return false;
  const Triangle& t = point.surface->mesh.triangles[point.triangle];
  float width =
      strokes.widths.empty() ? strokes.width : blended_value(strokes.widths, t, point.barycentric);
  if (strokes.tone) {
    const ToneRange& range = *strokes.tone;
    const float rise = std::clamp((range.none - tone) / (range.none - range.full), 0.0f, 1.0f);
    width *= range.least + (1 - range.least) * rise;
  }
  const bool on_screen = strokes.unit == WidthUnit::pixels || strokes.spacing > 0;
  const float footprint = on_screen ? turns_per_pixel(corners, point) : 0.0f;
  if (wave.z == Complex(0)) {
    return (strokes.unit == WidthUnit::pixels ? width * footprint : width) > 0.5f;
  }
  return levels_cover(strokes, turns_of(wave.z) - 0.25f, width, footprint);
}

}  // namespace

bool follows_tone(const StyledSurface& surface) {
  return std::any_of(surface.strokes.begin(), surface.strokes.end(),
                     [](const Strokes& strokes) { return strokes.tone.has_value(); });
}

Cover cover_at(const SeenPoint& point, float tone) {
  const Triangle& t = point.surface->mesh.triangles[point.triangle];
  Cover cover = Cover::plain;
  for (const Strokes& strokes : point.surface->strokes) {
    const Corners corners = corner_waves(t, *strokes.waves, strokes.z);
    if (is_plain(strokes, corners, t)) continue;
    if (strokes_cover(strokes, corners, point, tone)) return Cover::stroke;
    cover = Cover::ground;
  }
  return cover;
}

}  // namespace brindle
