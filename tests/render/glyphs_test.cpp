#include "brindle/glyphs.h"

#include <limits>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/base/memory.h"
#include "brindle/error.h"
#include "brindle/render/parsed_words.h"
#include "progress_reports.h"

namespace brindle {
namespace {

Sample sample_at(const Vec3& position, float spacing_u, float spacing_v) {
  Sample sample;
  sample.position = position;
  sample.normal = Vec3::UnitZ();
  sample.direction_u = Vec3::UnitX();
  sample.direction_v = Vec3::UnitY();
  sample.spacing_u = spacing_u;
  sample.spacing_v = spacing_v;
  return sample;
}

BoundingBox box_of(const Glyphs& glyphs, Index sample) {
  Mesh part;
  for (std::size_t v = 0; v < glyphs.mesh.vertex_count(); ++v) {
    if (glyphs.sample_of_vertex[v] == sample) part.positions.push_back(glyphs.mesh.positions[v]);
  }
  return bounding_box(part);
}

constexpr GlyphShape kShapes[] = {GlyphShape::disc, GlyphShape::arrow, GlyphShape::ellipse,
                                  GlyphShape::stroke, GlyphShape::quad};

TEST(Glyphs, SizesAreProportional) {
  const std::vector<Sample> samples{sample_at({0, 0, 0}, 1, 1), sample_at({5, 0, 0}, 1, 1),
                                    sample_at({9, 2, 1}, 1, 1)};
  const std::vector<float> factors{0.25f, 0.5f, 1};
  for (const GlyphShape shape : {GlyphShape::disc, GlyphShape::arrow, GlyphShape::ellipse}) {
    const Glyphs glyphs = glyphs_at(samples, shape, glyph_sizes(samples, 0.8f, factors));
    const Vec3 largest = box_of(glyphs, 2).upper - box_of(glyphs, 2).lower;
    for (Index i = 0; i < 3; ++i) {
      const Vec3 extent = box_of(glyphs, i).upper - box_of(glyphs, i).lower;
      EXPECT_TRUE(extent.isApprox(factors[i] * largest, 1e-4f)) << i;
    }
    EXPECT_NEAR(largest.x(), 0.8f, 1e-5f);
  }
}

TEST(Glyphs, EllipsesHaveTheAxesOfTheSpacings) {
  const std::vector<Sample> samples{sample_at({1, 2, 3}, 2, 0.5f)};
  const Glyphs glyphs = glyphs_at(samples, GlyphShape::ellipse, glyph_sizes(samples, 1));
  const Vec3 extent = box_of(glyphs, 0).upper - box_of(glyphs, 0).lower;
  EXPECT_NEAR(extent.x(), 2, 1e-5f);
  EXPECT_NEAR(extent.y(), 0.5f, 1e-5f);
  EXPECT_NEAR(box_of(glyphs, 0).center().x(), 1, 1e-5f);
}

TEST(Glyphs, OneTileFillsAQuad) {
  const Sample sample = sample_at({3, -1, 2}, 2, 0.5f);
  const Glyphs quads =
      glyphs_at(std::span(&sample, 1), GlyphShape::quad, glyph_sizes(std::span(&sample, 1), 1));
  ASSERT_EQ(quads.waves.triangle_count(), quads.mesh.triangle_count());
  const Vec3 across = sample.normal.cross(sample.direction_u);
  for (std::size_t t = 0; t < quads.mesh.triangle_count(); ++t) {
    EXPECT_TRUE(is_oriented(quads.waves, t));
    for (const Vec3& b : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0.2f, 0.3f, 0.5f)}) {
      Vec3 p = Vec3::Zero();
      for (int m = 0; m < 3; ++m) p += b[m] * quads.mesh.positions[quads.mesh.triangles[t][m]];
      const TextureFragment f = texture_fragment(quads.waves.u[t], quads.waves.v[t], b);
      const auto in_tile = [](Complex z) {
        const float u = texture_coordinate(z);
        return u < 0 ? u + 1 : u;
      };
      EXPECT_NEAR(in_tile(f.u.z), 0.5f + 0.99f * (p - sample.position).dot(sample.direction_u) / 2,
                  1e-4f);
      EXPECT_NEAR(in_tile(f.v.z), 0.5f + 0.99f * (p - sample.position).dot(across) / 0.5f, 1e-4f);
    }
  }
}

