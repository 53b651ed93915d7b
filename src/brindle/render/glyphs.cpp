#include "brindle/glyphs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/memory.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/render/parsed_words.h"

namespace brindle {
namespace {

constexpr float kFullTurn = 2 * std::numbers::pi_v<float>;

constexpr std::size_t kGlyphsPerReport = 1 << 10;

/// The visible share of a tile on a quad; a full tile would show the opposite border.
constexpr float kTileShare = 0.99f;

/// Appends glyphs. Coordinates of a glyph: x along the first direction, y across it, z along the
/// normal.
class GlyphBuilder {
 public:
  bool is_empty() const { return glyphs_.mesh.positions.empty(); }

  /// Reserves memory for so many glyphs like the first one. Throws TooLarge if they do not fit.
  void reserve_for(std::size_t count) {
    const std::size_t vertices = glyphs_.normals.size(), triangles = glyphs_.mesh.triangle_count(),
                      tiles = glyphs_.waves.u.size();
    const std::size_t bytes = vertices * (2 * sizeof(Vec3) + sizeof(Index)) +
                              triangles * sizeof(Triangle) + 2 * tiles * sizeof(CornerWaves);
    check_fits(static_cast<double>(count), static_cast<double>(bytes), "the picture", "glyphs",
               [](double most) { return rounded_down(most) + " would do"; });
    if (count * vertices > std::numeric_limits<Index>::max()) return;  // rejected later
    glyphs_.mesh.positions.reserve(count * vertices);
    glyphs_.normals.reserve(count * vertices);
    glyphs_.sample_of_vertex.reserve(count * vertices);
    glyphs_.mesh.triangles.reserve(count * triangles);
    glyphs_.waves.u.reserve(count * tiles);
    glyphs_.waves.v.reserve(count * tiles);
  }

  void begin(const Sample& sample, Index number) {
    origin_ = sample.position;
    axes_.col(0) = sample.direction_u;
    axes_.col(2) = sample.normal;
    axes_.col(1) = sample.normal.cross(sample.direction_u).normalized();
    number_ = number;
  }

  Index add(const Vec3& place, const Vec3& normal) {
    if (glyphs_.mesh.positions.size() >= std::numeric_limits<Index>::max()) {
      throw Error("there are more glyphs than a mesh can hold");
    }
    glyphs_.mesh.positions.push_back(origin_ + axes_ * place);
    glyphs_.normals.push_back((axes_ * normal).normalized());
    glyphs_.sample_of_vertex.push_back(number_);
    return static_cast<Index>(glyphs_.mesh.positions.size() - 1);
  }
  void add_triangle(Index a, Index b, Index c) { glyphs_.mesh.triangles.push_back({a, b, c}); }

  /// A triangle of a quad that a tile fills, whose lower left corner is vertex `corner`.
  void add_tile_triangle(Index corner, const GlyphSize& size,
                         const std::array<Index, 3>& vertices) {
    const auto waves = [&](int axis, float side) {
      const Vec3 direction = axes_.col(axis);
      const float frequency = kTileShare / side;
      CornerWaves corners;
      for (std::size_t m = 0; m < 3; ++m) {
        const Vec3 position = glyphs_.mesh.positions[vertices[m]];
        const float way = (position - glyphs_.mesh.positions[corner]).dot(direction);
        // Texture coordinates are the phase over 2 pi plus a quarter.
        const float turns = 0.5f * (1 - kTileShare) + way * frequency - 0.25f;
        corners[m] = {{position, direction, frequency}, elementary::polar(1.0f, kFullTurn * turns)};
      }
      return corners;
    };
    add_triangle(vertices[0], vertices[1], vertices[2]);
    glyphs_.waves.u.push_back(waves(0, size.along));
    glyphs_.waves.v.push_back(waves(1, size.across));
  }

  /// A reproducible pseudo-random number from 0 to 1.
  float chance(Index which) const {
    std::uint32_t x = number_ * 0x9e3779b9u + which * 0x85ebca6bu;
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return static_cast<float>((x ^ (x >> 16)) >> 8) / 16777216.0f;
  }

  Glyphs take() { return std::move(glyphs_); }

