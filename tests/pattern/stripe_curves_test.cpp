#include "brindle/pattern/stripe_curves.h"

#include <cmath>
#include <filesystem>
#include <numeric>
#include <random>
#include <set>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/base/parallel.h"
#include "brindle/files/mesh_io.h"
#include "brindle/pattern/fragment_phase.h"
#include "brindle/phases/solver.h"
#include "phase_graphs.h"
#include "test_meshes.h"

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::wavy_surface;
using testing_support::WavySurface;

constexpr float kTwoPi = 6.2831853f;

struct Solved {
  WavySurface surface;
  MeshEdges edges;
  std::vector<Complex> z;

  explicit Solved(WavySurface wavy, std::vector<Complex> phases = {})
      : surface(std::move(wavy)),
        edges(mesh_edges(surface.mesh, *surface.neighborhood)),
        z(std::move(phases)) {
    if (z.empty()) z = solve_phases(surface.graph()).z;
  }
  WavePattern pattern() const { return {surface.mesh, edges, surface.normals, surface.waves, z}; }
  StripeCurves curves(const CurveOptions& options = {}) const {
    return stripe_curves(LiftedWaves(pattern()), options);
  }
};

std::size_t count(const StripeCurves& curves, CurveEnd end) {
  return curves.end_counts()[static_cast<std::size_t>(end)];
}

std::size_t open_curves(const StripeCurves& curves) {
  const auto& closed = curves.lines.closed;
  return closed.size() - std::accumulate(closed.begin(), closed.end(), std::size_t{0});
}

Solved plane_wave(const std::string& shape, float stripes, const Vec3& axis = Vec3(1, 0.5f, 0)) {
  WavySurface surface = wavy_surface(shape, axis, stripes);
  std::vector<Complex> z;
  for (std::size_t i = 0; i < surface.mesh.vertex_count(); ++i) {
    const float along = surface.waves.directions[i].dot(surface.mesh.positions[i]);
    z.push_back(std::polar(1.0f, kTwoPi * surface.waves.frequencies[i] * along));
  }
  return Solved(std::move(surface), std::move(z));
}

WavySurface with_axis(const Mesh& mesh, const Vec3& axis, float stripes) {
  WavySurface surface;
  surface.mesh = mesh;
  surface.normals = vertex_normals(mesh);
  surface.neighborhood = std::make_shared<const Adjacency>(vertex_neighborhood(mesh));
  surface.waves = {
      mesh.positions, projected_direction_field(axis, surface.normals),
      constant_frequency_field(frequency_of_stripes(stripes, bounding_box(mesh).diagonal()),
                               mesh.vertex_count())};
  return surface;
}

/// The sums that the ends must balance with, triangle by triangle and edge by edge.
struct Expected {
  std::size_t boundary = 0, branch = 0, singular = 0, nonmanifold = 0;
};

Expected expected_ends(const Solved& solved) {
  const WavePattern pattern = solved.pattern();
  Expected expected;
  std::vector<StripePiece> pieces;
  for (std::size_t t = 0; t < pattern.mesh.triangle_count(); ++t) {
    const Triangle& corners = pattern.mesh.triangles[t];
    const auto waves = corner_waves(corners, pattern.waves, pattern.z);
    const LiftedTriangle triangle = lifted_triangle(corners, waves);
    expected.branch += static_cast<std::size_t>(std::abs(triangle.branch_index));
    for (int m = 0; m < 3; ++m) {
      const Index sharing = pattern.edges.triangle_counts[pattern.edges.of_triangle[t][m]];
      const auto peaks = static_cast<std::size_t>(std::abs(triangle.edges[m].peaks));
      if (sharing == 1) expected.boundary += peaks;
      if (sharing > 2) expected.nonmanifold += peaks;
    }
    if (triangle.kind != TriangleKind::field_singularity) continue;
    stripe_pieces(triangle, false, pieces);
    for (const StripePiece& piece : pieces) {
      expected.singular += piece.ends[1].side == PieceEnd::kInside;
    }
  }
  return expected;
}

