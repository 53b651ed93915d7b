#include "brindle/cross_cover.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/error.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::wavy_surface;
using testing_support::WavySurface;

CrossCover cover_of(const WavySurface& s) {
  return cross_cover(*s.neighborhood, s.mesh.triangles, cross_waves(s.waves, s.normals));
}

/// Crosses that turn by an arbitrary angle from vertex to vertex.
WavySurface rough_surface() {
  WavySurface s = wavy_surface("torus,resolution=40", Vec3(0.3f, 0.9f, 0.2f), 12);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> angle(0, 6.2831853f);
  for (std::size_t i = 0; i < s.normals.size(); ++i) {
    s.waves.directions[i] = Eigen::AngleAxisf(angle(random), s.normals[i]) * s.waves.directions[i];
  }
  return s;
}

bool are_neighbors(const Adjacency& adjacency, Index a, Index b) {
  const auto row = adjacency.of(a);
  return std::binary_search(row.begin(), row.end(), b);
}

/// A plane whose cross turns by `quarters` quarters around a point inside one of its triangles.
WavySurface plane_with_singularity(int quarters) {
  WavySurface s = wavy_surface("plane,resolution=21", Vec3(1, 0, 0), 8);
  const Vec3 centre(0.013f, 0.021f, 0);
  for (std::size_t i = 0; i < s.normals.size(); ++i) {
    const Vec3 p = s.mesh.positions[i] - centre;
    const float angle = static_cast<float>(quarters) * std::atan2(p.y(), p.x()) / 4;
    s.waves.directions[i] = Vec3(std::cos(angle), std::sin(angle), 0);
  }
  return s;
}

/// Two crosses at the ends of an edge along which the surface bends by so much about the y axis;
/// in their planes they stand at these angles against it.
WaveSet crosses_at_a_bend(float bend_deg, float angle_deg, float other_deg) {
  const float radians = 3.14159265f / 180;
  const Eigen::AngleAxisf bend(bend_deg * radians, Vec3::UnitY());
  const auto direction = [&](float degrees) {
    return Vec3(std::sin(degrees * radians), std::cos(degrees * radians), 0);
  };
  const WaveSet waves = {
      {Vec3::Zero(), Vec3::UnitX()}, {direction(angle_deg), bend * direction(other_deg)}, {1, 1}};
  return cross_waves(waves, std::vector<Vec3>{Vec3::UnitZ(), bend * Vec3::UnitZ()});
}

TEST(CrossCover, PairsCrossesAsTheyRunOverABendHoweverSharp) {
  for (const float bend : {0.0f, 30.0f, 80.0f, 100.0f, 110.0f}) {
    for (const float angle : {0.0f, 30.0f, 60.0f, 85.0f}) {
      SCOPED_TRACE(std::to_string(bend) + ", " + std::to_string(angle));
      EXPECT_EQ(matching_wave(crosses_at_a_bend(bend, angle, angle + 20), 0, 1), 0u);
      EXPECT_EQ(matching_wave(crosses_at_a_bend(bend, angle, angle + 70), 0, 1), 1u);
      EXPECT_EQ(matching_wave(crosses_at_a_bend(bend, angle, angle + 70), 1, 0), 1u);
      EXPECT_EQ(matching_wave(crosses_at_a_bend(bend, angle, angle + 180), 0, 1), 0u);
    }
  }
}

TEST(CrossCover, WavesOfACrossAreOrthogonalUnitTangents) {
  const WavySurface s = rough_surface();
  const WaveSet crosses = cross_waves(s.waves, s.normals);
  for (Index i = 0; i < s.normals.size(); ++i) {
    EXPECT_EQ(crosses.directions[2 * i], s.waves.directions[i]);
    const Vec3& second = crosses.directions[2 * i + 1];
    EXPECT_NEAR(second.norm(), 1, 1e-5);
    EXPECT_NEAR(second.dot(s.normals[i]), 0, 1e-5);
    EXPECT_NEAR(second.dot(s.waves.directions[i]), 0, 1e-5);
  }
}

TEST(CrossCover, MatchingIsTheSameFromBothSidesAndOneToOne) {
  const WavySurface s = rough_surface();
  const CrossCover cover = cover_of(s);
  const Adjacency& nodes = *cover.neighborhood;
  ASSERT_EQ(nodes.node_count(), 2 * s.neighborhood->node_count());
  ASSERT_EQ(nodes.edge_count(), 2 * s.neighborhood->edge_count());
  std::size_t crossed = 0;
  for (Index a = 0; a < nodes.node_count(); ++a) {
    EXPECT_TRUE(std::ranges::is_sorted(nodes.of(a)));
    for (const Index b : nodes.of(a)) {
      ASSERT_TRUE(are_neighbors(*s.neighborhood, a / 2, b / 2));
      ASSERT_TRUE(are_neighbors(nodes, b, a));
      ASSERT_TRUE(are_neighbors(nodes, other_wave(a), other_wave(b)));
      ASSERT_FALSE(are_neighbors(nodes, a, other_wave(b)));
      crossed += (a ^ b) & 1u;
    }
  }
  EXPECT_GT(crossed, 0u);
}

