#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <span>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "brindle/geometry/topology.h"
#include "brindle/nearest.h"
#include "brindle/relief/decimation.h"
#include "brindle/relief/refined_relief.h"
#include "brindle/relief/self_intersections.h"
#include "brindle/shapes.h"
#include "relief/closed_meshes.h"

namespace brindle {
namespace {

double area_of(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) sum += triangle_area_of(mesh, t);
  return sum;
}

/// A base whose texture coordinates are x and y, with a height of that place.
ReliefBase plain_base(Mesh mesh) {
  ReliefBase base;
  for (Index t = 0; t < mesh.triangle_count(); ++t) {
    std::array<Eigen::Vector2f, 3> uv;
    for (int m = 0; m < 3; ++m) uv[m] = mesh.positions[mesh.triangles[t][m]].head<2>();
    base.uv.push_back(uv);
    base.normals.push_back({Vec3::UnitZ(), Vec3::UnitZ(), Vec3::UnitZ()});
    base.original.push_back(t);
    base.in_original.push_back({Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()});
  }
  base.textured.assign(mesh.triangle_count(), 1);
  base.mesh = std::move(mesh);
  return base;
}

TEST(RefinedRelief, IsLinearInItsTrianglesAndFitsAlongEdges) {
  const std::vector<TextureHeight> heights = {
      [](float u, float v) { return 0.5f + 0.5f * std::sin(3 * u) * std::cos(4 * v); },
      [](float u, float v) { return std::clamp(5 * std::hypot(u, v) - 2, 0.0f, 1.0f); },
      [](float u, float v) { return std::clamp(std::abs(3 * u - v), 0.0f, 1.0f); }};
  for (const TextureHeight& height : heights) {
    const ReliefBase base = plain_base(make_shape("plane,resolution=3"));
    const TexturedMesh none;
    const ReliefTexture texture{none, height, nullptr, 0.05f};
    const RefinementLimits limits{0.02f, 1e-3f, false};
    const RefinedRelief refined = refined_relief(base, texture, limits, {});
    const Mesh mesh{refined.positions, refined.triangles};
    EXPECT_NEAR(area_of(mesh), area_of(base.mesh), 1e-4);
    // Edges of one triangle are those of the square: no edge ends inside another.
    const auto edges = directed_edges(mesh);
    for (const auto& [edge, times] : edges) {
      ASSERT_EQ(times, 1);
      if (edges.contains({edge.second, edge.first})) continue;
      const Vec3 middle = 0.5f * (mesh.positions[edge.first] + mesh.positions[edge.second]);
      ASSERT_NEAR(middle.cwiseAbs().maxCoeff(), 1, 1e-6f);
    }
    std::mt19937 engine(3);
    std::uniform_real_distribution<float> number(0, 1);
    for (const Triangle& t : refined.triangles) {
      const float a = number(engine), b = (1 - a) * number(engine), c = 1 - a - b;
      const Vec3 place =
          a * mesh.positions[t[0]] + b * mesh.positions[t[1]] + c * mesh.positions[t[2]];
      const float linear =
          a * refined.heights[t[0]] + b * refined.heights[t[1]] + c * refined.heights[t[2]];
      ASSERT_NEAR(height(place.x(), place.y()), linear, 0.03f) << place.transpose();
    }
  }
}

TEST(RefinedRelief, SplitsOnlyWhereTheHeightBends) {
  const ReliefBase base = plain_base(make_shape("plane,resolution=4"));
  const TexturedMesh none;
  const ReliefTexture linear{none, [](float u, float) { return 0.5f + 0.3f * u; }, nullptr, 0.05f};
  EXPECT_EQ(refined_relief(base, linear, {0.01f, 1e-3f, false}, {}).triangles.size(),
            base.mesh.triangle_count());
  // A straight kink becomes a line of edges.
  const ReliefTexture kink{
      none, [](float u, float v) { return std::max(0.0f, 0.2f * (u + 0.3f * v)); }, nullptr, 0.05f};
  const RefinedRelief refined = refined_relief(base, kink, {1e-3f, 1e-4f, false}, {});
  EXPECT_LT(refined.triangles.size(), 8 * base.mesh.triangle_count());
  Mesh raised{refined.positions, refined.triangles};
  for (std::size_t v = 0; v < raised.vertex_count(); ++v)
    raised.positions[v].z() = refined.heights[v];
  EXPECT_LT(decimated(raised, refined.positions, {}, 1e-3f).size(), 4 * base.mesh.triangle_count());
}

TEST(RefinedRelief, EndsAtSteps) {
  const ReliefBase base = plain_base(make_shape("plane,resolution=4"));
  const TexturedMesh none;
  const ReliefTexture step{
      none, [](float u, float v) { return u + 0.37f * v > 0.11f ? 1.0f : 0.0f; }, nullptr, 0.05f};
  const RefinedRelief refined = refined_relief(base, step, {0.01f, 0.01f, false}, {});
  EXPECT_LT(refined.triangles.size(), 200 * base.mesh.triangle_count());
}

Mesh decimated_mesh(const Mesh& mesh, std::span<const std::uint8_t> locked, float tolerance) {
  Mesh fewer{mesh.positions, decimated(mesh, mesh.positions, locked, tolerance), mesh.origin};
  drop_unreferenced_vertices(fewer);
  return fewer;
}

TEST(Decimation, KeepsClosedMeshesClosedAndNear) {
  for (const char* shape : {"sphere,resolution=20", "torus,resolution=60", "bracket", "gear",
                            "trefoil,resolution=20"}) {
    SCOPED_TRACE(shape);
    const Mesh mesh = subdivide(make_shape(shape));
    const float tolerance = 0.002f * bounding_box(mesh).diagonal();
    const Mesh fewer = decimated_mesh(mesh, {}, tolerance);
    expect_closed(fewer);
    EXPECT_EQ(euler_number(fewer), euler_number(mesh));
    EXPECT_LT(fewer.triangle_count(), mesh.triangle_count() / 2);
    const NearestOnMesh nearest(fewer), before(mesh);
    for (const Vec3& p : mesh.positions) {
      ASSERT_LE(nearest.nearest(p.cast<double>())->distance, tolerance);
    }
    for (const Triangle& t : fewer.triangles) {
      const Vec3 middle =
          (fewer.positions[t[0]] + fewer.positions[t[1]] + fewer.positions[t[2]]) / 3;
      ASSERT_LE(before.nearest(middle.cast<double>())->distance, tolerance);
    }
  }
}

TEST(Decimation, LeavesFlatFacesFewTriangles) {
  const Mesh mesh = make_shape("bracket");
  const Mesh fine = subdivide(mesh, 3);
  EXPECT_LE(decimated_mesh(fine, {}, 1e-5f).triangle_count(), 2 * mesh.triangle_count());
}

TEST(Decimation, KeepsLockedVertices) {
  const Mesh mesh = subdivide(make_shape("bracket"), 2);
  std::vector<std::uint8_t> locked(mesh.vertex_count());
  for (std::size_t v = 0; v < locked.size(); v += 7) locked[v] = 1;
  const Mesh fewer = decimated_mesh(mesh, locked, 0.01f);
  EXPECT_LT(fewer.vertex_count(), mesh.vertex_count() / 2);
  const auto at = [](const Vec3& p) { return std::array{p.x(), p.y(), p.z()}; };
  std::set<std::array<float, 3>> left;
  for (const Vec3& p : fewer.positions) left.insert(at(p));
  for (std::size_t v = 0; v < locked.size(); ++v) {
    if (locked[v] != 0) {
      EXPECT_TRUE(left.contains(at(mesh.positions[v])));
    }
  }
}

/// A wavy sheet over the plane, with steep flanks.
TEST(Decimation, KeepsASheetAbovePlaceByPlace) {
  const Mesh rest = subdivide(make_shape("plane,resolution=30"), 1);
  Mesh mesh = rest;
  for (Vec3& p : mesh.positions) {
    p.z() += 0.2f * std::clamp(30 * std::sin(6 * p.x()) * std::sin(7 * p.y()), 0.0f, 1.0f);
  }
  const std::vector<Triangle> fewer = decimated(mesh, rest.positions, {}, 0.01f);
  EXPECT_LT(fewer.size(), mesh.triangle_count() / 2);
  for (const Triangle& t : fewer) {
    const auto& p = rest.positions;
    ASSERT_GT((p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).z(), 0);
  }
}

std::size_t count_of(const std::vector<std::uint8_t>& found) {
  return static_cast<std::size_t>(std::count(found.begin(), found.end(), 1));
}

using Exact = Eigen::Matrix<long double, 3, 1>;

/// Whether an edge of a triangle crosses another one, by solving for the place.
bool edge_crosses(const Mesh& mesh, const Triangle& t, const Triangle& other) {
  const auto at = [&](Index v) { return Exact(mesh.positions[v].cast<long double>()); };
  const Exact u = at(other[1]) - at(other[0]), v = at(other[2]) - at(other[0]);
  for (int m = 0; m < 3; ++m) {
    const Index from = t[m], to = t[(m + 1) % 3];
    if (std::find(other.begin(), other.end(), from) != other.end()) continue;
    if (std::find(other.begin(), other.end(), to) != other.end()) continue;
    Eigen::Matrix<long double, 3, 3> matrix;
    matrix << u, v, at(from) - at(to);
    const Exact place = matrix.fullPivLu().solve(at(from) - at(other[0]));
    if (place.minCoeff() >= 0 && place[0] + place[1] <= 1 && place[2] <= 1) return true;
  }
  return false;
}

std::vector<std::uint8_t> found_one_by_one(const Mesh& mesh) {
  std::vector<std::uint8_t> found(mesh.triangle_count());
  for (std::size_t t = 0; t < found.size(); ++t) {
    for (std::size_t u = 0; u < found.size(); ++u) {
      if (t == u || !edge_crosses(mesh, mesh.triangles[t], mesh.triangles[u])) continue;
      found[t] = found[u] = 1;
    }
  }
  return found;
}

TEST(SelfIntersections, AreThoseOfAllPairs) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<float> number(-1, 1);
  for (const float noise : {0.02f, 0.1f, 0.5f}) {
    Mesh mesh = make_shape("sphere,resolution=5");
    for (Vec3& p : mesh.positions)
      p += noise * Vec3(number(engine), number(engine), number(engine));
    EXPECT_EQ(intersecting_triangles(mesh), found_one_by_one(mesh)) << noise;
  }
}