 private:
  Glyphs glyphs_;
  Vec3 origin_;
  Eigen::Matrix3f axes_;
  Index number_ = 0;
};

void add_disc(GlyphBuilder& builder, const GlyphSize& size) {
  constexpr int kCorners = 24;
  const float lift = 0.06f * std::min(size.along, size.across);
  for (const float side : {-1.0f, 1.0f}) {
    const Vec3 normal(0, 0, side);
    const Index middle = builder.add({0, 0, side * lift}, normal);
    for (int k = 0; k < kCorners; ++k) {
      const float angle = kFullTurn * static_cast<float>(k) / kCorners;
      builder.add({0.5f * size.along * elementary::cos(angle),
                   0.5f * size.across * elementary::sin(angle), side * lift},
                  normal);
    }
    for (Index k = 0; k < kCorners; ++k) {
      builder.add_triangle(middle, middle + 1 + k, middle + 1 + (k + 1) % kCorners);
    }
  }
}

/// A ring of vertices around the x axis at `height`.
struct Ring {
  float x, radius;
  float slope;  // of the normal along x
};

void add_turned(GlyphBuilder& builder, std::span<const Ring> rings, float height) {
  constexpr int kSides = 14;
  Index last = 0;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    Index first = 0;
    for (int k = 0; k < kSides; ++k) {
      const float angle = kFullTurn * static_cast<float>(k) / kSides;
      const Vec3 out(0, elementary::cos(angle), elementary::sin(angle));
      const Index v = builder.add(rings[r].radius * out + Vec3(rings[r].x, 0, height),
                                  out + Vec3(rings[r].slope, 0, 0));
      if (k == 0) first = v;
    }
    for (Index k = 0; r > 0 && k < kSides; ++k) {
      const Index next = (k + 1) % kSides;
      builder.add_triangle(last + k, last + next, first + k);
      builder.add_triangle(first + k, last + next, first + next);
    }
    last = first;
  }
}

/// A shaft and a head, as long as the glyph.
void add_arrow(GlyphBuilder& builder, const GlyphSize& size) {
  const float length = size.along;
  const float head = 0.42f * length;
  const float thick = 0.19f * length, thin = 0.075f * length;
  const float steep = thick / head;
  const Ring rings[] = {{-0.5f * length, 0, -1e3f},
                        {-0.5f * length, thin, -1e3f},
                        {-0.5f * length, thin, 0},
                        {0.5f * length - head, thin, 0},
                        {0.5f * length - head, thin, -1e3f},
                        {0.5f * length - head, thick, -1e3f},
                        {0.5f * length - head, thick, steep},
                        {0.5f * length, 0, steep}};
  add_turned(builder, rings, thick);
}

void add_ellipse(GlyphBuilder& builder, const GlyphSize& size) {
  constexpr int kAround = 28, kRings = 7;
  const Vec3 radii(0.5f * size.along, 0.5f * size.across,
                   0.16f * std::min(size.along, size.across));
  Index last = 0;
  for (int r = 0; r <= kRings; ++r) {
    // From the rim, which lies on the surface, to the top.
    const float up = 0.25f * kFullTurn * static_cast<float>(r) / kRings;
    Index first = 0;
    for (int k = 0; k < kAround; ++k) {
      const float angle = kFullTurn * static_cast<float>(k) / kAround;
      const Vec3 out(elementary::cos(up) * elementary::cos(angle),
                     elementary::cos(up) * elementary::sin(angle), elementary::sin(up));
      const Index v = builder.add(out.cwiseProduct(radii), out.cwiseQuotient(radii));
      if (k == 0) first = v;
    }
    for (Index k = 0; r > 0 && k < kAround; ++k) {
      const Index next = (k + 1) % kAround;
      builder.add_triangle(last + k, last + next, first + next);
      builder.add_triangle(last + k, first + next, first + k);
    }
    last = first;
  }
}

/// Parallel bristles with pointed ends.
void add_stroke(GlyphBuilder& builder, const GlyphSize& size) {
  constexpr int kBristles = 4, kSteps = 14;
  const float length = 1.5f * size.across, width = 0.36f * size.along;
  const float lift = 0.04f * std::min(size.along, size.across);
  for (int bristle = 0; bristle < kBristles; ++bristle) {
    const auto which = static_cast<Index>(4 * bristle);
    const float begin = -0.5f + 0.22f * builder.chance(which);
    const float end = 0.5f - 0.22f * builder.chance(which + 1);
    const float middle = ((static_cast<float>(bristle) + 0.5f) / kBristles - 0.5f) * width +
                         0.05f * width * (builder.chance(which + 2) - 0.5f);
    const float half = (0.36f + 0.28f * builder.chance(which + 3)) * width / kBristles;
    Index last = 0;
    for (int step = 0; step <= kSteps; ++step) {
      const float t = static_cast<float>(step) / kSteps;
      // Full width soon, then a long taper.
      const float thick = half * std::min(1.0f, 6 * t) * std::sqrt(std::max(1 - t * t, 0.0f));
      const float y = length * (begin + t * (end - begin));
      const float bow = 0.06f * length * (4 * t * (1 - t) - 0.5f);
      const Index v = builder.add({middle + bow - thick, y, lift}, Vec3::UnitZ());
      builder.add({middle + bow + thick, y, lift}, Vec3::UnitZ());
      if (step > 0) {
        builder.add_triangle(last, last + 1, v);
        builder.add_triangle(v, last + 1, v + 1);
      }
      last = v;
    }
  }
}

/// Two-sided. Overlapping neighbours get different heights.
void add_quad(GlyphBuilder& builder, const GlyphSize& size) {
  const float lift = (0.03f + 0.03f * builder.chance(0)) * std::min(size.along, size.across);
  for (const float side : {-1.0f, 1.0f}) {
    const auto corner = [&](float x, float y) {
      return builder.add({x * size.along, y * size.across, side * lift}, Vec3(0, 0, side));
    };
    const Index first = corner(-0.5f, -0.5f);
    corner(0.5f, -0.5f), corner(0.5f, 0.5f), corner(-0.5f, 0.5f);
    builder.add_tile_triangle(first, size, {first, first + 1, first + 2});
    builder.add_tile_triangle(first, size, {first, first + 2, first + 3});
  }
}

bool is_drawn(const GlyphSize& size) { return size.along > 0 && size.across > 0; }

void add_glyph(GlyphBuilder& builder, GlyphShape shape, const GlyphSize& size) {
  switch (shape) {
    case GlyphShape::disc:
      return add_disc(builder, size);
    case GlyphShape::arrow:
      return add_arrow(builder, size);
    case GlyphShape::ellipse:
      return add_ellipse(builder, size);
    case GlyphShape::stroke:
      return add_stroke(builder, size);
    case GlyphShape::quad:
      return add_quad(builder, size);
  }
}

}  // namespace

