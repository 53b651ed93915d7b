#include "brindle/cross_texture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/fragment_phase.h"
#include "brindle/frequency_field.h"
#include "brindle/normals.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"

namespace brindle {
namespace {

struct Crossed {
  Surface surface;
  CrossPattern cross;
  CrossTexture texture;
};

Crossed textured_crosses(const char* shape, float stripes = 25) {
  Surface surface = make_surface(make_shape(shape));
  const float frequency = frequency_of_stripes(stripes, bounding_box(surface.mesh).diagonal());
  const WaveSet waves{surface.mesh.positions, smooth_direction_field(surface, {.symmetry = 4}),
                      constant_frequency_field(frequency, surface.mesh.vertex_count())};
  CrossPattern cross = cross_pattern(surface, waves);
  CrossTexture texture = cross_texture(surface, cross);
  return {std::move(surface), std::move(cross), std::move(texture)};
}

/// sin Phi of U and V at a point of an edge, in ascending order: all that a tile with 90-degree and
/// mirror symmetry shows.
std::array<float, 2> shown_at(const TextureWaves& waves, std::size_t t, const Vec3& barycentric) {
  const float u = fragment_phase(waves.u[t], barycentric).z.imag();
  const float v = fragment_phase(waves.v[t], barycentric).z.imag();
  return {std::min(u, v), std::max(u, v)};
}

/// Barycentric weights of the point that divides the edge of two vertices.
Vec3 on_edge(const Triangle& triangle, Index from, Index to, float share) {
  Vec3 weights = Vec3::Zero();
  for (int m = 0; m < 3; ++m) {
    if (triangle[m] == from) weights[m] = 1 - share;
    if (triangle[m] == to) weights[m] = share;
  }
  return weights;
}

TEST(CrossTexture, ShowsTheSameOnBothSidesOfEveryEdge) {
  for (const char* shape : {"sphere,resolution=16", "box,resolution=15", "mobius,resolution=12"}) {
    const Crossed c = textured_crosses(shape);
    const Mesh& mesh = c.texture.surface.mesh;
    std::map<std::pair<Index, Index>, std::vector<std::size_t>> triangles_of;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      for (int m = 0; m < 3; ++m) {
        const Index a = mesh.triangles[t][m], b = mesh.triangles[t][(m + 1) % 3];
        triangles_of[{std::min(a, b), std::max(a, b)}].push_back(t);
      }
    }
    std::size_t compared = 0;
    for (const auto& [edge, triangles] : triangles_of) {
      // Cuts of singular triangles are where the texture turns.
      if (triangles.size() != 2 || edge.second >= c.surface.mesh.vertex_count()) continue;
      for (const float share : {0.1f, 0.5f, 0.8f}) {
        const auto shown = [&](std::size_t t) {
          return shown_at(c.texture.pattern.waves, t,
                          on_edge(mesh.triangles[t], edge.first, edge.second, share));
        };
        const auto left = shown(triangles[0]), right = shown(triangles[1]);
        ASSERT_NEAR(left[0], right[0], 1e-3) << shape;
        ASSERT_NEAR(left[1], right[1], 1e-3) << shape;
        ++compared;
      }
    }
    EXPECT_GT(compared, mesh.triangle_count());
  }
}

TEST(CrossTexture, SplitsSingularTrianglesAtTheirBarycentre) {
  const Crossed c = textured_crosses("sphere,resolution=16");
  const std::size_t singular = c.cross.cover.singular.size();
  ASSERT_GE(singular, 8u);
  const Mesh& mesh = c.texture.surface.mesh;
  EXPECT_EQ(mesh.triangle_count(), c.surface.mesh.triangle_count() + 2 * singular);
  EXPECT_EQ(mesh.vertex_count(), c.surface.mesh.vertex_count() + singular);
  EXPECT_EQ(c.texture.pattern.waves.triangle_count(), mesh.triangle_count());
  EXPECT_EQ(c.texture.pattern.u.waves.positions, mesh.positions);
  for (std::size_t t = mesh.triangle_count() - 3 * singular; t < mesh.triangle_count(); ++t) {
    EXPECT_EQ(c.texture.pattern.u.corners[t].kind, TriangleKind::field_singularity);
    for (const CornerWave& corner : c.texture.pattern.waves.u[t]) {
      EXPECT_NEAR(corner.wave.direction.norm(), 1, 1e-4);
      EXPECT_NEAR(std::abs(corner.z), 1, 1e-4);
    }
  }
}

TEST(CrossTexture, VRunsToTheLeftOfU) {
  const Crossed c = textured_crosses("torus,resolution=60");
  const TextureWaves& waves = c.texture.pattern.waves;
  const Mesh& mesh = c.texture.surface.mesh;
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const Vec3 turn = waves.u[t][0].wave.direction.cross(waves.v[t][0].wave.direction);
    EXPECT_GT(turn.dot(triangle_normal(mesh, mesh.triangles[t])), 0);
  }
}

