/// What a program that embeds the library does, with its public headers alone.
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/brindle.h"

namespace brindle {
namespace {

/// A bumpy square of so many vertices along a side, in another program's arrays.
struct Arrays {
  std::vector<double> points;
  std::vector<std::int64_t> triangles;

  explicit Arrays(int side, double height = 0.1) {
    for (int j = 0; j < side; ++j) {
      for (int i = 0; i < side; ++i) {
        const double x = static_cast<double>(i) / (side - 1),
                     y = static_cast<double>(j) / (side - 1);
        points.insert(points.end(), {x, y, height * std::sin(6 * x) * std::cos(5 * y)});
      }
    }
    for (int j = 0; j + 1 < side; ++j) {
      for (int i = 0; i + 1 < side; ++i) {
        const std::int64_t a = j * side + i, b = a + 1, c = a + side, d = c + 1;
        triangles.insert(triangles.end(), {a, b, d, a, d, c});
      }
    }
  }
};

template <class Number>
std::vector<Number> as(const auto& numbers) {
  return std::vector<Number>(numbers.begin(), numbers.end());
}

Surface bumpy_square() {
  const Arrays arrays(40);
  return make_surface(make_mesh({arrays.points, 3}, {arrays.triangles, 3}));
}

Surface flat_square() {
  const Arrays arrays(40, 0);
  return make_surface(make_mesh({arrays.points, 3}, {arrays.triangles, 3}));
}

TEST(Library, MakesTheSameMeshOfArraysOfAnyType) {
  const Arrays arrays(12);
  const Mesh mesh = make_mesh({arrays.points, 3}, {arrays.triangles, 3});
  ASSERT_EQ(mesh.vertex_count(), 144u);
  ASSERT_EQ(mesh.triangle_count(), 242u);
  const auto floats = as<float>(arrays.points);
  EXPECT_EQ(make_mesh({floats, 3}, {as<std::uint32_t>(arrays.triangles), 3}).positions,
            mesh.positions);
  EXPECT_EQ(make_mesh({floats, 3}, {as<int>(arrays.triangles), 3}).triangles, mesh.triangles);
  EXPECT_EQ(make_mesh({floats, 3}, {as<std::uint8_t>(arrays.triangles), 3}).triangles,
            mesh.triangles);
}

TEST(Library, RefusesArraysThatAreNoMesh) {
  const Arrays good(5);
  const auto refuses = [](const Arrays& arrays, const std::string& part) {
    try {
      make_mesh({arrays.points, 3}, {arrays.triangles, 3});
      ADD_FAILURE() << "accepted, without " << part;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  Arrays bad = good;
  bad.triangles[7] = 25;
  refuses(bad, "triangle 2");
  bad.triangles[7] = -1;
  refuses(bad, "triangle 2");
  bad.triangles[7] = std::int64_t{1} << 32;  // 0 if it were cut to 32 bits
  refuses(bad, "triangle 2");
  bad = good;
  bad.points[4] = std::numeric_limits<double>::quiet_NaN();
  refuses(bad, "vertex 1");
  bad.points[4] = 1e300;
  refuses(bad, "vertex 1");
  EXPECT_THROW(make_mesh({good.points, 5}, {good.triangles, 3}), Error);
  EXPECT_THROW(make_mesh({good.points, 3}, {good.triangles, 4}), Error);
  const std::vector<float> indices(9, 0.0f);
  EXPECT_THROW(make_mesh({good.points, 3}, {indices, 3}), Error);
}

TEST(Library, KeepsTheShapeOfWhatIsFarFromZero) {
  Arrays arrays(40);
  const Mesh near = make_mesh({arrays.points, 3}, {arrays.triangles, 3});
  for (std::size_t i = 0; i < arrays.points.size(); i += 3) {
    arrays.points[i] += 500000;
    arrays.points[i + 1] += 5800000;
  }
  const Mesh far = make_mesh({arrays.points, 3}, {arrays.triangles, 3});
  for (std::size_t v = 0; v < far.vertex_count(); ++v) {
    const Eigen::Vector3d there = far.positions[v].cast<double>() + far.origin;
    const Eigen::Vector3d here = near.positions[v].cast<double>() + near.origin;
    EXPECT_LT((there - here - Eigen::Vector3d(500000, 5800000, 0)).norm(), 1e-6);
  }
}

TEST(Library, LaysStripesInACall) {
  const Surface surface = bumpy_square();
  const DirectionField field = projected_direction_field({1, 0.2f, 0}, surface.normals);
  const StripePattern pattern = stripe_pattern(surface, field, 12);
  const FrequencyField frequencies(surface.mesh.vertex_count(), 12.0f);
  EXPECT_EQ(stripe_pattern(surface, field, frequencies).solution.z, pattern.solution.z);
  const WaveSet waves{surface.mesh.positions, field, frequencies};
  EXPECT_EQ(stripe_pattern(surface, waves).solution.z, pattern.solution.z);
  EXPECT_LT(pattern.solution.energy, 0.001);
}

TEST(Library, PatternsKnowWhatTheyWereMadeWith) {
  const Surface surface = bumpy_square();
  StripePattern pattern;
  StripeOptions options;
  options.phase_shift = PhaseShiftKind::trapezoid;
  {
    const DirectionField field = projected_direction_field({1, 0.2f, 0}, surface.normals);
    pattern = stripe_pattern(surface, field, 12, options);
  }
  EXPECT_EQ(pattern.phase_shift, PhaseShiftKind::trapezoid);
  EXPECT_EQ(pattern.waves.frequencies[0], 12);
  EXPECT_GT(stripe_curves(surface, pattern).lines.count(), 5u);
}

TEST(Library, TracesCurvesInACall) {
  const Surface surface = flat_square();
  const auto pattern =
      stripe_pattern(surface, projected_direction_field({1, 0, 0}, surface.normals), 10);
  const StripeCurves curves = stripe_curves(surface, pattern);
  EXPECT_NEAR(static_cast<double>(curves.lines.count()), 10, 1);
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    EXPECT_NEAR(length_of(curves.lines, line), 1, 1e-4);
  }
}

TEST(Library, FindsSamplesInACall) {
  const Surface surface = flat_square();
  const auto u = stripe_pattern(surface, projected_direction_field({1, 0, 0}, surface.normals), 10);
  const auto v = stripe_pattern(surface, projected_direction_field({0, 1, 0}, surface.normals), 15);
  const std::size_t curves_u = stripe_curves(surface, u).lines.count();
  const std::size_t curves_v = stripe_curves(surface, v).lines.count();
#ifdef BRINDLE_HAS_NANOFLANN
  EXPECT_EQ(stripe_samples(surface, u, v).size(), curves_u * curves_v);
#else
  EXPECT_GT(curves_u * curves_v, 0u);
  EXPECT_THROW(stripe_samples(surface, u, v), Error);
#endif
}

TEST(Library, LaysTexturesInACall) {
  const Surface surface = bumpy_square();
  const TexturePattern pattern =
      texture_pattern(surface, projected_direction_field({1, 0, 0}, surface.normals), 8);
  const TexturedMesh textured = texture_coordinates(surface, pattern);
  EXPECT_EQ(textured.coordinates.size(), textured.mesh.vertex_count());
  EXPECT_GE(textured.mesh.vertex_count(), surface.mesh.vertex_count());
}

TEST(Library, RefusesPatternsOfOtherSurfaces) {
  const Surface surface = bumpy_square();
  const Surface other = make_surface(make_shape("plane,resolution=7"));
  const auto pattern =
      stripe_pattern(other, projected_direction_field({1, 0, 0}, other.normals), 5);
  EXPECT_THROW(stripe_curves(surface, pattern), Error);
  EXPECT_THROW(stripe_samples(surface, pattern, pattern), Error);
  const auto texture =
      texture_pattern(other, projected_direction_field({1, 0, 0}, other.normals), 5);
  EXPECT_THROW(texture_coordinates(surface, texture), Error);
}

TEST(Library, TellsItsVersion) { EXPECT_STREQ(version(), BRINDLE_VERSION); }

}  // namespace
}  // namespace brindle
