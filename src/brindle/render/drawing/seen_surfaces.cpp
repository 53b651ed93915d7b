#include "brindle/render/drawing/seen_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <span>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "brindle/base/compressed_rows.h"
#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/corner_phases.h"
#include "brindle/fragment_phase.h"
#include "brindle/pattern/motif_centre.h"
#include "brindle/render/surface_light.h"

namespace brindle {
namespace {

// Whether strokes of a style, or motifs of a texture's tiles, cover a point.

/// A visible point of a triangle.
struct SeenPoint {
  const StyledSurface* surface = nullptr;
  std::size_t number = 0;  ///< of the surface, among all
  std::size_t triangle = 0;
  Vec3 barycentric = Vec3::Zero();
  /// The same half a step to the right, left, below and above in the picture; weights may be
  /// slightly negative.
  std::array<Vec3, 4> beside{};
  float step = 1;  ///< pixels
};

/// The layer that covers a point of a surface.
enum class Cover {
  plain,   ///< no pattern: no wave, or no value for the strokes
  ground,  ///< between strokes
  stroke
};

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

/// Whether strokes cover the phase `turns` from a peak, including those that grow between others.
bool levels_cover(const Strokes& strokes, float turns, float width, float footprint) {
  const bool in_pixels = strokes.unit == WidthUnit::pixels;
  if (!(strokes.spacing > 0)) {
    return pulse_covers(turns, std::min(in_pixels ? width * footprint : width, 1.0f));
  }
  const float octaves = std::max(-std::log2(std::max(footprint * strokes.spacing, 1e-9f)), 0.0f);
  const float level = std::min(std::floor(octaves), 8.0f);
  const float grown = smooth_step(0.3f, 1.0f, octaves - level > 1 ? 1.0f : octaves - level);
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

/// Whether strokes of the surface depend on the light.
bool follows_tone(const StyledSurface& surface) {
  return std::any_of(surface.strokes.begin(), surface.strokes.end(),
                     [](const Strokes& strokes) { return strokes.tone.has_value(); });
}

/// Twin of strokes.glsl with stripe_middle.glsl: the same ends of stripes, but unfiltered. `tone`
/// is the lightness of the surface there, 0 to 1.
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
  const Point middle = place_of(motif_at(tile.broken->layout, uv));
  return std::abs(uv.x() - middle.x()) <= kHalfJoint;
}

/// `size`: share of its cell that the tile fills.
bool motif_covers(BuiltInTile tile, const Point& uv, float size) {
  if (size >= 1) return tile_distance(tile, uv.x(), uv.y()) <= 0;
  if (!(size > kSmallestSize)) return false;
  const Point from_middle(uv.x() - std::floor(uv.x()) - 0.5f, uv.y() - std::floor(uv.y()) - 0.5f);
  if (from_middle.cwiseAbs().maxCoeff() > 0.5f * size) return false;
  const Point decal = from_middle / size + Point(0.5f, 0.5f);
  return tile_distance(tile, decal.x(), decal.y()) <= 0;
}

/// Whether region borders depend on the pixel grid: each tile takes the value in its middle.
bool follows_values(const RegionTexture& texture) {
  return !texture.values.empty() || !texture.sizes.empty();
}

/// The tile of the texture whose motif covers the point; empty if none does. Twin of
/// region_texture.glsl for unfiltered built-in tiles; picture tiles have no motif.
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
  if (!motif_covers(std::get<BuiltInTile>(tile.tile), *uv, size)) return std::nullopt;
  return region;
}

constexpr int kSquare = 4;            // pixels along the side of a square
constexpr double kEdgeSlack = 1e-10;  // rounding of barycentric weights
constexpr double kTurnsStep = 0.02;   // pixels, step of the phase difference

/// View direction to a point.
Vec3 sight_to(const Camera& camera, const Vec3& view_position) {
  return camera.orthographic() ? Vec3(0, 0, -1) : view_position;
}

/// Whether the surface's marks depend on neighbouring screen points.
bool is_measured_on_screen(const StyledSurface& surface) {
  if (surface.texture) return follows_values(*surface.texture);
  return std::any_of(surface.strokes.begin(), surface.strokes.end(),
                     [](const Strokes& s) { return s.unit == WidthUnit::pixels || s.spacing > 0; });
}

/// Finds the nearest triangle at a picture point exactly, with lists of candidate triangles per
/// square of a few pixels instead of a depth grid.
class SeenSurfaces {
 public:
  SeenSurfaces(std::span<const StyledSurface> surfaces, const Camera& camera,
               const PictureLight& light, int width, int height, const Progress& progress)
      : surfaces_(surfaces),
        camera_(camera),
        lights_(lights_of(camera, light)),
        width_(width),
        height_(height),
        columns_((width + kSquare - 1) / kSquare),
        rows_((height + kSquare - 1) / kSquare),
        first_codes_(first_codes(surfaces)) {
    for (const StyledSurface& surface : surfaces) project(surface);
    sort_into_squares(progress);
  }

