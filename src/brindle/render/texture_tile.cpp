#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "brindle/base/elementary.h"
#include "brindle/pattern/motif_centre.h"
#include "brindle/render/parsed_words.h"
#include "brindle/render/surface_light.h"
#include "brindle/renderer.h"

namespace brindle {
namespace {

using Point = Eigen::Vector2f;

// In tile sides.
constexpr float kDotRadius = 0.29f;
constexpr float kSignLength = 0.25f, kSignWidth = 0.07f;  // half of each
constexpr float kSmallSign = 0.75f;                       // in tiles with two

/// From -1/2 to 1/2.
float wrapped(float x) { return x - std::round(x); }

Point wrapped(const Point& p) { return {wrapped(p.x()), wrapped(p.y())}; }

float box(const Point& p, const Point& half) {
  const Point d = p.cwiseAbs() - half;
  return d.cwiseMax(0.0f).norm() + std::min(d.maxCoeff(), 0.0f);
}

/// A stroke with round caps.
float stroke(const Point& p, const Point& from, const Point& to, float radius) {
  const Point along = to - from;
  const float t = std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0f, 1.0f);
  return (p - from - t * along).norm() - radius;
}

/// A triangle that points along u, symmetric about the u axis.
float arrow_head(Point p, float base, float tip, float half_width) {
  p.y() = std::abs(p.y());
  const Point corner(base, half_width);
  const Point slope = Point(tip, 0) - corner;
  const Point outward = Point(-slope.y(), slope.x()).normalized();
  const float beyond_slope = (p - corner).dot(outward);
  const float inside = std::max(beyond_slope, base - p.x());
  if (inside < 0) return inside;
  const float to_slope = stroke(p, corner, Point(tip, 0), 0);
  const float to_base = stroke(p, Point(base, 0), corner, 0);
  return std::min(to_slope, to_base);
}

float lone_arrow(const Point& p) {
  return std::min(box(p + Point(0.14f, 0), {0.26f, 0.065f}), arrow_head(p, 0.06f, 0.42f, 0.21f));
}

/// An arrow's tip meets the next one's tail.
float arrow(const Point& p) {
  return std::min({lone_arrow(p), lone_arrow(p + Point(1, 0)), lone_arrow(p - Point(1, 0))});
}

float stripes(const Point& p) { return std::abs(p.x()) - 0.25f; }

float dots(const Point& p) { return p.norm() - kDotRadius; }

float checker(const Point& p) {
  const float to_u = 0.25f - std::abs(p.x());
  const float to_v = 0.25f - std::abs(p.y());
  const float distance = std::min(std::abs(to_u), std::abs(to_v));
  return (to_u < 0) == (to_v < 0) ? -distance : distance;
}

/// One course has a brick in its middle, the other a joint. The rows map to themselves under half a
/// turn about the middle.
float bricks(const Point& p) {
  constexpr float kRound = 0.03f;
  const Point half(0.5f - kHalfJoint - kRound, 0.25f - kHalfJoint - kRound);
  const float middle_course = box(wrapped(p - Point(0, 0.5f)), half);
  const float other_course = box(wrapped(p - Point(0.5f, 0)), half);
  return std::min(middle_course, other_course) - kRound;
}

/// Each stroke has copies before and after it, and its image under half a turn is a stroke.
float hatch(const Point& place) {
  constexpr float kRadius = 0.03f;
  float distance = 1;
  for (const float turn : {1.0f, -1.0f}) {
    for (const bool crossing : {false, true}) {
      const Point from = turn * (crossing ? Point(-0.22f, -0.40f) : Point(-0.40f, -0.28f));
      const Point to = turn * (crossing ? Point(-0.28f, 0.40f) : Point(0.40f, -0.22f));
      const Point p = wrapped(place - 0.5f * (from + to));
      const Point half = 0.5f * (to - from);
      const Point next = crossing ? Point(0, 1) : Point(1, 0);
      for (const float copy : {-1.0f, 0.0f, 1.0f}) {
        distance = std::min(distance, stroke(p + copy * next, -half, half, kRadius));
      }
    }
  }
  return distance;
}

float minus_sign(const Point& p) { return box(p, {kSignLength, kSignWidth}); }

float plus_sign(const Point& p) { return std::min(minus_sign(p), minus_sign({p.y(), p.x()})); }

/// Smaller signs, because the tile has both.
float plus_and_minus(const Point& p) {
  return kSmallSign * std::min(plus_sign(p / kSmallSign),
                               minus_sign(wrapped(p + Point(0.5f, 0.5f)) / kSmallSign));
}

/// Diamonds around the middle and the corners.
float knurl(const Point& p) {
  const float to_side = std::abs(p.x()) + std::abs(p.y()) - 0.5f;
  return std::abs(to_side) * -0.70710678f + kHalfJoint;
}

float knurl_height(const Point& p) {
  return 2 * std::abs(std::abs(p.x()) + std::abs(p.y()) - 0.5f);
}

constexpr float kHalfStrand = 0.21f;

/// The parts of strands that lie above others.
float weave(const Point& p) {
  const Point half(0.25f - kHalfJoint, kHalfStrand), turned(half.y(), half.x());
  const auto at = [&](float u, float v) { return wrapped(p - Point(u, v)); };
  return std::min({box(at(-0.25f, -0.25f), half), box(at(0.25f, 0.25f), half),
                   box(at(-0.25f, 0.25f), turned), box(at(0.25f, -0.25f), turned)});
}

float weave_height(const Point& p) {
  const auto strand = [](float across, float along, float phase) {
    const float share = across / kHalfStrand;
    const float above = 0.6f + 0.4f * elementary::cos(kTwoPi * (along - phase));
    return std::max(0.0f, 1 - share * share) * above;
  };
  float height = 0;
  for (const float row : {-0.25f, 0.25f}) {
    height = std::max({height, strand(wrapped(p.y() - row), p.x(), row),
                       strand(wrapped(p.x() - row), p.y(), -row)});
  }
  return height;
}

constexpr float kScaleRadius = 0.45f;

/// The centre of scale `row`: rows are half a tile apart, and odd ones are shifted by half a scale.
Point scale_centre(int row, float v) {
  const float shift = row % 2 == 0 ? 0.0f : 0.5f;
  return {0.5f * static_cast<float>(row) - 0.5f, std::round(v - shift) + shift};
}

/// A row lies above the next one along U, of whose scales it shows the tips alone.
float scales(const Point& p) {
  float distance = 1;
  for (int row = -3; row <= 3; ++row) {
    float here = (p - scale_centre(row, p.y())).norm() - kScaleRadius;
    for (int above = row - 2; above < row; ++above) {
      here = std::max(here, kScaleRadius - (p - scale_centre(above, p.y())).norm());
    }
    distance = std::min(distance, here);
  }
  return distance + 0.5f * kHalfJoint;
}

/// Scales rise towards their tips.
float scales_height(const Point& p) {
  float height = 0;
  for (int row = -3; row <= 3; ++row) {
    const Point away = p - scale_centre(row, p.y());
    const float rise = std::clamp(0.5f + away.x(), 0.0f, 1.0f) / (0.5f + kScaleRadius);
    const float inside = std::clamp((kScaleRadius - away.norm()) / kFlank, 0.0f, 1.0f);
    height = std::max(height, rise * inside);
  }
  return height;
}

/// The grey value of a picture, interpolated between the middles of pixels.
float grey_at(const Image& picture, float u, float v) {
  const auto grey = [&](int x, int y) {
    const auto wrap = [](int i, int n) { return (i % n + n) % n; };
    const Pixel& p = picture.at(wrap(x, picture.width), wrap(y, picture.height));
    const float shade = 0.2126f * static_cast<float>(p.red) +
                        0.7152f * static_cast<float>(p.green) +
                        0.0722f * static_cast<float>(p.blue);
    return shade * static_cast<float>(p.alpha) / (255.0f * 255.0f);
  };
  const float x = (u - std::floor(u)) * static_cast<float>(picture.width) - 0.5f;
  const float y = (1 - v + std::floor(v)) * static_cast<float>(picture.height) - 0.5f;
  const float left = std::floor(x), top = std::floor(y);
  const float right = x - left, below = y - top;
  const int i = static_cast<int>(left), j = static_cast<int>(top);
  return (1 - below) * ((1 - right) * grey(i, j) + right * grey(i + 1, j)) +
         below * ((1 - right) * grey(i, j + 1) + right * grey(i + 1, j + 1));
}

using Covered = Eigen::AlignedBox2f;

// Symmetries of a tile, as in TileMotifs.
constexpr std::uint8_t kAsItIs = 1 << 0;
constexpr std::uint8_t kMirroredAlongV = 1 << kTurnsV;
constexpr std::uint8_t kHalfTurn = 1 << (kTurnsU | kTurnsV);
constexpr std::uint8_t kOfRectangle = 0x0f;
constexpr std::uint8_t kOfSquare = 0xff;

Covered covering(float half_u, float half_v) {
  return {Point(-half_u, -half_v), Point(half_u, half_v)};
}

TileMotifs single_motif(const Covered& covered, std::uint8_t symmetries) {
  return {TileLayout::single, {covered, covered}, symmetries};
}

/// The extent of opaque pixels from the middle.
Covered opaque_part(const Image& picture) {
  Covered covered;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (picture.at(x, y).alpha == 0) continue;
      const Point corner(static_cast<float>(x), static_cast<float>(picture.height - 1 - y));
      covered.extend(corner);
      covered.extend(Point(corner + Point(1, 1)));
    }
  }
  if (covered.isEmpty()) return TileMotifs::whole_tile();
  const Point scale(1 / static_cast<float>(picture.width), 1 / static_cast<float>(picture.height));
  const Point half(0.5f, 0.5f);
  return {Point(covered.min().cwiseProduct(scale) - half),
          Point(covered.max().cwiseProduct(scale) - half)};
}