TEST(CrossCover, EdgesJoinTheBestAlignedWaves) {
  const WavySurface s = plane_with_singularity(1);
  const CrossCover cover = cover_of(s);
  const auto& d = cover.waves.directions;
  for (Index a = 0; a < d.size(); ++a) {
    for (const Index b : cover.neighborhood->of(a)) {
      EXPECT_GE(std::abs(d[a].dot(d[b])) + 1e-6f, std::abs(d[a].dot(d[other_wave(b)])));
    }
  }
}

TEST(CrossCover, QuarterTurnsOnlyChangeTheNamesOfWaves) {
  const WavySurface s = rough_surface();
  WavySurface turned = s;
  std::mt19937 random(5);
  std::vector<Index> turn(s.normals.size());
  for (Index i = 0; i < turn.size(); ++i) {
    turn[i] = random() % 2;
    if (turn[i]) turned.waves.directions[i] = s.normals[i].cross(s.waves.directions[i]);
  }
  const auto renamed = [&](Index node) { return node ^ turn[node / 2]; };
  const CrossCover before = cover_of(s), after = cover_of(turned);
  EXPECT_EQ(before.singular, after.singular);
  EXPECT_EQ(before.base, after.base);
  for (Index a = 0; a < before.waves.directions.size(); ++a) {
    EXPECT_NEAR(std::abs(before.waves.directions[a].dot(after.waves.directions[renamed(a)])), 1,
                1e-5);
    for (const Index b : before.neighborhood->of(a)) {
      ASSERT_TRUE(are_neighbors(*after.neighborhood, renamed(a), renamed(b)));
    }
  }

  // Phases renamed alike have the same energy: a wave turned twice by a quarter runs back.
  std::uniform_real_distribution<float> angle(0, 6.2831853f);
  std::vector<Complex> z(before.waves.directions.size()), z_after(z.size());
  for (Index a = 0; a < z.size(); ++a) {
    z[a] = std::polar(1.0f, angle(random));
    const bool back = before.waves.directions[a].dot(after.waves.directions[renamed(a)]) < 0;
    z_after[renamed(a)] = back ? -std::conj(z[a]) : z[a];
  }
  EXPECT_NEAR(energy(build_phase_graph(before.neighborhood, before.waves), z),
              energy(build_phase_graph(after.neighborhood, after.waves), z_after), 1e-6);
}

TEST(CrossCover, OfAConstantFieldIsTwoSeparateSheets) {
  const WavySurface s = wavy_surface("plane,resolution=12", Vec3(1, 2, 0), 8);
  const CrossCover cover = cover_of(s);
  EXPECT_TRUE(cover.singular.empty());
  ASSERT_EQ(cover.u().size(), s.mesh.triangle_count());
  for (std::size_t t = 0; t < s.mesh.triangle_count(); ++t) {
    for (std::size_t m = 0; m < 3; ++m) {
      EXPECT_EQ(cover.u()[t][m], 2 * s.mesh.triangles[t][m]);
      EXPECT_EQ(cover.v()[t][m], 2 * s.mesh.triangles[t][m] + 1);
    }
  }
}

TEST(CrossCover, TrianglesAreJoinedAlongMatchedEdges) {
  const WavySurface s = rough_surface();
  const CrossCover cover = cover_of(s);
  EXPECT_EQ(cover.base.size() + cover.singular.size(), s.mesh.triangle_count());
  EXPECT_GT(cover.singular.size(), 0u);
  for (const Triangle& t : cover.triangles) {
    for (std::size_t m = 0; m < 3; ++m) {
      ASSERT_TRUE(are_neighbors(*cover.neighborhood, t[m], t[(m + 1) % 3]));
    }
  }
}

TEST(CrossCover, ASingularityOfOneQuarterTakesOneTriangleAndLargerOnesSeveral) {
  EXPECT_TRUE(cover_of(plane_with_singularity(0)).singular.empty());
  EXPECT_EQ(cover_of(plane_with_singularity(1)).singular.size(), 1u);
  EXPECT_EQ(cover_of(plane_with_singularity(-1)).singular.size(), 1u);
  // Along an edge a cross turns by less than half a quarter, or it is taken for another turn.
  for (const int quarters : {-4, -3, -2, 2, 3, 4}) {
    const std::size_t count = cover_of(plane_with_singularity(quarters)).singular.size();
    const auto least = static_cast<std::size_t>(std::abs(quarters));
    EXPECT_GE(count, least) << quarters;
    EXPECT_LE(count, least + 6) << quarters;
    EXPECT_EQ(count % 2, least % 2) << quarters;
  }
}

TEST(CrossCover, RefusesWavesOfAnotherSurface) {
  const WavySurface s = wavy_surface("plane,resolution=5", Vec3(1, 0, 0), 5);
  EXPECT_THROW(cross_cover(*s.neighborhood, s.mesh.triangles, s.waves), Error);
}

}  // namespace
}  // namespace brindle