void expect_balance(const Solved& solved) {
  const StripeCurves curves = solved.curves();
  const Expected expected = expected_ends(solved);
  EXPECT_EQ(count(curves, CurveEnd::boundary), expected.boundary);
  EXPECT_EQ(count(curves, CurveEnd::branch), expected.branch);
  EXPECT_EQ(count(curves, CurveEnd::singularity), expected.singular);
  EXPECT_EQ(count(curves, CurveEnd::nonmanifold), expected.nonmanifold);
  EXPECT_EQ(count(curves, CurveEnd::no_wave), 0u);
  EXPECT_EQ(2 * open_curves(curves),
            expected.boundary + expected.branch + expected.singular + expected.nonmanifold);
}

TEST(StripeCurves, OfAPlaneWaveAreItsPeaksAtAnyFrequency) {
  for (const float stripes : {4.0f, 40.0f, 200.0f}) {
    const Solved solved = plane_wave("plane,resolution=12", stripes);
    const StripeCurves curves = solved.curves();
    const Vec3 d = solved.surface.waves.directions[0];
    const float f = solved.surface.waves.frequencies[0];
    std::set<int> peaks;
    for (std::size_t line = 0; line < curves.lines.count(); ++line) {
      EXPECT_EQ(curves.ends[line][0], CurveEnd::boundary);
      EXPECT_EQ(curves.ends[line][1], CurveEnd::boundary);
      const auto points = curves.lines.points_of(line);
      const int peak = static_cast<int>(std::lround(f * d.dot(points[0]) - 0.25f));
      EXPECT_TRUE(peaks.insert(peak).second) << "two curves for one peak";
      for (const Vec3& p : points) EXPECT_NEAR(f * d.dot(p) - 0.25f, peak, 2e-3f);
    }
    const auto extent = [&](float sign) {
      float most = -1e9f;
      for (const Vec3& p : solved.surface.mesh.positions) most = std::max(most, sign * d.dot(p));
      return sign * most;
    };
    const int expected =
        static_cast<int>(std::floor(f * extent(1) - 0.25f) - std::ceil(f * extent(-1) - 0.25f)) + 1;
    EXPECT_NEAR(static_cast<int>(peaks.size()), expected, 1);
  }
}

TEST(StripeCurves, AreNeverLostWhereVerticesLieOnPeaks) {
  // Every fourth row of vertices is on a peak exactly.
  Solved solved = plane_wave("plane,resolution=16", 5, Vec3(1, 0, 0));
  const float step = 1.0f / 4;
  std::set<float> columns;
  for (const Vec3& p : solved.surface.mesh.positions) columns.insert(p.x());
  for (std::size_t i = 0; i < solved.z.size(); ++i) {
    const auto column =
        std::distance(columns.begin(), columns.find(solved.surface.mesh.positions[i].x()));
    solved.z[i] = std::polar(1.0f, kTwoPi * (step * static_cast<float>(column) + 0.25f));
    solved.z[i] = Complex(std::round(solved.z[i].real()), std::round(solved.z[i].imag()));
  }
  const float width = *std::next(columns.begin()) - *columns.begin();
  for (float& f : solved.surface.waves.frequencies) f = step / width;
  const StripeCurves curves = solved.curves();
  const std::size_t last = columns.size() - 1;
  EXPECT_EQ(curves.lines.count(), last / 4 + (last % 4 != 0 || last == 0));
  EXPECT_EQ(count(curves, CurveEnd::boundary), 2 * curves.lines.count());
}

TEST(StripeCurves, EndsBalanceOnEveryShapeAndFrequency) {
  for (const auto& [name, mesh] : every_shape()) {
    for (const float stripes : {7.0f, 60.0f}) {
      SCOPED_TRACE(name + " " + std::to_string(stripes));
      expect_balance(Solved(with_axis(mesh, Vec3(0.31f, 0.9f, 0.27f), stripes)));
    }
  }
}

TEST(StripeCurves, EndsBalanceForRandomPhases) {
  WavySurface surface = wavy_surface("sphere", Vec3(0.1f, 1, 0.2f), 25);
  std::mt19937 random(1);
  std::vector<Complex> z;
  for (std::size_t i = 0; i < surface.mesh.vertex_count(); ++i) {
    z.push_back(std::polar(1.0f, std::uniform_real_distribution<float>(0, kTwoPi)(random)));
  }
  expect_balance(Solved(std::move(surface), std::move(z)));
}