  std::uint16_t code_at(double x, double y) const {
    if (!(x >= 0 && y >= 0 && x <= width_ && y <= height_)) return 0;
    const int column = std::min(static_cast<int>(x) / kSquare, columns_ - 1);
    const int row = std::min(static_cast<int>(y) / kSquare, rows_ - 1);
    double nearest = std::numeric_limits<double>::infinity();
    Hit best{};
    for (const Index entry : squares_.of(number_of_square(column, row))) {
      Hit hit{};
      if (!weights_at(entry, x, y, hit)) continue;
      double depth = 0, beyond = 0;
      for (std::size_t m = 0; m < 3; ++m) {
        depth += hit.weights[m] * corners_[triangles_[hit.entry][m]].depth;
        beyond += hit.weights[m] * corners_[triangles_[hit.entry][m]].beyond;
      }
      if (!(depth < nearest) || beyond > 0) continue;
      if (is_open(hit, x, y)) continue;
      nearest = depth;
      best = hit;
    }
    if (!std::isfinite(nearest)) return 0;
    const std::size_t code = first_codes_[surface_of(best.entry)] + layer_of(best, x, y);
    return static_cast<std::uint16_t>(code);
  }

 private:
  /// A vertex in the camera: pixel coordinates times w, for weights linear on the surface; its
  /// depth along the viewing direction and its signed distance from the slice.
  struct Corner {
    double x, y, w, depth;
    double beyond;  ///< positive: cut away by the slice
  };
  struct Hit {
    std::size_t entry;
    std::array<double, 3> weights;
    bool from_behind;
  };