TEST(CrossTexture, IsSquareOnAPlane) {
  const Crossed c = textured_crosses("plane,resolution=40");
  EXPECT_EQ(c.texture.pattern.quality.measured_triangles, c.surface.mesh.triangle_count());
  EXPECT_LT(c.texture.pattern.quality.angle_95th_deg, 0.5);
  EXPECT_LT(c.texture.pattern.quality.area_95th, 0.01);
}

TEST(CrossTexture, IsMeasuredFarFromBranchesAndSingularitiesAlone) {
  for (const char* shape : {"sphere,resolution=16", "box,resolution=15"}) {
    const Crossed c = textured_crosses(shape);
    ASSERT_FALSE(c.cross.cover.singular.empty()) << shape;
    const auto &u = c.texture.pattern.u.corners, &v = c.texture.pattern.v.corners;
    const Mesh& mesh = c.texture.surface.mesh;
    std::vector<bool> near(mesh.vertex_count());
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      if (u[t].kind == TriangleKind::regular && v[t].kind == TriangleKind::regular) continue;
      for (const Index vertex : mesh.triangles[t]) near[vertex] = true;
    }
    const auto far = std::ranges::count_if(mesh.triangles, [&](const Triangle& t) {
      return !near[t[0]] && !near[t[1]] && !near[t[2]];
    });
    EXPECT_EQ(c.texture.pattern.quality.measured_triangles, static_cast<std::size_t>(far)) << shape;
  }
}

TEST(CrossTexture, ShowsTheSameHoweverCrossesAreNamed) {
  const Crossed c = textured_crosses("torus,resolution=50");
  CrossPattern turned = c.cross;
  // The same pattern, wave (i, 1) under the name (i, 0) at every other vertex.
  const auto renamed = [](Index node) { return node ^ ((node / 2) % 2); };
  WaveSet crosses = c.cross.cover.waves;
  for (Index node = 0; node < crosses.directions.size(); ++node) {
    crosses.directions[renamed(node)] = c.cross.cover.waves.directions[node];
    turned.pattern.solution.z[renamed(node)] = c.cross.pattern.solution.z[node];
  }
  turned.cover = cross_cover(*c.surface.neighborhood, c.surface.mesh.triangles, crosses);
  const CrossTexture texture = cross_texture(c.surface, turned);
  for (std::size_t t = 0; t < texture.surface.mesh.triangle_count(); ++t) {
    const Vec3 weights(0.2f, 0.3f, 0.5f);
    const auto before = shown_at(c.texture.pattern.waves, t, weights);
    const auto after = shown_at(texture.pattern.waves, t, weights);
    ASSERT_NEAR(before[0], after[0], 1e-3);
    ASSERT_NEAR(before[1], after[1], 1e-3);
  }
}

}  // namespace
}  // namespace brindle
