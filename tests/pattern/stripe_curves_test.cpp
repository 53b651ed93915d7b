#include "brindle/pattern/stripe_curves.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <random>
#include <set>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/files.h"
#include "brindle/fragment_phase.h"
#include "brindle/solver.h"
#include "lifted_corners.h"
#include "phase_graphs.h"
#include "test_meshes.h"

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::lifted_triangle;
using testing_support::wavy_surface;
using testing_support::WavySurface;

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
  /// As traced, unless `options` say otherwise.
  StripeCurves curves(const CurveOptions& options = {.trim = 0}) const {
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
      const Index sharing = pattern.edges.triangle_count(pattern.edges.of_triangle[t][m]);
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
    return solved.curves({.join = true});
  };
  const StripeCurves one = with(1), two = with(2);
  EXPECT_EQ(one.lines.points, two.lines.points);
  EXPECT_EQ(one.lines.normals, two.lines.normals);
  EXPECT_EQ(one.lines.offsets, two.lines.offsets);
  EXPECT_EQ(one.ends, two.ends);
}

Vec3 position_at(const Mesh& mesh, Index triangle, const std::array<double, 3>& barycentric) {
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  for (std::size_t m = 0; m < 3; ++m) {
    EXPECT_GE(barycentric[m], 0);
    p += barycentric[m] * mesh.positions[mesh.triangles[triangle][m]].cast<double>();
  }
  EXPECT_NEAR(barycentric[0] + barycentric[1] + barycentric[2], 1, 1e-12);
  return p.cast<float>();
}

float longest_edge(const Mesh& mesh) {
  float longest = 0;
  for (const Triangle& t : mesh.triangles) {
    for (int m = 0; m < 3; ++m) {
      longest = std::max(longest, (mesh.positions[t[m]] - mesh.positions[t[(m + 1) % 3]]).norm());
    }
  }
  return longest;
}

/// Points must be where they are said to be, and segments within their triangles, but where points
/// of them were passed over (`kSamePlace` of an edge).
void expect_placed(const Mesh& mesh, const Polylines& lines) {
  ASSERT_EQ(lines.places.size(), lines.points.size());
  const float rounding = 4e-7f * bounding_box(mesh).diagonal();
  const float passed_over = 1e-4f * longest_edge(mesh) + rounding;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    for (Index i = lines.offsets[line]; i < lines.offsets[line + 1]; ++i) {
      const TrianglePoint& place = lines.places[i];
      ASSERT_LE((position_at(mesh, place.triangle, place.barycentric) - lines.points[i]).norm(),
                passed_over)
          << "point " << i - lines.offsets[line] << " of "
          << lines.offsets[line + 1] - lines.offsets[line];
      const bool last = i + 1 == lines.offsets[line + 1];
      if (lines.arrivals.empty() || (last && !lines.closed[line])) continue;
      const Vec3& next = lines.points[last ? lines.offsets[line] : i + 1];
      ASSERT_LE((position_at(mesh, place.triangle, lines.arrivals[i]) - next).norm(), passed_over);
    }
  }
}

TEST(StripeCurves, KnowWhereTheyAreOnTheMesh) {
  for (const auto& [name, mesh] : every_shape()) {
    const Solved solved(with_axis(mesh, Vec3(0.31f, 0.9f, 0.27f), 40));
    for (const bool join : {false, true}) {
      SCOPED_TRACE(name + (join ? " joined" : ""));
      const StripeCurves curves = solved.curves({.join = join});
      expect_placed(mesh, curves.lines);
      expect_placed(mesh, longer_than(curves, 0.1f * bounding_box(mesh).diagonal()).lines);
      const Polylines even = resampled(curves.lines, 0.013f * bounding_box(mesh).diagonal());
      expect_placed(mesh, even);
      expect_placed(mesh, simplified(even, 1e-3f * bounding_box(mesh).diagonal()));
    }
  }
}