  void project(const StyledSurface& surface) {
    const std::size_t first = corners_.size();
    first_entry_.push_back(triangles_.size());
    const Vec3 offset =
        (surface.mesh.origin - surfaces_.front().mesh.origin).cast<float>() - camera_.origin;
    const Eigen::Matrix4d view = camera_.view_from_world.cast<double>();
    const Eigen::Matrix4d clip = camera_.clip_from_view.cast<double>();
    for (const Vec3& position : surface.mesh.positions) {
      const Eigen::Vector4d seen = view * (position + offset).cast<double>().homogeneous();
      const Eigen::Vector4d c = clip * seen;
      const Vec3 place = position + offset + camera_.origin;
      const bool sliced = camera_.slice && surface.sliced;
      const float beyond = sliced ? camera_.slice->signedDistance(place) : -1.0f;
      corners_.push_back({0.5 * width_ * (c.w() + c.x()), 0.5 * height_ * (c.w() - c.y()), c.w(),
                          -seen.z(), static_cast<double>(beyond)});
    }
    for (const Triangle& t : surface.mesh.triangles) {
      triangles_.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }

  /// Calls `visit` with the number of each square that a triangle may cover. NaN and points behind
  /// the camera fail the tests and cover no square.
  template <class Visit>
  void for_squares(std::size_t entry, const Visit& visit) const {
    Eigen::AlignedBox2d box;
    for (const std::size_t v : triangles_[entry]) {
      const Corner& c = corners_[v];
      if (!(c.w > 0)) return;
      box.extend(Eigen::Vector2d(c.x / c.w, c.y / c.w));
    }
    const auto square = [](double pixel, int count) {
      return static_cast<int>(std::clamp(std::floor(pixel / kSquare), 0.0, count - 1.0));
    };
    if (!(box.min().x() <= width_ && box.min().y() <= height_ && box.max().x() >= 0 &&
          box.max().y() >= 0)) {
      return;
    }
    for (int r = square(box.min().y(), rows_); r <= square(box.max().y(), rows_); ++r) {
      for (int c = square(box.min().x(), columns_); c <= square(box.max().x(), columns_); ++c) {
        visit(number_of_square(c, r));
      }
    }
  }

  std::size_t number_of_square(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  void sort_into_squares(const Progress& progress) {
    squares_ = compressed_rows<Index>(
        number_of_square(0, rows_), progress, [&](const Progress& passing, const auto& add) {
          reported_for(triangles_.size(), passing, [&](std::size_t t) {
            for_squares(t, [&](std::size_t square) { add(square, static_cast<Index>(t)); });
          });
        });
  }

  /// Barycentric weights at a point, linear on the surface; false if the triangle does not cover
  /// it.
  bool weights_at(std::size_t entry, double x, double y, Hit& hit) const {
    std::array<double, 3> to_x, to_y;
    for (std::size_t m = 0; m < 3; ++m) {
      const Corner& c = corners_[triangles_[entry][m]];
      to_x[m] = c.x - x * c.w;
      to_y[m] = c.y - y * c.w;
    }
    double sum = 0;
    for (std::size_t m = 0; m < 3; ++m) {
      const std::size_t next = (m + 1) % 3, last = (m + 2) % 3;
      hit.weights[m] = to_x[next] * to_y[last] - to_y[next] * to_x[last];
      sum += hit.weights[m];
    }
    if (!(std::abs(sum) > 0)) return false;
    bool inside = true;
    for (double& weight : hit.weights) {
      weight /= sum;
      inside = inside && weight >= -kEdgeSlack;
    }
    hit.entry = entry;
    hit.from_behind = sum > 0;  // the y axis points down
    return inside;
  }

  SeenPoint point_of(const Hit& hit, double x, double y) const {
    const std::size_t number = surface_of(hit.entry);
    SeenPoint point;
    point.surface = &surfaces_[number];
    point.number = number;
    point.triangle = hit.entry - first_entry_[number];
    const auto rounded = [](const std::array<double, 3>& weights) {
      return Vec3(static_cast<float>(weights[0]), static_cast<float>(weights[1]),
                  static_cast<float>(weights[2]));
    };
    point.barycentric = rounded(hit.weights).cwiseMax(0.0f);
    point.barycentric /= point.barycentric.sum();
    if (!is_measured_on_screen(*point.surface)) return point;
    constexpr std::array<std::array<int, 2>, 4> kWays{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    for (std::size_t i = 0; i < 4; ++i) {
      Hit beside{};
      weights_at(hit.entry, x + 0.5 * kTurnsStep * kWays[i][0], y + 0.5 * kTurnsStep * kWays[i][1],
                 beside);
      point.beside[i] = rounded(beside.weights);
    }
    point.step = static_cast<float>(kTurnsStep);
    return point;
  }

  std::size_t surface_of(std::size_t entry) const {
    const auto after = std::upper_bound(first_entry_.begin(), first_entry_.end(), entry);
    return static_cast<std::size_t>(after - first_entry_.begin()) - 1;
  }

  /// Tests strokes.
  Cover cover_of(const SeenPoint& point, bool from_behind) const {
    if (point.surface->strokes.empty()) return Cover::plain;
    const float tone = follows_tone(*point.surface) ? tone_of(point, from_behind) : 0.0f;
    return cover_at(point, tone);
  }

  /// 0: the plain surface; from 1 on its marks.
  std::uint16_t layer_of(const Hit& hit, double x, double y) const {
    const SeenPoint point = point_of(hit, x, y);
    if (!point.surface->texture) return cover_of(point, hit.from_behind) == Cover::stroke;
    const auto tile = tile_at(point);
    return static_cast<std::uint16_t>(tile ? *tile + 1 : 0);
  }

  /// Whether the surface is transparent there: between strokes or around tiles.
  bool is_open(const Hit& hit, double x, double y) const {
    if (surfaces_[surface_of(hit.entry)].between != BetweenStrokes::discarded) return false;
    const SeenPoint point = point_of(hit, x, y);
    return point.surface->texture ? !tile_at(point)
                                  : cover_of(point, hit.from_behind) == Cover::ground;
  }

  float tone_of(const SeenPoint& point, bool from_behind) const {
    const Mesh& mesh = point.surface->mesh;
    const Triangle& t = mesh.triangles[point.triangle];
    const Vec3& a = mesh.positions[t[0]];
    const Vec3 facet = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a).normalized();
    Vec3 normal = Vec3::Zero();
    Vec3 place = Vec3::Zero();
    for (int m = 0; m < 3; ++m) {
      place += point.barycentric[m] * mesh.positions[t[m]];
      // Vertex normals follow the winding of this triangle, as in surface_point.glsl.
      const Vec3 n = point.surface->normals.empty() ? facet : point.surface->normals[t[m]];
      const Vec3 unit = n.isZero(0) ? facet : n.normalized();
      normal += point.barycentric[m] * (unit.dot(facet) < 0 ? -unit : unit);
    }
    place += (mesh.origin - surfaces_.front().mesh.origin).cast<float>() - camera_.origin;
    const Vec3 seen = (camera_.view_from_world * place.homogeneous()).head<3>();
    const Vec3 turned = camera_.view_from_world.topLeftCorner<3, 3>() * normal.normalized();
    return tone_at(from_behind ? -turned : turned, sight_to(camera_, seen), lights_);
  }

  std::span<const StyledSurface> surfaces_;
  Camera camera_;
  Lights lights_;
  int width_, height_, columns_, rows_;
  std::vector<Corner> corners_;           // of all surfaces
  std::vector<std::size_t> first_entry_;  // of each surface: index of its first triangle among all
  std::vector<std::size_t> first_codes_;  // of each surface
  std::vector<std::array<std::size_t, 3>> triangles_;
  CompressedRows<Index> squares_;  // candidate triangles of each square, ascending
};

}  // namespace

std::size_t mark_count(const StyledSurface& surface) {
  return surface.texture ? surface.texture->tiles.size() : surface.strokes.empty() ? 0 : 1;
}

std::vector<std::size_t> first_codes(std::span<const StyledSurface> surfaces) {
  std::vector<std::size_t> codes{1};
  for (const StyledSurface& surface : surfaces) {
    codes.push_back(codes.back() + 1 + mark_count(surface));
  }
  return codes;
}

CodeAt seen_codes(std::span<const StyledSurface> surfaces, const Camera& camera,
                  const PictureLight& light, int width, int height, const Progress& progress) {
  const auto seen =
      std::make_shared<const SeenSurfaces>(surfaces, camera, light, width, height, progress);
  return [seen](double x, double y) { return seen->code_at(x, y); };
}

}  // namespace brindle
