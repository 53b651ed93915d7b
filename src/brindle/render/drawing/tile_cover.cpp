#include "brindle/render/drawing/tile_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include <Eigen/LU>

#include "brindle/pattern/figure_middle.h"

namespace brindle {
namespace {

using Point = Eigen::Vector2f;

constexpr float kSmallestSize = 1e-3f;
constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

/// Texture coordinates at a point, less the shift of all tiles; nothing without waves.
std::optional<Point> coordinates_at(const RegionTexture& texture, std::size_t triangle,
                                    const Vec3& barycentric) {
  const TextureFragment f =
      texture_fragment(texture.waves->u[triangle], texture.waves->v[triangle], barycentric);
  for (const FragmentWave* wave : {&f.u, &f.v}) {
    if (wave->direction.isZero(0) || wave->z == Complex(0)) return std::nullopt;
  }
  return Point(texture_coordinate(f.u.z), texture_coordinate(f.v.z)) - texture.shift;
}

/// From one point to another nearby.
Point gain(const Point& from, const Point& to) {
  const Point difference = to - from;
  return {difference.x() - std::floor(difference.x() + 0.5f),
          difference.y() - std::floor(difference.y() + 0.5f)};
}

/// Where on the screen the middle of the tile is, from the point, in pixels to the right and down;
/// zero where tiles cannot be told apart.
Point pixels_to_middle(const SeenPoint& point, const RegionTexture& texture, const Point& uv) {
  std::array<Point, 4> beside;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto there = coordinates_at(texture, point.triangle, point.beside[i]);
    if (!there) return Point::Zero();
    beside[i] = *there;
  }
  Eigen::Matrix2f per_pixel;
  per_pixel.col(0) = gain(beside[1], beside[0]) / point.step;
  per_pixel.col(1) = gain(beside[3], beside[2]) / point.step;
  if (std::abs(per_pixel.determinant()) < 1e-12f) return Point::Zero();
  const Point to_middle(std::floor(uv.x()) + 0.5f - uv.x(), std::floor(uv.y()) + 0.5f - uv.y());
  return per_pixel.inverse() * to_middle;
}

/// A value in the middle of the tile, to first order; NaN where a corner has none.
float value_of_tile(const SeenPoint& point, std::span<const float> values, const Point& pixels) {
  const Triangle& t = point.surface->mesh.triangles[point.triangle];
  const Vec3 corners(values[t[0]], values[t[1]], values[t[2]]);
  if (!corners.allFinite()) return kNoValue;
  const Vec3 right = (point.beside[0] - point.beside[1]) / point.step;
  const Vec3 down = (point.beside[2] - point.beside[3]) / point.step;
  return corners.dot(point.barycentric + pixels.x() * right + pixels.y() * down);
}

/// The last tile that begins at this value or below; the first one's beginning does not count.
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

/// `size`: how much of its place the tile fills.
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
  const auto uv = coordinates_at(texture, point.triangle, point.barycentric);
  if (!uv) return std::nullopt;
  Point pixels = Point::Zero();
  if (follows_values(texture)) pixels = pixels_to_middle(point, texture, *uv);
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
