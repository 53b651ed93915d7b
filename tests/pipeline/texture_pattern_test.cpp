#include "brindle/texture_pattern.h"

#include <filesystem>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "bad_waves.h"
#include "brindle/error.h"
#include "brindle/files.h"
#include "brindle/smooth_field.h"
#include "textures.h"

namespace brindle {
namespace {

using namespace testing_support;

Vec3 point_on_edge(Index from, Index to, float share) {
  Vec3 barycentric = Vec3::Zero();
  barycentric[from % 3] = 1 - share;
  barycentric[to % 3] = share;
  return barycentric;
}

/// How far apart both sides of the edges are, at three points of every one.
struct EdgeJumps {
  float stripes = 0;       ///< largest difference of sin Phi of U
  float symmetric = 0;     ///< of both phases, the texture turned by 180 degrees where that helps
  std::size_t turned = 0;  ///< edges where it does
  std::size_t torn = 0;    ///< edges where neither helps, see `is_torn`
};

float jump(const FragmentWave& a, const FragmentWave& b, bool turn) {
  return std::abs(a.z - (turn ? -std::conj(b.z) : b.z));
}

/// Between phases that nearly cancel any rounding decides.
bool is_steady(const TextureWaves& waves, Index t, const Vec3& point, const Vec3& aside) {
  const TextureFragment here = texture_fragment(waves.u[t], waves.v[t], point);
  const TextureFragment there = texture_fragment(waves.u[t], waves.v[t], point + 1e-4f * aside);
  return jump(here.u, there.u, false) < 0.02f && jump(here.v, there.v, false) < 0.02f;
}

/// At every `stride`-th edge; all torn ones are counted.
EdgeJumps jumps_at_edges(const Mesh& mesh, const TextureWaves& waves, std::size_t stride = 1) {
  EdgeJumps jumps;
  std::size_t number = 0;
  for (const SharedEdge& edge : shared_edges(mesh.triangles)) {
    const Index a = edge.from[0] / 3, b = edge.from[1] / 3;
    const bool torn = is_torn(waves, edge);
    jumps.torn += torn;
    if (number++ % stride != 0) continue;
    for (const float share : {0.2f, 0.5f, 0.9f}) {
      const Vec3 in_a = point_on_edge(edge.from[0], edge.to[0], share);
      const Vec3 in_b = point_on_edge(edge.from[1], edge.to[1], share);
      const Vec3 along =
          point_on_edge(edge.from[0], edge.to[0], 1) - point_on_edge(edge.from[0], edge.to[0], 0);
      if (!is_steady(waves, a, in_a, along)) continue;
      const auto [u_a, v_a] = texture_fragment(waves.u[a], waves.v[a], in_a);
      const auto [u_b, v_b] = texture_fragment(waves.u[b], waves.v[b], in_b);
      jumps.stripes = std::max(jumps.stripes, std::abs(u_a.z.imag() - u_b.z.imag()));
      const float as_it_is = std::max(jump(u_a, u_b, false), jump(v_a, v_b, false));
      const float turned = std::max(jump(u_a, u_b, true), jump(v_a, v_b, true));
      if (torn) continue;
      jumps.symmetric = std::max(jumps.symmetric, std::min(as_it_is, turned));
      jumps.turned += share == 0.5f && turned < as_it_is;
    }
  }
  return jumps;
}

TEST(TexturePattern, NoEdgeShowsASeamInStripesOrSymmetricTextures) {
  for (const char* shape :
       {"torus,resolution=40", "sphere,resolution=10", "trefoil,resolution=12", "molecule,atoms=4",
        "plane,resolution=30,noise=0.3", "torus,resolution=40,noise=0.4"}) {
    const Surface surface = make_surface(make_shape(shape));
    const TexturePattern pattern =
        texture_pattern(surface, waves_of(surface, smooth_direction_field(surface), 25));
    const EdgeJumps jumps = jumps_at_edges(surface.mesh, pattern.waves);
    EXPECT_LT(jumps.stripes, 2e-3f) << shape;
    EXPECT_LT(jumps.symmetric, 2e-3f) << shape;
    EXPECT_LE(jumps.turned, pattern.seams.turned + 6 * pattern.seams.unoriented_triangles);
    EXPECT_LT(jumps.torn, surface.mesh.triangle_count() / 500) << shape;
  }
}

TEST(TexturePattern, NoEdgeShowsASeamWhereCornersCannotBeOrientedAlike) {
  const Surface surface = make_surface(make_shape("plane,resolution=20"));
  for (const float index : {0.5f, -0.5f, 1.0f, -1.0f}) {
    const TexturePattern pattern =
        texture_pattern(surface, waves_of(surface, singular_field(surface.mesh, index), 20));
    if (std::abs(index) < 1) {
      EXPECT_EQ(pattern.seams.unoriented_triangles, 1u) << index;
    }
    const EdgeJumps jumps = jumps_at_edges(surface.mesh, pattern.waves);
    EXPECT_LT(jumps.stripes, 1e-3f) << index;
    EXPECT_LT(jumps.symmetric, 1e-3f) << index;
  }
}

TEST(TexturePattern, ArrowsPointAlongTheVectorsOfAnOrientedField) {
  const Surface surface = make_surface(make_shape("plane,resolution=60"));
  const DirectionField vectors = singular_field(surface.mesh, 1);
  const TexturePattern pattern =
      texture_pattern(surface, waves_of(surface, vectors, 20), {.oriented = true});
  std::size_t along = 0;
  for (std::size_t t = 0; t < pattern.waves.triangle_count(); ++t) {
    const FragmentWave wave =
        texture_fragment(pattern.waves.u[t], pattern.waves.v[t], Vec3(0.4f, 0.3f, 0.3f)).u;
    const Triangle& triangle = surface.mesh.triangles[t];
    along +=
        wave.direction.dot(vectors[triangle[0]] + vectors[triangle[1]] + vectors[triangle[2]]) > 0;
  }
  EXPECT_GE(along + pattern.seams.unoriented_triangles, pattern.waves.triangle_count());
  EXPECT_EQ(pattern.seams.turned, 0u);
}

TEST(TexturePattern, OrientedFieldsKeepTheirSignsWhereTheyRunAgainstEachOther) {
  const Surface surface = make_surface(make_shape("plane,resolution=40"));
  DirectionField shear;
  for (const Vec3& p : surface.mesh.positions) {
    shear.push_back(p.y() > 0.01f ? Vec3::UnitX() : Vec3(-Vec3::UnitX()));
  }
  const TexturePattern kept =
      texture_pattern(surface, waves_of(surface, shear, 20), {.oriented = true});
  EXPECT_GT(kept.seams.turned, 30u);  // all along the line where they turn
  for (std::size_t t = 0; t < kept.waves.triangle_count(); ++t) {
    const Triangle& triangle = surface.mesh.triangles[t];
    const bool same =
        shear[triangle[0]] == shear[triangle[1]] && shear[triangle[0]] == shear[triangle[2]];
    if (same) {
      EXPECT_EQ(kept.waves.u[t][0].wave.direction, shear[triangle[0]]);
    }
  }
  const TexturePattern line = texture_pattern(surface, waves_of(surface, shear, 20));
  EXPECT_EQ(line.seams.turned, 0u);
}

/// How far U is from a phase over a turn plus a quarter, or from minus that, up to whole tiles.
float off_phase(float u, Complex z) {
  const float turns = texture_coordinate(z);
  const auto off = [](float tiles) { return std::abs(tiles - std::round(tiles)); };
  return std::min(off(u - turns), off(u + turns));
}

class StripeCoordinates : public testing::TestWithParam<bool> {};  // oriented

INSTANTIATE_TEST_SUITE_P(Both, StripeCoordinates, testing::Bool());

TEST_P(StripeCoordinates, ArePhasesAcrossAndOneRowOfTheTile) {
  for (const char* shape : {"torus,resolution=60", "sphere,resolution=10", "sheets"}) {
    const Surface surface = make_surface(make_shape(shape));
    const StripePattern pattern =
        stripe_pattern(surface, waves_of(surface, smooth_direction_field(surface), 25));
    const TexturedMesh textured =
        texture_coordinates(surface, pattern, PhaseShiftKind::aligned, GetParam());
    ASSERT_EQ(textured.triangle_origins.size(), textured.mesh.triangle_count());
    std::vector<std::uint8_t> used(textured.mesh.vertex_count());
    for (std::size_t t = 0; t < textured.mesh.triangle_count(); ++t) {
      if (pattern.corners[textured.triangle_origins[t]].kind == TriangleKind::no_wave) continue;
      for (const Index v : textured.mesh.triangles[t]) used[v] = 1;
    }
    for (std::size_t v = 0; v < used.size(); ++v) {
      const auto& [a, b, c] = textured.origins[v];
      if (!used[v]) continue;
      EXPECT_NEAR(textured.coordinates[v].y(), 0.5f, 1e-6f) << shape;
      if (a == b) {
        EXPECT_LT(off_phase(textured.coordinates[v].x(), pattern.solution.z[a]), 1e-4f) << shape;
      }
    }
    // But for barycentres, few vertices are added: nearly all triangles share those they have.
    EXPECT_LT(textured.mesh.vertex_count() - textured.split_triangles,
              surface.mesh.vertex_count() * 4 / 3)
        << shape;
  }
}

/// Of the linear function with these values at the corners, up to a positive factor.
Vec3 gradient_of(const std::array<Vec3, 3>& corner, const std::array<float, 3>& value) {
  const Vec3 normal = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
  return normal.cross((value[1] - value[0]) * (corner[0] - corner[2]) +
                      (value[2] - value[0]) * (corner[1] - corner[0]));
}

// Signs that are meant are kept: U grows along the vectors.
TEST(OrientedStripeCoordinates, GrowAlongTheVectors) {
  const Surface surface = make_surface(make_shape("torus,resolution=60"));
  std::vector<Vec3> vectors;
  for (const Vec3& p : surface.mesh.positions) vectors.emplace_back(-p.y(), p.x(), 0.2f);
  const StripePattern pattern =
      stripe_pattern(surface, tangent_directions(vectors, surface.normals), 10);
  const TexturedMesh textured =
      texture_coordinates(surface, pattern, PhaseShiftKind::aligned, true);
  std::size_t compared = 0;
  for (std::size_t t = 0; t < textured.mesh.triangle_count(); ++t) {
    if (pattern.corners[textured.triangle_origins[t]].kind != TriangleKind::regular) continue;
    std::array<Vec3, 3> corners;
    std::array<float, 3> u;
    Vec3 along = Vec3::Zero();
    for (std::size_t m = 0; m < 3; ++m) {
      const Index v = textured.mesh.triangles[t][m];
      corners[m] = textured.mesh.positions[v];
      u[m] = textured.coordinates[v].x();
      along += pattern.waves.directions[textured.origins[v][0]];
    }
    ASSERT_GT(gradient_of(corners, u).dot(along), 0) << "in triangle " << t;
    ++compared;
  }
  EXPECT_GT(compared, textured.mesh.triangle_count() / 2);
}

TEST(StripeArrays, TrianglesAndArraysKeepTheirOrigins) {
  const Surface surface = make_surface(make_shape("sphere,resolution=10"));
  const StripePattern pattern =
      stripe_pattern(surface, waves_of(surface, smooth_direction_field(surface), 25));
  const TexturedMesh textured = texture_coordinates(surface, pattern);
  ASSERT_GT(textured.split_triangles, 0u);
  std::vector<std::int64_t> numbers(surface.mesh.triangle_count());
  for (std::size_t t = 0; t < numbers.size(); ++t) numbers[t] = static_cast<std::int64_t>(t);
  const DataArrays arrays = carried_arrays(
      textured,
      {{make_data_array("p", surface.mesh.positions)}, {make_data_array("t", 1, numbers)}});
  // Points are linear in themselves: carried positions are the positions.
  const std::vector<Vec3> carried = vectors_of(arrays.points[0].view(), "p");
  for (std::size_t v = 0; v < carried.size(); ++v) {
    EXPECT_LT((carried[v] - textured.mesh.positions[v]).norm(), 1e-6f);
  }
  ASSERT_EQ(arrays.cells[0].rows(), textured.mesh.triangle_count());
  for (std::size_t t = 0; t < textured.mesh.triangle_count(); ++t) {
    const Triangle& whole = surface.mesh.triangles[textured.triangle_origins[t]];
    for (const Index v : textured.mesh.triangles[t]) {
      for (const Index origin : textured.origins[v]) {
        EXPECT_NE(std::find(whole.begin(), whole.end(), origin), whole.end());
      }
    }
  }
  EXPECT_THROW(texture_coordinates(make_surface(make_shape("torus")), pattern), Error);
}

TEST(TexturePattern, TilesOfAPlaneAreRectanglesOfTheWantedSize) {
  const Surface surface = make_surface(make_shape("plane,resolution=40"));
  TextureOptions options;
  const float along = 20 / bounding_box(surface.mesh).diagonal();
  for (const float across : {along, 0.5f * along, 3 * along}) {
    options.frequencies_v = constant_frequency_field(across, surface.mesh.vertex_count());
    const TexturePattern pattern = texture_along(surface, Vec3(2, 1, 0), 20, options);
    EXPECT_EQ(pattern.quality.measured_triangles, surface.mesh.triangle_count());
    EXPECT_LT(pattern.quality.angle_95th_deg, 0.1);
    EXPECT_LT(pattern.quality.area_95th, 0.01);
    EXPECT_EQ(pattern.v.waves.frequencies[7], across);
  }
}

TEST(TexturePattern, FrequenciesOfVMayDifferFromVertexToVertex) {
  const Surface surface = make_surface(make_shape("plane,resolution=80"));
  TextureOptions options;
  for (const Vec3& p : surface.mesh.positions) options.frequencies_v.push_back(10 + 4 * p.x());
  const TexturePattern pattern = texture_along(surface, Vec3(1, 0, 0), 20, options);
  EXPECT_EQ(pattern.u.quality.branches, 0u);
  EXPECT_GT(pattern.v.quality.branches, 0u);  // more lines at one end than at the other
  EXPECT_LT(pattern.quality.area_mean, 0.1);
}

TEST(TexturePattern, ACheckerboardStaysSquareOnShapes) {
  const std::pair<const char*, double> limits[] = {
      {"cylinder,resolution=120", 0.2}, {"torus,resolution=150", 6}, {"trefoil,resolution=30", 8}};
  for (const auto& [shape, mean_deg] : limits) {
    const Surface surface = make_surface(make_shape(shape));
    DirectionField field = smooth_direction_field(surface);
    if (shape[0] == 'c') field = projected_direction_field(Vec3(0, 0, 1), surface.normals);
    const TexturePattern pattern = texture_pattern(surface, waves_of(surface, field, 40));
    EXPECT_LT(pattern.quality.angle_mean_deg, mean_deg) << shape;
    EXPECT_GT(pattern.quality.measured_triangles, surface.mesh.triangle_count() / 2) << shape;
  }
}

TEST(TexturePattern, ACheckerboardStaysSquareOnTheHorse) {
  const std::filesystem::path path = BRINDLE_SHARED_MODELS "/horse.ply";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not here";
  const Surface surface = make_surface(read_mesh(path).mesh);
  const TexturePattern pattern =
      texture_pattern(surface, waves_of(surface, smooth_direction_field(surface), 40));
  EXPECT_LT(pattern.quality.angle_mean_deg, 8);
  EXPECT_LT(pattern.quality.angle_95th_deg, 25);
  EXPECT_LT(pattern.quality.area_mean, 0.25);
  const EdgeJumps jumps = jumps_at_edges(surface.mesh, pattern.waves, 7);
  EXPECT_LT(jumps.symmetric, 5e-3f);
  EXPECT_LT(jumps.torn, 50u);  // of 145,449
}

TEST(TexturePattern, RefusesValuesThatNoWaveHas) {
  const Surface torus = make_surface(make_shape("torus,resolution=20"));
  const WaveSet waves = waves_of(torus, projected_direction_field(Vec3(1, 2, 0), torus.normals), 9);
  testing_support::expect_refused(waves, 5,
                                  [&](const WaveSet& bad) { texture_pattern(torus, bad); });
  WaveSet upright = waves, few = waves;
  upright.directions[4] = torus.normals[4];
  EXPECT_THROW(texture_pattern(torus, upright), Error);
  few.directions.pop_back();
  EXPECT_THROW(texture_pattern(torus, few), Error);
  TextureOptions options;
  options.frequencies_v = waves.frequencies;
  options.frequencies_v[7] = -1;
  EXPECT_THROW(texture_pattern(torus, waves, options), Error);
}

TEST(TexturePattern, CountsVerticesWithoutAWave) {
  const Surface torus = make_surface(make_shape("torus,resolution=20"));
  WaveSet waves = waves_of(torus, projected_direction_field(Vec3(1, 2, 0), torus.normals), 9);
  waves.directions[3].setZero();
  const TexturePattern pattern = texture_pattern(torus, waves);
  EXPECT_EQ(pattern.u.quality.vertices_without_wave, 1u);
  EXPECT_EQ(pattern.v.quality.vertices_without_wave, 1u);
}

TEST(TexturePattern, RefusesFrequenciesForAnotherNumberOfVertices) {
  const Surface surface = make_surface(make_shape("plane,resolution=8"));
  TextureOptions options;
  options.frequencies_v = {1, 2, 3};
  EXPECT_THROW(texture_along(surface, Vec3(1, 0, 0), 10, options), Error);
}

}  // namespace
}  // namespace brindle