TEST(SelfIntersections, AreThoseOfAllPairsAlsoWhereHeightsAreLowered) {
  std::mt19937 engine(8);
  std::uniform_real_distribution<float> number(0, 1);
  const Mesh base = make_shape("torus,resolution=14");
  for (const float most : {0.1f, 0.5f, 2.0f}) {
    RaisedMesh raised{base.triangles, base.positions, {}, {}};
    for (std::size_t v = 0; v < base.vertex_count(); ++v) {
      raised.ways.push_back(Vec3(number(engine), number(engine), number(engine)));
      raised.heights.push_back(most * number(engine));
    }
    const std::vector<float> before = raised.heights;
    const Mesh high{raised.positions(), raised.triangles};
    EXPECT_EQ(intersecting_triangles(high), found_one_by_one(high));
    EXPECT_EQ(lower_intersections(raised, {}), 0u);
    const Mesh lower{raised.positions(), raised.triangles};
    EXPECT_EQ(count_of(found_one_by_one(lower)), 0u);
    for (std::size_t v = 0; v < before.size(); ++v) ASSERT_LE(raised.heights[v], before[v]);
    EXPECT_GT(std::accumulate(raised.heights.begin(), raised.heights.end(), 0.0f), 0);
  }
}

TEST(SelfIntersections, OfTheSurfaceItselfAreCounted) {
  Mesh crossing = make_shape("sphere,resolution=6"), other = crossing;
  translate(other, {1.0f, 0.1f, 0.2f});
  append(other, crossing);
  RaisedMesh raised{crossing.triangles, crossing.positions, {}, {}};
  raised.ways.assign(crossing.vertex_count(), Vec3::UnitZ());
  raised.heights.assign(crossing.vertex_count(), 0.01f);
  EXPECT_EQ(lower_intersections(raised, {}), count_of(intersecting_triangles(crossing)));
  raised.heights.assign(crossing.vertex_count(), 0.01f);
  raised.least_share = 0.5f;
  lower_intersections(raised, {});
  for (const float height : raised.heights) ASSERT_GE(height, 0.005f);
}