TEST(StripeCurves, EndsBalanceOnRealModels) {
  const std::string spot = BRINDLE_SHARED_MODELS "/spot.obj";
  if (!std::filesystem::exists(spot)) GTEST_SKIP() << spot << " is not there";
  const Mesh mesh = read_mesh(spot).mesh;
  for (const float stripes : {20.0f, 100.0f, 400.0f}) {
    expect_balance(Solved(with_axis(mesh, Vec3(0, 1, 0.2f), stripes)));
  }
}

TEST(StripeCurves, DoNotCareWhichWayDirectionsPoint) {
  Solved solved(wavy_surface("torus,resolution=48", Vec3(0, 0.3f, 1), 30));
  const StripeCurves before = solved.curves();
  const auto turned = flip_half(solved.surface.waves, 9);
  for (std::size_t i = 0; i < turned.size(); ++i) {
    if (turned[i]) solved.z[i] = -std::conj(solved.z[i]);
  }
  const StripeCurves after = solved.curves();
  EXPECT_EQ(before.lines.points, after.lines.points);
  EXPECT_EQ(before.lines.offsets, after.lines.offsets);
  EXPECT_EQ(before.ends, after.ends);
}

TEST(StripeCurves, DoNotDependOnThreads) {
  const Solved solved(wavy_surface("trefoil", Vec3(0, 0.3f, 1), 60));
  const auto with = [&](int threads) {
    const ThreadLimit limit(threads);
    return solved.curves();
  };
  const StripeCurves one = with(1), two = with(2);
  EXPECT_EQ(one.lines.points, two.lines.points);
  EXPECT_EQ(one.lines.normals, two.lines.normals);
  EXPECT_EQ(one.lines.offsets, two.lines.offsets);
  EXPECT_EQ(one.ends, two.ends);
}

TEST(StripeCurves, EndWhereThereIsNoWave) {
  Solved solved = plane_wave("plane,resolution=12", 20);
  for (std::size_t i = 0; i < solved.z.size(); ++i) {
    if (solved.surface.mesh.positions[i].head<2>().norm() < 0.3f) {
      solved.surface.waves.directions[i].setZero();
    }
  }
  const StripeCurves curves = solved.curves();
  EXPECT_GT(count(curves, CurveEnd::no_wave), 0u);
  EXPECT_EQ(count(curves, CurveEnd::no_wave) + count(curves, CurveEnd::boundary),
            2 * open_curves(curves));
}

TEST(StripeCurves, EndAtEdgesOfThreeTriangles) {
  // Three fins around the x axis, with a wave along it.
  WavySurface surface;
  surface.mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 1}, {0, -1, -1}},
                  {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  surface.neighborhood = std::make_shared<const Adjacency>(vertex_neighborhood(surface.mesh));
  surface.normals.assign(5, Vec3(0, 0, 1));
  surface.waves = {surface.mesh.positions, std::vector<Vec3>(5, Vec3(1, 0, 0)),
                   std::vector<float>(5, 3.0f)};
  const Solved solved(std::move(surface), std::vector<Complex>(5, Complex(1, 0)));
  const StripeCurves curves = solved.curves();
  ASSERT_EQ(curves.lines.count(), 9u) << "three peaks on each fin";
  EXPECT_EQ(count(curves, CurveEnd::nonmanifold), 9u);
  // Phases 0 at both ends of an edge without length along the wave: no peaks there.
  EXPECT_EQ(count(curves, CurveEnd::boundary), 9u);
}

TEST(StripeCurves, PointsAreOnPeaksOfTheDrawnPattern) {
  const Solved solved(wavy_surface("torus,resolution=64", Vec3(0.2f, 0.3f, 1), 30));
  std::size_t points = 0, off = 0;
  std::vector<StripePiece> pieces;
  for (const Triangle& t : solved.surface.mesh.triangles) {
    const auto corners = corner_waves(t, solved.surface.waves, solved.z);
    stripe_pieces(lifted_triangle(t, corners), false, pieces);
    for (const StripePiece& piece : pieces) {
      const auto& b = piece.ends[0].barycentric;
      const Vec3 barycentric = Eigen::Vector3d(b[0], b[1], b[2]).cast<float>();
      off += fragment_phase(corners, barycentric).z.imag() < 0.95f;
      ++points;
    }
  }
  EXPECT_GT(points, 1000u);
  // Beside branches the drawn phase is far from linear along an edge.
  EXPECT_LT(static_cast<double>(off), 0.02 * static_cast<double>(points));
}