TEST(StripeCurves, NearlyAllPointsArePlacedToRounding) {
  const Solved solved(wavy_surface("trefoil", Vec3(0, 0.3f, 1), 60));
  const Mesh& mesh = solved.surface.mesh;
  const Polylines lines = resampled(solved.curves().lines, 0.02f);
  std::size_t off = 0;
  for (std::size_t i = 0; i < lines.points.size(); ++i) {
    const Vec3 there = position_at(mesh, lines.places[i].triangle, lines.places[i].barycentric);
    off += (there - lines.points[i]).norm() > 4e-7f * bounding_box(mesh).diagonal();
  }
  EXPECT_GT(lines.points.size(), 1000u);
  EXPECT_LE(off, lines.points.size() / 100);
}

TEST(StripeCurves, OnFinsPointsAreOnTheirOwnFin) {
  WavySurface surface;
  surface.mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 1}, {0, -1, -1}},
                  {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}};
  surface.neighborhood = std::make_shared<const Adjacency>(vertex_neighborhood(surface.mesh));
  surface.normals.assign(5, Vec3(0, 0, 1));
  surface.waves = {surface.mesh.positions, std::vector<Vec3>(5, Vec3(1, 0, 0)),
                   std::vector<float>(5, 3.0f)};
  const Solved solved(std::move(surface), std::vector<Complex>(5, Complex(1, 0)));
  const Polylines lines = solved.curves().lines;
  expect_placed(solved.surface.mesh, lines);
  std::array<int, 3> on_fin{};
  for (std::size_t line = 0; line < lines.count(); ++line) {
    ++on_fin[lines.places[lines.offsets[line]].triangle];
    EXPECT_EQ(lines.places[lines.offsets[line]].triangle,
              lines.places[lines.offsets[line + 1] - 1].triangle);
  }
  EXPECT_EQ(on_fin, (std::array<int, 3>{3, 3, 3}));
}

float shortest_edge(const Solved& solved) {
  float shortest = 1e9f;
  for (const auto& [a, b] : solved.edges.vertices) {
    const auto& positions = solved.surface.mesh.positions;
    shortest = std::min(shortest, (positions[a] - positions[b]).norm());
  }
  return shortest;
}

/// But for open curves of two points: both ends stay.
void expect_distinct_points(const Solved& solved, const CurveOptions& options = {.trim = 0}) {
  const float least = 0.99e-4f * shortest_edge(solved);
  const Polylines lines = solved.curves(options).lines;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const auto points = lines.points_of(line);
    ASSERT_GE(points.size(), lines.closed[line] ? 3u : 2u);
    if (points.size() == 2) continue;
    for (std::size_t i = lines.closed[line] ? 0 : 1; i < points.size(); ++i) {
      const Vec3& before = points[i > 0 ? i - 1 : points.size() - 1];
      ASSERT_GT((points[i] - before).norm(), least) << "line " << line << ", point " << i;
    }
  }
}

TEST(StripeCurves, HaveNoTwoPointsAtOnePlace) {
  for (const auto& [name, mesh] : every_shape()) {
    for (const Vec3& axis : {Vec3(0.31f, 0.9f, 0.27f), Vec3(0, 0, 1)}) {
      const Solved solved(with_axis(mesh, axis, 40));
      for (const bool join : {false, true}) {
        SCOPED_TRACE(name + (join ? " joined" : ""));
        expect_distinct_points(solved, {.join = join});
      }
    }
  }
}