TEST(Glyphs, ArrowsPointAlongTheFirstDirection) {
  Sample sample = sample_at({0, 0, 0}, 1, 1);
  sample.direction_u = Vec3(0, -1, 0);
  const std::vector<Sample> samples{sample};
  const Glyphs glyphs = glyphs_at(samples, GlyphShape::arrow, glyph_sizes(samples, 1));
  // The tip is alone at its end.
  int at_tip = 0, thick = 0;
  for (const Vec3& p : glyphs.mesh.positions) {
    at_tip += p.y() < -0.499f ? 1 : 0;
    thick += std::abs(p.x()) > 0.1f ? 1 : 0;
    if (std::abs(p.x()) > 0.1f) {
      EXPECT_LT(p.y(), 0);
    }
  }
  EXPECT_GT(at_tip, 0);
  EXPECT_GT(thick, 0);
}

TEST(Glyphs, NormalsAreUnitAndTrianglesInRange) {
  const std::vector<Sample> samples{sample_at({0, 0, 0}, 1, 2), sample_at({3, 0, 0}, 2, 1)};
  for (const GlyphShape shape : kShapes) {
    const Glyphs glyphs = glyphs_at(samples, shape, glyph_sizes(samples, 0.7f));
    ASSERT_EQ(glyphs.normals.size(), glyphs.mesh.vertex_count());
    ASSERT_EQ(glyphs.sample_of_vertex.size(), glyphs.mesh.vertex_count());
    for (const Vec3& normal : glyphs.normals) EXPECT_NEAR(normal.norm(), 1, 1e-5f);
    for (const Triangle& t : glyphs.mesh.triangles) {
      for (const Index corner : t) EXPECT_LT(corner, glyphs.mesh.vertex_count());
    }
  }
}

TEST(Glyphs, WithoutASizeThereIsNone) {
  const std::vector<Sample> samples{sample_at({0, 0, 0}, 1, 1), sample_at({3, 0, 0}, 1, 1)};
  const std::vector<float> factors{std::numeric_limits<float>::quiet_NaN(), 0};
  for (const GlyphShape shape : kShapes) {
    EXPECT_TRUE(
        glyphs_at(samples, shape, glyph_sizes(samples, 0.8f, factors)).mesh.positions.empty());
  }
  EXPECT_THROW(glyphs_at(samples, GlyphShape::disc, {}), Error);
  EXPECT_THROW(glyph_sizes(samples, 1, std::vector<float>(3, 1.0f)), Error);
}

TEST(Glyphs, MoreThanMemoryHoldsAreRefusedBeforeOneIsMade) {
  const std::vector<Sample> samples(200'000, sample_at({0, 0, 0}, 1, 1));
  const std::vector<GlyphSize> sizes = glyph_sizes(samples, 0.5f);
  const AssumedMemory little(100e6);
  try {
    glyphs_at(samples, GlyphShape::ellipse, sizes);
    FAIL();
  } catch (const TooLarge& error) {
    // 224 vertices of 28 bytes and 392 triangles of 12 are 11 kB a glyph.
    EXPECT_NEAR(error.share(), 0.6 * 0.5 * 100e6 / (200e3 * (224 * 28 + 392 * 12)), 1e-3);
    EXPECT_NE(std::string(error.what()).find("would be 2e+05 glyphs"), std::string::npos)
        << error.what();
  }
  const std::vector<GlyphSize> none(samples.size());
  EXPECT_TRUE(glyphs_at(samples, GlyphShape::ellipse, none).mesh.positions.empty());
}

TEST(Glyphs, AreAsManyAsRoomIsMadeFor) {
  const std::vector<Sample> samples{sample_at({0, 0, 0}, 1, 1), sample_at({3, 0, 0}, 1, 1)};
  for (const GlyphShape shape : kShapes) {
    const Glyphs glyphs = glyphs_at(samples, shape, glyph_sizes(samples, 0.7f));
    EXPECT_EQ(glyphs.mesh.positions.capacity(), glyphs.mesh.positions.size());
    EXPECT_EQ(glyphs.mesh.triangles.capacity(), glyphs.mesh.triangles.size());
  }
}

TEST(Glyphs, CanBeCancelledAtEveryReport) {
  const std::vector<Sample> samples(5000, sample_at({0, 0, 0}, 1, 1));
  const std::vector<GlyphSize> sizes = glyph_sizes(samples, 0.5f);
  testing_support::Reports all;
  glyphs_at(samples, GlyphShape::disc, sizes, all.progress());
  EXPECT_GE(all.count(), 6);
  for (int report = 0; report < all.count(); ++report) {
    testing_support::Reports reports(report);
    EXPECT_THROW(glyphs_at(samples, GlyphShape::disc, sizes, reports.progress()), Cancelled);
  }
}

TEST(Glyphs, NamesAreReadBack) {
  EXPECT_EQ(parse_glyph_shape("arrow"), GlyphShape::arrow);
  EXPECT_EQ(parse_glyph_shape("stroke"), GlyphShape::stroke);
  EXPECT_FALSE(parse_glyph_shape("cube"));
}

}  // namespace
}  // namespace brindle