bool is_transparent_round(const Image& picture) {
  const auto seen = [&](int x, int y) { return picture.at(x, y).alpha != 0; };
  for (int x = 0; x < picture.width; ++x) {
    if (seen(x, 0) || seen(x, picture.height - 1)) return false;
  }
  for (int y = 0; y < picture.height; ++y) {
    if (seen(0, y) || seen(picture.width - 1, y)) return false;
  }
  return true;
}

/// A built-in tile. Functions take the way from the tile's middle, from -1/2 to 1/2 along each
/// axis; `hatch` takes any and wraps each stroke.
struct TileRow {
  std::string_view name;
  float (*distance)(const Point& p);
  TileMotifs motifs;
  bool has_own_shape = true;
  float (*height)(const Point& p) = nullptr;  ///< null: plateaus with steep flanks
};

/// In the order of BuiltInTile.
std::array<TileRow, 12> make_tile_rows() {
  const Covered whole = TileMotifs::whole_tile();
  const Covered plus = covering(kSignLength, kSignLength);
  const Covered minus = covering(kSignLength, kSignWidth);
  const Covered small_plus = covering(kSmallSign * kSignLength, kSmallSign * kSignLength);
  const Covered small_minus = covering(kSmallSign * kSignLength, kSmallSign * kSignWidth);
  const Covered arrow_part(Point(-0.40f, -0.21f), Point(0.42f, 0.21f));
  // Bricks own half of each joint. A joint that ends in a tile continues.
  const Covered brick = covering(0.5f, 0.25f);
  constexpr auto kTwo = TileLayout::middle_and_corner;
  return {{
      {"stripes", stripes, single_motif(whole, kOfRectangle), false},
      {"checker", checker, single_motif(whole, kOfSquare), false},
      {"dots", dots, single_motif(covering(kDotRadius, kDotRadius), kOfSquare)},
      {"arrows", arrow, single_motif(arrow_part, kAsItIs | kMirroredAlongV)},
      {"bricks", bricks, {TileLayout::courses, {brick, brick}, kOfRectangle, Point(0, 0), true}},
      {"hatch", hatch, single_motif(whole, kAsItIs | kHalfTurn), false},
      {"plus", plus_sign, single_motif(plus, kOfSquare)},
      {"minus", minus_sign, single_motif(minus, kOfRectangle)},
      {"plusminus", plus_and_minus, {kTwo, {small_plus, small_minus}, kOfRectangle}},
      {"knurl", knurl, {kTwo, {whole, whole}, kOfSquare}, true, knurl_height},
      {"weave", weave, single_motif(whole, kAsItIs | kHalfTurn), false, weave_height},
      {"scales", scales, single_motif(whole, kAsItIs | kMirroredAlongV), false, scales_height},
  }};
}