TEST(SelfIntersections, AreFoundWhereTrianglesCross) {
  Mesh mesh = make_shape("sphere,resolution=6");
  const auto count = [](const Mesh& m) { return count_of(intersecting_triangles(m)); };
  EXPECT_EQ(count(mesh), 0u);
  Mesh other = mesh;
  translate(other, {1.0f, 0.1f, 0.2f});
  Mesh crossing = mesh;
  append(other, crossing);
  EXPECT_GT(count(crossing), 10u);
  Mesh apart = mesh;
  translate(other, {2.0f, 0, 0});
  append(other, apart);
  EXPECT_EQ(count(apart), 0u);
  Mesh folded = mesh;  // a vertex pulled through the sphere
  folded.positions[5] *= -1.5f;
  EXPECT_GT(count(folded), 4u);
}

TEST(SelfIntersections, AreNoneWhereTrianglesTouch) {
  // Two tetrahedra that share a vertex and, at another, a side.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3},
                    {0, 4, 5}, {0, 6, 4}, {0, 5, 6}, {4, 6, 5}};
  EXPECT_EQ(count_of(intersecting_triangles(mesh)), 0u);
}

TEST(SelfIntersections, AreExactInPlanesOfAnyTilt) {
  const Mesh flat = make_shape("plane,resolution=20");
  for (const float angle : {0.0f, 0.3f, 0.9f}) {
    Mesh mesh = flat;
    // Whole numbers stay in one plane.
    const Vec3 u(3, std::round(10 * angle), 7), v(-2, 5, std::round(20 * angle));
    for (Vec3& p : mesh.positions) p = std::round(40 * p.x()) * u + std::round(40 * p.y()) * v;
    EXPECT_EQ(count_of(intersecting_triangles(mesh)), 0u) << angle;
    mesh.positions[200] = mesh.positions[201] + (mesh.positions[201] - mesh.positions[200]) / 2;
    EXPECT_GE(count_of(intersecting_triangles(mesh)), 2u) << angle;  // folded, still flat
  }
}

/// A vertex far below the rounding of the largest coordinate tells the sides apart.
TEST(SelfIntersections, DoNotDependOnDistantTriangles) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0},       {1, 0, 0},       {0, 1, 0},
                    {0.2f, 0.2f, 1}, {0.2f, 0.3f, 1}, {0.3f, 0.2f, 1e-4f},
                    {999, 0, 0},     {1000, 0, 0},    {999, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}};
  EXPECT_EQ(count_of(intersecting_triangles(mesh)), 0u);
  mesh.positions[5].z() = -1e-4f;
  EXPECT_EQ(count_of(intersecting_triangles(mesh)), 2u);
}

}  // namespace
}  // namespace brindle
