/// What a program that embeds the library does, with its public headers alone.
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
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

std::string refusal_of(const Arrays& arrays) {
  try {
    make_mesh({arrays.points, 3}, {arrays.triangles, 3});
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Library, RefusesTrianglesThatStandTwiceOrHaveTwoCornersAlike) {
  const Arrays good(5);
  for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{2, 0, 1}, std::array{1, 0, 2}}) {
    Arrays twice = good;
    const auto corner = [&](int m) { return good.triangles[9 + static_cast<std::size_t>(m)]; };
    twice.triangles.insert(twice.triangles.end(), {corner(a), corner(b), corner(c)});
    const std::string message = refusal_of(twice);
    EXPECT_NE(message.find("triangle 32 has the corners of triangle 3"), std::string::npos)
        << message;
    EXPECT_NE(message.find("make_repaired_mesh"), std::string::npos) << message;
  }
  for (const std::size_t corner : {0u, 1u, 2u}) {
    Arrays alike = good;
    alike.triangles[15 + corner] = alike.triangles[15 + (corner + 1) % 3];
    const std::string message = refusal_of(alike);
    EXPECT_NE(message.find("triangle 5 has vertex "), std::string::npos) << message;
    EXPECT_NE(message.find("at two corners"), std::string::npos) << message;
    EXPECT_EQ(
        make_mesh({alike.points, 3}, {alike.triangles, 3}, BadTriangles::kept).triangle_count(),
        32u);
  }
}

/// A box whose six faces share no vertex.
struct SplitBox {
  std::vector<double> points;
  std::vector<int> triangles;

  explicit SplitBox(const Mesh& box) {
    // A vertex per face and place: faces are told apart by the triangles' normals.
    std::map<std::pair<int, Index>, int> number;
    for (const Triangle& t : box.triangles) {
      const Vec3 n = (box.positions[t[1]] - box.positions[t[0]])
                         .cross(box.positions[t[2]] - box.positions[t[0]])
                         .normalized();
      const int face = static_cast<int>(std::lround(n.x() + 4 * n.y() + 16 * n.z()));
      for (const Index corner : t) {
        const auto [found, added] =
            number.insert({{face, corner}, static_cast<int>(number.size())});
        triangles.push_back(found->second);
        if (!added) continue;
        for (int axis = 0; axis < 3; ++axis) points.push_back(box.positions[corner][axis]);
      }
    }
  }
};

TEST(Library, AMeshSplitAlongItsEdgesIsWarnedOfAndJoined) {
  const Mesh box = make_shape("box,resolution=12");
  const SplitBox split(box);
  const Surface apart = make_surface(make_mesh({split.points, 3}, {split.triangles, 3}));
  const RepairedMesh repaired = make_repaired_mesh({split.points, 3}, {split.triangles, 3});
  const Surface joined = make_surface(repaired.mesh);
  ASSERT_GT(apart.mesh.vertex_count(), box.vertex_count());

  // Every edge of the box is there twice.
  EXPECT_TRUE(surface_warnings(make_surface(box)).empty());
  EXPECT_TRUE(surface_warnings(joined).empty());
  const std::vector<std::string> warned = surface_warnings(apart, "do this");
  ASSERT_EQ(warned.size(), 1u);
  EXPECT_NE(warned[0].find("boundary edges stand exactly where others do"), std::string::npos);
  EXPECT_NE(warned[0].find("do this"), std::string::npos);

  // Vertices keep their numbers, and the map says which are used.
  EXPECT_EQ(repaired.mesh.vertex_count(), apart.mesh.vertex_count());
  EXPECT_EQ(repaired.mesh.triangle_count(), box.triangle_count());
  EXPECT_TRUE(repaired.kept_triangles.empty());
  ASSERT_EQ(repaired.vertex_of_row.size(), apart.mesh.vertex_count());
  std::size_t joined_vertices = 0;
  for (Index v = 0; v < repaired.vertex_of_row.size(); ++v) {
    const Index used = repaired.vertex_of_row[v];
    EXPECT_LE(used, v);
    EXPECT_EQ(apart.mesh.positions[used], apart.mesh.positions[v]);
    joined_vertices += used != v;
  }
  EXPECT_EQ(repaired.repair.vertices_joined, joined_vertices);
  EXPECT_EQ(joined_vertices, apart.mesh.vertex_count() - box.vertex_count());

  // Curves run on over the edges.
  const auto curves = [](const Surface& surface) {
    const DirectionField field = projected_direction_field({0.3f, 0.5f, 1}, surface.normals);
    const float frequency = frequency_of_stripes(8, bounding_box(surface.mesh).diagonal());
    const StripePattern pattern = stripe_pattern(surface, field, frequency);
    EXPECT_EQ(pattern_warnings(surface, pattern).empty(), surface_warnings(surface).empty());
    return stripe_curves(surface, pattern).lines.count();
  };
  EXPECT_LT(2 * curves(joined), curves(apart));
}

TEST(Library, RepairedMeshesHaveNothingThatMakeMeshRefuses) {
  Arrays bad(5);
  bad.triangles.insert(bad.triangles.end(), {0, 0, 1, 3, 4, 99, 0, 1, -1});
  bad.triangles.insert(bad.triangles.end(), bad.triangles.begin(), bad.triangles.begin() + 3);
  bad.points[3 * 24] = std::numeric_limits<double>::quiet_NaN();
  const RepairedMesh repaired = make_repaired_mesh({bad.points, 3}, {bad.triangles, 3});
  EXPECT_EQ(repaired.repair.triangles_degenerate, 1u);
  EXPECT_EQ(repaired.repair.triangles_out_of_range, 2u);
  EXPECT_EQ(repaired.repair.triangles_duplicate, 1u);
  EXPECT_EQ(repaired.repair.vertices_not_finite, 1u);
  EXPECT_EQ(repaired.kept_triangles.size(), repaired.mesh.triangle_count());
  const std::vector<Triangle>& left = repaired.mesh.triangles;
  const std::vector<Index> corners(left.front().data(), left.front().data() + 3 * left.size());
  EXPECT_EQ(make_mesh(repaired.mesh.positions, {corners, 3}).triangles, left);
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