const std::array<TileRow, 12>& tile_rows() {
  static const std::array<TileRow, 12> rows = make_tile_rows();
  return rows;
}

const TileRow& row_of(BuiltInTile tile) { return tile_rows()[static_cast<std::size_t>(tile)]; }

Pixel opaque_pixel(const Vec3& light) { return pixel_of({light.x(), light.y(), light.z(), 1}); }

Image halved(const Image& image) {
  Image half(std::max(1, image.width / 2), std::max(1, image.height / 2));
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      Eigen::Vector4f sum = Eigen::Vector4f::Zero();
      for (int i = 0; i < 4; ++i) {
        sum += premultiplied_light(image.at(std::min(2 * x + i % 2, image.width - 1),
                                            std::min(2 * y + i / 2, image.height - 1)));
      }
      half.at(x, y) = pixel_of(sum / 4);
    }
  }
  return half;
}

Image motif_picture(BuiltInTile tile, int side, const Vec3& motif, const Vec3& ground) {
  Image image(side, side);
  const auto pixels = static_cast<float>(side);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const float u = (static_cast<float>(x) + 0.5f) / pixels;
      const float v = 1 - (static_cast<float>(y) + 0.5f) / pixels;
      const float coverage = std::clamp(0.5f - pixels * tile_distance(tile, u, v), 0.0f, 1.0f);
      image.at(x, y) = opaque_pixel(ground + coverage * (motif - ground));
    }
  }
  return image;
}

