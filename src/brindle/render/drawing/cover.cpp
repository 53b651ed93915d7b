#include "brindle/render/drawing/cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include <Eigen/LU>

#include "brindle/base/elementary.h"
#include "brindle/corner_phases.h"
#include "brindle/fragment_phase.h"
#include "brindle/pattern/figure_middle.h"

namespace brindle {
namespace {

using Corners = std::array<CornerWave, 3>;

/// NaN if a corner has no value: the surface is plain there.
float blended_value(std::span<const float> values, const Triangle& t, const Vec3& weights) {
  return weights[0] * values[t[0]] + weights[1] * values[t[1]] + weights[2] * values[t[2]];
}

/// The phase over 2 pi; peaks are at a quarter.
float turns_of(Complex z) {
  return elementary::atan2(z.imag(), z.real()) / (2 * std::numbers::pi_v<float>);
}

/// Phase gained per pixel in the steepest direction, in turns.
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

/// Whether strokes cover the phase `turns` from a peak, including those that grow between others.
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

namespace {

using Point = Eigen::Vector2f;

constexpr float kSmallestSize = 1e-3f;
constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

/// At a point of a triangle, and one step to its right, left, below and above.
using Stencil = std::array<std::optional<Point>, 5>;

/// Texture coordinates without the shift of all tiles; empty without waves. Neighbours only if
/// `beside`.
Stencil coordinates_at(const SeenPoint& point, bool beside) {
  const RegionTexture& texture = *point.surface->texture;
  std::array<Vec3, 5> places{point.barycentric};
  std::copy(point.beside.begin(), point.beside.end(), places.begin() + 1);
  const std::span<const Vec3> seen(places.data(), beside ? places.size() : 1);
  std::array<FragmentWave, 5> u, v;
  split_fragment_phases(texture.waves->u[point.triangle], seen, u);
  split_fragment_phases(texture.waves->v[point.triangle], seen, v);
  const auto is_wave = [](const FragmentWave& wave) {
    return !wave.direction.isZero(0) && wave.z != Complex(0);
  };
  Stencil uv;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!is_wave(u[i]) || !is_wave(v[i])) continue;
    uv[i] = Point(texture_coordinate(u[i].z), texture_coordinate(v[i].z)) - texture.shift;
  }
  return uv;
}

/// From one point to another nearby.
Point gain(const Point& from, const Point& to) {
  const Point difference = to - from;
  return {difference.x() - std::floor(difference.x() + 0.5f),
          difference.y() - std::floor(difference.y() + 0.5f)};
}

/// The middle of the tile relative to the point, in pixels to the right and down; zero if tiles are
/// too small to tell apart.
Point pixels_to_middle(const SeenPoint& point, const Stencil& stencil) {
  for (const auto& there : stencil) {
    if (!there) return Point::Zero();
  }
  const Point uv = *stencil[0];
  Eigen::Matrix2f per_pixel;
  per_pixel.col(0) = gain(*stencil[2], *stencil[1]) / point.step;
  per_pixel.col(1) = gain(*stencil[4], *stencil[3]) / point.step;
  if (std::abs(per_pixel.determinant()) < 1e-12f) return Point::Zero();
  const Point to_middle(std::floor(uv.x()) + 0.5f - uv.x(), std::floor(uv.y()) + 0.5f - uv.y());
  return per_pixel.inverse() * to_middle;
}

/// A value in the middle of the tile, to first order; NaN if a corner has none.
float value_of_tile(const SeenPoint& point, std::span<const float> values, const Point& pixels) {
  const Triangle& t = point.surface->mesh.triangles[point.triangle];
  const Vec3 corners(values[t[0]], values[t[1]], values[t[2]]);
  if (!corners.allFinite()) return kNoValue;
  const Vec3 right = (point.beside[0] - point.beside[1]) / point.step;
  const Vec3 down = (point.beside[2] - point.beside[3]) / point.step;
  return corners.dot(point.barycentric + pixels.x() * right + pixels.y() * down);
}

/// The last region that begins at this value or below; the first one has no lower bound.
std::size_t region_of(const RegionTexture& texture, float value) {
  std::size_t region = 0;
  for (std::size_t i = 1; i < texture.tiles.size(); ++i) {
    if (value >= texture.tiles[i].from) region = i;
  }
  return region;
}

bool is_left_out(const SeenPoint& point, const RegionTexture& texture, const RegionTile& tile,
                 const Point& uv) {
  if (tile.broken == nullptr) return false;
  if (!tile.broken->is_broken(point.triangle, point.barycentric, uv + texture.shift)) return false;
  if (!tile.broken->split) return true;
  // A joint splits a broken brick along its middle.
  const Point middle = place_of(figure_at(tile.broken->layout, uv));
  return std::abs(uv.x() - middle.x()) <= kHalfJoint;
}

/// `size`: share of its cell that the tile fills.
bool figure_covers(BuiltInTile tile, const Point& uv, float size) {
  if (size >= 1) return tile_distance(tile, uv.x(), uv.y()) <= 0;
  if (!(size > kSmallestSize)) return false;
  const Point from_middle(uv.x() - std::floor(uv.x()) - 0.5f, uv.y() - std::floor(uv.y()) - 0.5f);
  if (from_middle.cwiseAbs().maxCoeff() > 0.5f * size) return false;
  const Point decal = from_middle / size + Point(0.5f, 0.5f);
  return tile_distance(tile, decal.x(), decal.y()) <= 0;
}

}  // namespace

bool follows_values(const RegionTexture& texture) {
  return !texture.values.empty() || !texture.sizes.empty();
}

std::optional<std::size_t> tile_at(const SeenPoint& point) {
  const RegionTexture& texture = *point.surface->texture;
  const Stencil stencil = coordinates_at(point, follows_values(texture));
  const auto& uv = stencil[0];
  if (!uv) return std::nullopt;
  const Point pixels = pixels_to_middle(point, stencil);
  std::size_t region = 0;
  if (!texture.values.empty()) {
    const float value = value_of_tile(point, texture.values, pixels);
    if (std::isnan(value)) return std::nullopt;
    region = region_of(texture, value);
  }
  const RegionTile& tile = texture.tiles[region];
  if (is_left_out(point, texture, tile, *uv)) return std::nullopt;
  const float size = texture.sizes.empty() ? 1.0f : value_of_tile(point, texture.sizes, pixels);
  if (!figure_covers(std::get<BuiltInTile>(tile.tile), *uv, size)) return std::nullopt;
  return region;
}

}  // namespace brindle