TEST(StripeCurves, JoinedCurvesHaveFewerEnds) {
  const Solved solved(wavy_surface("sphere,resolution=8", Vec3(0.1f, 1, 0.2f), 90));
  const StripeCurves apart = solved.curves(), joined = solved.curves({.join = true});
  EXPECT_LE(joined.lines.count(), apart.lines.count());
  const auto inner = [](const StripeCurves& curves) {
    return count(curves, CurveEnd::branch) + count(curves, CurveEnd::singularity);
  };
  EXPECT_LT(inner(joined), inner(apart));
  EXPECT_EQ(inner(joined) % 2, inner(apart) % 2);
}

TEST(StripeCurves, LongerThanLeavesOutShorterOnes) {
  const Solved solved(wavy_surface("torus,resolution=64", Vec3(0.1f, 1, 0.2f), 40));
  const StripeCurves all = solved.curves();
  const float limit = 0.8f;
  const StripeCurves some = longer_than(all, limit);
  std::size_t expected = 0;
  for (std::size_t line = 0; line < all.lines.count(); ++line) {
    expected += length_of(all.lines, line) >= limit;
  }
  EXPECT_GT(expected, 0u);
  EXPECT_LT(expected, all.lines.count());
  EXPECT_EQ(some.lines.count(), expected);
  EXPECT_EQ(some.ends.size(), expected);
  EXPECT_EQ(some.lines.points.size(), some.lines.offsets.back());
}

TEST(MovePeaks, ByHalfAPeriodNeedsNoOrientation) {
  Solved solved(wavy_surface("mobius", Vec3(0, 0, 1), 20));
  const std::vector<Vec3> directions = solved.surface.waves.directions;
  EXPECT_EQ(move_peaks(*solved.surface.neighborhood, 0.5f, solved.surface.waves, solved.z), 0u);
  EXPECT_EQ(solved.surface.waves.directions, directions);
  const StripeCurves gaps = solved.curves();
  EXPECT_EQ(move_peaks(*solved.surface.neighborhood, -1.5f, solved.surface.waves, solved.z), 0u);
  EXPECT_NEAR(static_cast<double>(solved.curves().lines.count()),
              static_cast<double>(gaps.lines.count()), 6);
  expect_balance(solved);
}

TEST(MovePeaks, ByAnyShareMovesCurvesForward) {
  for (const float periods : {0.25f, 0.5f, 0.7f, -0.1f}) {
    Solved solved = plane_wave("plane,resolution=12", 20);
    const auto turned = flip_half(solved.surface.waves, 3);
    for (std::size_t i = 0; i < turned.size(); ++i) {
      if (turned[i]) solved.z[i] = -std::conj(solved.z[i]);
    }
    EXPECT_EQ(move_peaks(*solved.surface.neighborhood, periods, solved.surface.waves, solved.z),
              0u);
    const Vec3 d = solved.surface.waves.directions[0];
    const float f = solved.surface.waves.frequencies[0];
    // The first direction decides which way is forward; the wave itself runs along the axis.
    const float forward = d.x() > 0 ? periods : -periods;
    for (const Vec3& p : solved.curves().lines.points) {
      const float turns = f * (d.x() > 0 ? 1 : -1) * d.dot(p) - 0.25f - forward;
      EXPECT_NEAR(turns, std::round(turns), 2e-3f);
    }
  }
}

TEST(MovePeaks, SaysAcrossHowManyEdgesDirectionsDoNotAgree) {
  // The field makes half a turn on its way round the ring.
  WavySurface surface = wavy_surface("torus,resolution=64", Vec3(0, 0, 1), 20);
  for (std::size_t i = 0; i < surface.mesh.vertex_count(); ++i) {
    const Vec3& p = surface.mesh.positions[i];
    const float around = std::atan2(p.y(), p.x());
    const Vec3 along(-p.y(), p.x(), 0);
    const Vec3& n = surface.normals[i];
    const Vec3 t = along.normalized();
    surface.waves.directions[i] =
        std::cos(around / 2) * t + std::sin(around / 2) * Vec3(n.cross(t)).normalized();
  }
  Solved solved(std::move(surface));
  EXPECT_GT(move_peaks(*solved.surface.neighborhood, 0.25f, solved.surface.waves, solved.z), 0u);
  expect_balance(solved);
}

}  // namespace
}  // namespace brindle