TEST(StripeCurves, HaveNoTwoPointsAtOnePlaceWhereTheyPassThroughVertices) {
  // Every row of vertices around the tube is nearly on a peak, a little above or below.
  WavySurface surface = wavy_surface("cylinder,resolution=40", Vec3(0, 0, 1), 30);
  std::set<float> rows;
  for (const Vec3& p : surface.mesh.positions) rows.insert(p.z());
  const float step = *std::next(rows.begin()) - *rows.begin();
  for (float& f : surface.waves.frequencies) f = 1 / step;
  std::mt19937 random(2);
  std::vector<Complex> z;
  for (std::size_t i = 0; i < surface.mesh.vertex_count(); ++i) {
    const float noise = std::uniform_real_distribution<float>(-3e-6f, 3e-6f)(random);
    z.push_back(std::polar(1.0f, kTwoPi * (0.25f + noise)));
  }
  const Solved solved(std::move(surface), std::move(z));
  expect_distinct_points(solved);
  expect_balance(solved);
  const StripeCurves curves = solved.curves();
  const auto closed = curves.lines.count() - open_curves(curves);
  EXPECT_GE(closed, rows.size() - 2);
}

/// Rings along or across a ring or tube around the z axis, with directions that point either way.
Solved rings(const std::string& shape, bool along) {
  Mesh mesh = make_shape(shape);
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), std::mt19937(6));
  WavySurface surface = wavy_surface(std::move(mesh), Vec3(0, 0, 1), 30);
  for (std::size_t i = 0; i < surface.mesh.vertex_count(); ++i) {
    const Vec3& p = surface.mesh.positions[i];
    const Vec3 around = Vec3(-p.y(), p.x(), 0).normalized();
    surface.waves.directions[i] = along ? Vec3(surface.normals[i].cross(around)) : around;
  }
  flip_half(surface.waves, 5);
  return Solved(std::move(surface));
}

/// How the line runs around an axis through `centre`: twice the area that it goes round.
float circulation(std::span<const Vec3> points, const Vec3& centre, const Vec3& axis) {
  float area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& next = points[(i + 1) % points.size()];
    area += (points[i] - centre).cross(next - centre).dot(axis);
  }
  return area;
}

/// The rings that run either way.
std::array<int, 2> senses(const StripeCurves& curves, bool along) {
  std::array<int, 2> count{};
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    const auto points = curves.lines.points_of(line);
    Vec3 centre = Vec3::Zero();
    for (const Vec3& p : points) centre += p / static_cast<float>(points.size());
    if (along) centre.setZero();
    const Vec3 axis = along ? Vec3(0, 0, 1) : Vec3(-centre.y(), centre.x(), 0);
    ++count[circulation(points, centre, axis) > 0];
  }
  return count;
}

TEST(StripeCurves, NeighboursRunTheSameWay) {
  for (const std::string shape : {"torus,resolution=64", "cylinder,resolution=48"}) {
    for (const bool along : {true, false}) {
      if (shape.starts_with("cylinder") && !along) continue;
      SCOPED_TRACE(shape + (along ? " along" : " across"));
      Solved solved = rings(shape, along);
      const StripeCurves curves = solved.curves();
      const auto [one, other] = senses(curves, along);
      EXPECT_GT(one + other, 8);
      EXPECT_EQ(std::min(one, other), 0) << "of " << one + other;
      const auto turned = flip_half(solved.surface.waves, 11);
      for (std::size_t i = 0; i < turned.size(); ++i) {
        if (turned[i]) solved.z[i] = -std::conj(solved.z[i]);
      }
      EXPECT_EQ(solved.curves().lines.points, curves.lines.points);
    }
  }
}

TEST(StripeCurves, RunWithTheWaveToTheirLeft) {
  // On a plane seen from +z, with waves that run along +x.
  const StripeCurves curves = plane_wave("plane,resolution=12", 10, Vec3(1, 0, 0)).curves();
  EXPECT_GT(curves.lines.count(), 3u);
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    const auto points = curves.lines.points_of(line);
    EXPECT_LT(points.back().y(), points.front().y());
  }
}