std::optional<GlyphShape> parse_glyph_shape(std::string_view name) {
  if (name == "disc") return GlyphShape::disc;
  if (name == "arrow") return GlyphShape::arrow;
  if (name == "ellipse") return GlyphShape::ellipse;
  if (name == "stroke") return GlyphShape::stroke;
  return std::nullopt;
}

std::vector<GlyphSize> glyph_sizes(std::span<const Sample> samples, float share,
                                   std::span<const float> factors) {
  if (!factors.empty() && factors.size() != samples.size()) {
    throw Error("there are " + std::to_string(factors.size()) + " sizes for " +
                std::to_string(samples.size()) + " glyphs");
  }
  std::vector<GlyphSize> sizes;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float size = share * (factors.empty() ? 1.0f : factors[i]);
    sizes.push_back({size * samples[i].spacing_u, size * samples[i].spacing_v});
  }
  return sizes;
}

Glyphs glyphs_at(std::span<const Sample> samples, GlyphShape shape,
                 std::span<const GlyphSize> sizes, const Progress& heard) {
  if (sizes.size() != samples.size()) {
    throw Error("there are " + std::to_string(sizes.size()) + " sizes for " +
                std::to_string(samples.size()) + " glyphs");
  }
  const auto count = static_cast<std::size_t>(ranges::count_if(sizes, is_drawn));
  GlyphBuilder builder;
  JobStages stages(heard, {{"glyphs", 1}});
  const Progress progress = stages.begin("glyphs");
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i % kGlyphsPerReport == 0) {
      progress.report(static_cast<double>(i) / static_cast<double>(samples.size()));
    }
    if (!is_drawn(sizes[i])) continue;
    const bool is_first = builder.is_empty();
    builder.begin(samples[i], static_cast<Index>(i));
    add_glyph(builder, shape, sizes[i]);
    if (is_first) builder.reserve_for(count);
  }
  stages.finish();
  return builder.take();
}

}  // namespace brindle