Image over(Image picture, const Vec3& ground) {
  for (Pixel& pixel : picture.pixels) {
    if (pixel.alpha == 255) continue;
    const Eigen::Vector4f light = premultiplied_light(pixel);
    pixel = opaque_pixel(light.head<3>() + (1 - light.w()) * ground);
  }
  return picture;
}

}  // namespace

std::optional<BuiltInTile> parse_built_in_tile(std::string_view name) {
  const auto row = ranges::find(tile_rows(), name, &TileRow::name);
  if (row == tile_rows().end()) return std::nullopt;
  return static_cast<BuiltInTile>(row - tile_rows().begin());
}

std::string_view built_in_tile_names() {
  static const std::string names = [] {
    std::string all;
    for (const TileRow& row : tile_rows()) {
      if (!all.empty()) all += '|';
      all += row.name;
    }
    return all;
  }();
  return names;
}

float tile_distance(BuiltInTile tile, float u, float v) {
  const Point place(u - 0.5f, v - 0.5f);
  return row_of(tile).distance(tile == BuiltInTile::hatch ? place : wrapped(place));
}

float tile_height(const TextureTile& tile, float u, float v) {
  if (const auto* picture = std::get_if<Image>(&tile)) return grey_at(*picture, u, v);
  const auto built_in = std::get<BuiltInTile>(tile);
  const TileRow& row = row_of(built_in);
  if (row.height != nullptr) return row.height(wrapped(Point(u - 0.5f, v - 0.5f)));
  return std::clamp(-tile_distance(built_in, u, v) / kFlank, 0.0f, 1.0f);
}

float tile_detail(const TextureTile& tile) {
  const auto* picture = std::get_if<Image>(&tile);
  if (picture == nullptr) return 0.5f * kFlank;
  return std::clamp(1 / static_cast<float>(std::max(picture->width, picture->height)), 1.0f / 256,
                    0.25f);
}

TileMotifs tile_motifs(const TextureTile& tile) {
  if (const auto* picture = std::get_if<Image>(&tile)) {
    return single_motif(opaque_part(*picture), kAsItIs);
  }
  return row_of(std::get<BuiltInTile>(tile)).motifs;
}

TileMotifs motifs_within(const TileMotifs& motifs, float size, const Eigen::Vector2f& shift) {
  TileMotifs within = motifs;
  within.shift = shift;
  if (size >= 1) return within;
  const bool single = motifs.layout == TileLayout::single;
  const Covered& covered = single ? motifs.extents[0] : TileMotifs::whole_tile();
  within.layout = TileLayout::single;
  within.split = false;
  within.extents.fill({Point(size * covered.min()), Point(size * covered.max())});
  return within;
}

bool has_own_shape(const TextureTile& tile) {
  if (const auto* picture = std::get_if<Image>(&tile)) return is_transparent_round(*picture);
  return row_of(std::get<BuiltInTile>(tile)).has_own_shape;
}

Image tile_picture(const TextureTile& tile, int side, const Color& motif, const Color& ground) {
  const Vec3 ground_light = linear_light(ground);
  if (const auto* picture = std::get_if<Image>(&tile)) return over(*picture, ground_light);
  return motif_picture(std::get<BuiltInTile>(tile), side, linear_light(motif), ground_light);
}

Eigen::Vector4f premultiplied_light(const Pixel& pixel) {
  const float alpha = static_cast<float>(pixel.alpha) / 255;
  const Vec3 light =
      linear_light({static_cast<float>(pixel.red) / 255, static_cast<float>(pixel.green) / 255,
                    static_cast<float>(pixel.blue) / 255});
  return {alpha * light.x(), alpha * light.y(), alpha * light.z(), alpha};
}

Image reduced(Image image, int longest) {
  while (std::max(image.width, image.height) > longest) image = halved(image);
  return image;
}

}  // namespace brindle