TEST(StripeCurves, StartsOfNeighbouringRingsLineUp) {
  const StripeCurves curves = rings("cylinder,resolution=48", true).curves();
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    ASSERT_TRUE(curves.lines.closed[line]);
    const Vec3& start = curves.lines.points_of(line)[0];
    EXPECT_NEAR(std::atan2(start.y(), start.x()), std::atan2(0.48f, 0.36f), kTwoPi / 48);
  }
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
  const Solved solved(wavy_surface("torus,resolution=24", Vec3(0.1f, 1, 0.2f), 90));
  const StripeCurves apart = solved.curves(), joined = solved.curves({.join = true});
  EXPECT_LE(joined.lines.count(), apart.lines.count());
  const auto inner = [](const StripeCurves& curves) {
    return count(curves, CurveEnd::branch) + count(curves, CurveEnd::singularity);
  };
  EXPECT_LT(inner(joined), inner(apart));
  EXPECT_EQ(joined.joined_ends, inner(apart) - inner(joined));
  EXPECT_EQ(apart.joined_ends, 0u);
  EXPECT_EQ(inner(joined) % 2, inner(apart) % 2);
}

float distance_to_lines(const Polylines& lines, const Vec3& p) {
  float least = 1e9f;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const auto points = lines.points_of(line);
    for (std::size_t i = lines.closed[line] ? 0 : 1; i < points.size(); ++i) {
      const Vec3& before = points[i > 0 ? i - 1 : points.size() - 1];
      least = std::min(least, distance_to_segment(p, before, points[i]));
    }
  }
  return least;
}

std::vector<Vec3> inner_end_points(const StripeCurves& curves) {
  std::vector<Vec3> found;
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    const auto points = curves.lines.points_of(line);
    for (int end = 0; end < 2; ++end) {
      const CurveEnd kind = curves.ends[line][end];
      if (kind != CurveEnd::branch && kind != CurveEnd::singularity) continue;
      found.push_back(end == 0 ? points.front() : points.back());
    }
  }
  return found;
}

TEST(StripeCurves, JoinedCurvesRunOnIntoTheirNeighbours) {
  for (const std::string shape : {"trefoil", "torus,resolution=96", "box,resolution=20"}) {
    SCOPED_TRACE(shape);
    const Solved solved(wavy_surface(shape, Vec3(0.31f, 0.9f, 0.27f), 60));
    const StripeCurves apart = solved.curves(), joined = solved.curves({.join = true});
    const float tolerance = 1e-3f / solved.surface.waves.frequencies[0];
    const std::vector<Vec3> before = inner_end_points(apart), after = inner_end_points(joined);
    ASSERT_GE(before.size(), 10u);
    EXPECT_EQ(joined.joined_ends + after.size(), before.size());
    EXPECT_EQ(apart.ends_at_neighbors, 0u);
    const auto touching = std::count_if(after.begin(), after.end(), [&](const Vec3& p) {
      const bool moved = std::none_of(before.begin(), before.end(), [&](const Vec3& end) {
        return (p - end).norm() < tolerance;
      });
      return moved && distance_to_lines(apart.lines, p) < tolerance;
    });
    EXPECT_GT(static_cast<std::size_t>(touching), after.size() * 9 / 10);
    EXPECT_NEAR(static_cast<double>(joined.ends_at_neighbors), static_cast<double>(touching),
                0.05 * static_cast<double>(after.size()));
  }
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
  EXPECT_EQ(shift_phases(*solved.surface.neighborhood, 0.5f, solved.surface.waves, solved.z), 0u);
  EXPECT_EQ(solved.surface.waves.directions, directions);
  const StripeCurves gaps = solved.curves();
  EXPECT_EQ(shift_phases(*solved.surface.neighborhood, -1.5f, solved.surface.waves, solved.z), 0u);
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
    EXPECT_EQ(shift_phases(*solved.surface.neighborhood, periods, solved.surface.waves, solved.z),
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
  EXPECT_GT(shift_phases(*solved.surface.neighborhood, 0.25f, solved.surface.waves, solved.z), 0u);
  expect_balance(solved);
}

}  // namespace
}  // namespace brindle
