#include "brindle/texture_coordinates.h"

#include <cmath>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "brindle/geometry/topology.h"
#include "textures.h"

namespace brindle {
namespace {

using namespace testing_support;

float to_whole(float x) { return std::abs(x - std::round(x)); }

TexturedMesh textured(const Surface& surface, const TexturePattern& pattern) {
  return texture_coordinates(surface.mesh, pattern.waves, PhaseShiftKind::aligned);
}

TEST(TextureCoordinates, OfAPlaneAreLinearAndSplitNothing) {
  const Surface surface = make_surface(make_shape("plane,resolution=15"));
  const Vec3 axis = Vec3(3, 1, 0).normalized();
  for (const float stripes : {6.0f, 60.0f}) {
    const TexturePattern pattern = texture_along(surface, axis, stripes);
    const TexturedMesh mesh = textured(surface, pattern);
    EXPECT_EQ(mesh.mesh.vertex_count(), surface.mesh.vertex_count());
    EXPECT_EQ(mesh.mesh.triangles, surface.mesh.triangles);
    const float frequency = pattern.u.waves.frequencies[0];
    const Vec3 across(-axis.y(), axis.x(), 0);
    for (std::size_t v = 1; v < mesh.mesh.vertex_count(); ++v) {
      const Vec3 way = frequency * (mesh.mesh.positions[v] - mesh.mesh.positions[0]);
      const Eigen::Vector2f step = mesh.coordinates[v] - mesh.coordinates[0];
      ASSERT_NEAR(std::abs(step.x()), std::abs(way.dot(axis)), 2e-3f);
      ASSERT_NEAR(std::abs(step.y()), std::abs(way.dot(across)), 2e-3f);
      ASSERT_GT(step.x() * way.dot(axis) * step.y() * way.dot(across), -1e-2f);  // right-handed
    }
  }
}

TEST(TextureCoordinates, AroundACylinderSplitOneColumnAtMost) {
  const Surface surface = make_surface(make_shape("cylinder,resolution=60"));
  const TexturePattern pattern = texture_along(surface, Vec3(0, 0, 1), 24);
  const TexturedMesh mesh = textured(surface, pattern);
  EXPECT_EQ(mesh.mesh.triangle_count(), surface.mesh.triangle_count());
  const std::size_t copies = mesh.mesh.vertex_count() - surface.mesh.vertex_count();
  EXPECT_GT(copies, 0u);
  EXPECT_LT(copies, 3 * surface.mesh.vertex_count() / 60);
}

TEST(CornerTextureCoordinates, AreThoseOfTheTexturedMeshUpToWholeTiles) {
  const Surface surface = make_surface(make_shape("sphere,resolution=20"));
  const TexturePattern pattern = texture_along(surface, Vec3(0, 0, 1), 12);
  const TexturedMesh mesh = textured(surface, pattern);
  const std::vector<float> uv = corner_texture_coordinates(pattern.waves, PhaseShiftKind::aligned);
  ASSERT_EQ(uv.size(), 6 * surface.mesh.triangle_count());
  std::vector<int> pieces(surface.mesh.triangle_count());
  for (const Index origin : mesh.triangle_origins) ++pieces[origin];
  std::size_t compared = 0, without = 0;
  for (std::size_t i = 0; i < mesh.mesh.triangle_count(); ++i) {
    const Index t = mesh.triangle_origins[i];
    if (std::isnan(uv[6 * t])) ++without;
    if (pieces[t] > 1 || std::isnan(uv[6 * t])) continue;
    for (std::size_t m = 0; m < 3; ++m) {
      const Eigen::Vector2f there = mesh.coordinates[mesh.mesh.triangles[i][m]];
      ASSERT_LT(to_whole(uv[6 * t + 2 * m] - there.x()), 1e-4f);
      ASSERT_LT(to_whole(uv[6 * t + 2 * m + 1] - there.y()), 1e-4f);
      ++compared;
    }
  }
  EXPECT_GT(compared, surface.mesh.triangle_count());
  EXPECT_GT(without, 0u);  // the poles are singularities of the field
}

/// The largest difference, up to whole tiles and up to the turn by 180 degrees, that both sides of
/// an edge have at its ends; inner edges of split triangles and torn ones are left out.
float largest_jump(const Surface& surface, const TexturePattern& pattern,
                   const TexturedMesh& mesh) {
  // Vertices as they were before the split: copies stand for the same one again.
  std::vector<Triangle> joined = mesh.mesh.triangles;
  for (Triangle& triangle : joined) {
    for (Index& v : triangle) {
      const auto& origin = mesh.origins[v];
      if (origin[0] == origin[1]) v = origin[0];
    }
  }
  std::set<std::pair<Index, Index>> torn;
  for (const SharedEdge& edge : shared_edges(surface.mesh.triangles)) {
    const auto vertex = [&](Index corner) {
      return surface.mesh.triangles[corner / 3][corner % 3];
    };
    if (is_torn(pattern.waves, edge)) torn.emplace(vertex(edge.from[0]), vertex(edge.to[0]));
  }
  float largest = 0;
  for (const SharedEdge& edge : shared_edges(joined)) {
    const auto coordinates = [&](Index corner) {
      return mesh.coordinates[mesh.mesh.triangles[corner / 3][corner % 3]];
    };
    const auto vertex = [&](Index corner) { return joined[corner / 3][corner % 3]; };
    if (vertex(edge.from[0]) >= surface.mesh.vertex_count() ||
        vertex(edge.to[0]) >= surface.mesh.vertex_count() ||
        torn.contains({vertex(edge.from[0]), vertex(edge.to[0])})) {
      continue;
    }
    const Eigen::Vector2f a = coordinates(edge.to[0]) - coordinates(edge.from[0]);
    const Eigen::Vector2f b = coordinates(edge.to[1]) - coordinates(edge.from[1]);
    // The way along the edge is the same from both sides, not only up to tiles.
    largest = std::max(largest, std::min((a - b).norm(), (a + b).norm()));
    const auto fits = [&](float sign) {
      const Eigen::Vector2f gap = coordinates(edge.from[0]) - sign * coordinates(edge.from[1]);
      return std::max(to_whole(gap.x()), to_whole(gap.y()));
    };
    largest = std::max(largest, std::min(fits(1), fits(-1)));
  }
  return largest;
}

TEST(TextureCoordinates, FitAtEveryEdgeUpToWholeTilesAndHalfTurns) {
  for (const char* shape : {"torus,resolution=60", "sphere,resolution=12", "trefoil,resolution=20",
                            "molecule,atoms=3"}) {
    const Surface surface = make_surface(make_shape(shape));
    const TexturePattern pattern = texture_along(surface, Vec3(0.2f, 0.3f, 0.9f), 30);
    const TexturedMesh mesh = textured(surface, pattern);
    EXPECT_LT(largest_jump(surface, pattern, mesh), 2e-3f) << shape;
    EXPECT_EQ(mesh.mesh.triangle_count(), surface.mesh.triangle_count() + 2 * mesh.split_triangles);
    EXPECT_GE(mesh.split_triangles, pattern.u.quality.branches) << shape;
    // A copy for every vertex on a cut, not for every corner.
    EXPECT_LT(mesh.mesh.vertex_count(), 2 * surface.mesh.vertex_count()) << shape;
  }
}

TEST(TextureCoordinates, AreThePhasesAtTheirVertices) {
  const Surface surface = make_surface(make_shape("torus,resolution=50"));
  const TexturePattern pattern = texture_along(surface, Vec3(0.2f, 0.3f, 0.9f), 20);
  const TexturedMesh mesh = textured(surface, pattern);
  for (std::size_t v = 0; v < mesh.mesh.vertex_count(); ++v) {
    const auto& origin = mesh.origins[v];
    if (origin[0] != origin[1]) continue;
    const float u = texture_coordinate(pattern.u.solution.z[origin[0]]);
    const float off =
        std::min(to_whole(mesh.coordinates[v].x() - u), to_whole(mesh.coordinates[v].x() + u));
    ASSERT_LT(off, 1e-4f);
    ASSERT_EQ(mesh.mesh.positions[v], surface.mesh.positions[origin[0]]);
  }
}

TEST(TextureCoordinates, SplitTrianglesStandAtTheirBarycentre) {
  const Surface surface = make_surface(make_shape("plane,resolution=12"));
  const TexturePattern pattern =
      texture_pattern(surface, waves_of(surface, singular_field(surface.mesh, 0.5f), 6));
  const TexturedMesh mesh = textured(surface, pattern);
  ASSERT_GE(mesh.split_triangles, 1u);
  const std::size_t v = surface.mesh.vertex_count();
  const auto& [a, b, c] = mesh.origins[v];
  const auto& p = surface.mesh.positions;
  EXPECT_LT((mesh.mesh.positions[v] - (p[a] + p[b] + p[c]) / 3).norm(), 1e-6f);
  const std::vector<float> values = carried_values(mesh, std::vector<float>(v, 2.5f), 1);
  EXPECT_EQ(values, std::vector<float>(mesh.mesh.vertex_count(), 2.5f));
}

TEST(TextureCoordinates, CarryWavesToCopies) {
  const Surface surface = make_surface(make_shape("cylinder,resolution=30"));
  const TexturePattern pattern = texture_along(surface, Vec3(0, 0, 1), 10);
  const TexturedMesh mesh = textured(surface, pattern);
  const CarriedWaves carried = carried_waves(mesh, pattern.u.waves, pattern.u.solution.z);
  ASSERT_EQ(carried.z.size(), mesh.mesh.vertex_count());
  for (std::size_t v = 0; v < carried.z.size(); ++v) {
    const Index origin = mesh.origins[v][0];
    ASSERT_EQ(carried.z[v], pattern.u.solution.z[origin]);
    ASSERT_EQ(carried.waves.directions[v], pattern.u.waves.directions[origin]);
  }
}

TEST(TextureCoordinates, WithoutWavesAreZero) {
  const Surface surface = make_surface(make_shape("plane,resolution=6"));
  const TexturePattern pattern = texture_pattern(
      surface, waves_of(surface, DirectionField(surface.mesh.vertex_count(), Vec3::Zero()), 6));
  const TexturedMesh mesh = textured(surface, pattern);
  for (const auto& uv : mesh.coordinates) EXPECT_EQ(uv, Eigen::Vector2f(0, 0));
}

}  // namespace
}  // namespace brindle
