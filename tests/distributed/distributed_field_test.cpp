#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "brindle/carried_phases.h"
#include "brindle/direction_field.h"
#include "brindle/distributed_surface.h"
#include "brindle/error.h"
#include "brindle/normals.h"
#include "brindle/smooth_field.h"
#include "brindle/surface.h"
#include "ranks.h"
#include "test_meshes.h"

namespace brindle {
namespace {

using namespace testing_support;
using Points = std::vector<Eigen::Vector3d>;

/// Of the owners, on all ranks. Others have the same bits.
std::vector<Vec3> gathered(const Parts& parts, const DistributedSurface& surface,
                           const DirectionField& of_piece) {
  const std::vector<Vec3> all = parts.gathered(std::span<const Vec3>(of_piece), surface.is_own());
  EXPECT_EQ(of_piece, parts.of_piece(all));
  return all;
}

/// A plane that is folded by 90 degrees along its middle.
Mesh roof() {
  Mesh mesh = make_shape("plane,resolution=24");
  const Vec3 size = bounding_box(mesh).upper - bounding_box(mesh).lower;
  Eigen::Index flat = 0, across = 0;
  size.minCoeff(&flat);
  size.maxCoeff(&across);
  const float middle = (bounding_box(mesh).upper + bounding_box(mesh).lower)[across] / 2;
  for (Vec3& p : mesh.positions) p[flat] -= std::abs(p[across] - middle);
  return mesh;
}

/// All that a smooth field may follow.
std::vector<SmoothFieldOptions> smooth_fields(const Mesh& mesh) {
  const float diagonal = bounding_box(mesh).diagonal();
  SmoothFieldOptions plain, crosses, curved, sharp, beside, afar;
  crosses.symmetry = 4;
  curved.curvature_anchor = 0.1f;
  sharp.feature_anchor = beside.feature_anchor = 2;
  beside.feature_radius = 0.03f * diagonal;
  afar.normal_radius = 0.02f * diagonal;
  std::vector<SmoothFieldOptions> fields = {plain, crosses, curved, sharp, beside, afar};
  for (SmoothFieldOptions options : {curved, sharp, beside}) {
    options.normal_radius = afar.normal_radius;
    fields.push_back(options);
  }
  return fields;
}

// Shapes with boundaries and sharp edges, of one side, and whose triangles share an edge by threes.
TEST(DistributedField, IsThatOfOneProcessHoweverASurfaceIsCut) {
  for (Mesh& mesh :
       std::vector<Mesh>{make_shape("vessels,resolution=20"), make_shape("mobius,resolution=12"),
                         make_shape("sheets,resolution=12"), roof()}) {
    const WavySurface wavy = wavy_surface(std::move(mesh), kAxis, 20);
    const Surface whole = make_surface(wavy.mesh);
    const std::vector<SmoothFieldOptions> fields = smooth_fields(wavy.mesh);
    std::vector<DirectionField> expected;
    for (const auto& options : fields) expected.push_back(smooth_direction_field(whole, options));
    for (const Cut& cut : cuts()) {
      const Parts parts(wavy, cut.rank_of_triangle(wavy.mesh));
      const DistributedSurface surface = parts.surface();
      for (std::size_t i = 0; i < fields.size(); ++i) {
        SCOPED_TRACE(std::string(cut.name) + ", field " + std::to_string(i));
        EXPECT_EQ(gathered(parts, surface, smooth_direction_field(surface, fields[i])),
                  expected[i]);
      }
    }
  }
}

/// A surface of vessels that widens and narrows, at one of its steps.
WavySurface beating(int step) {
  WavySurface wavy = wavy_surface("vessels,resolution=20", kAxis, 20);
  const float wider = 1 + 0.02f * static_cast<float>(step);
  for (Vec3& p : wavy.mesh.positions) p = {wider * p.x(), p.y() / wider, p.z()};
  return wavy;
}

TEST(DistributedField, FollowsTheOneBeforeAsThatOfOneProcess) {
  const Surface last = make_surface(beating(0).mesh);
  const DirectionField before = smooth_direction_field(last);
  const WavySurface wavy = beating(1);
  const Surface whole = make_surface(wavy.mesh);
  SmoothFieldOptions options;
  options.last.directions = matched_directions({last.mesh, last.normals, before}, whole);
  for (const bool uncertain : {false, true}) {
    options.last.confidence.assign(uncertain ? options.last.directions.size() : 0, 0.5f);
    const DirectionField expected = smooth_direction_field(whole, options);
    ASSERT_NE(expected, smooth_direction_field(whole));
    for (const Cut& cut : cuts()) {
      SCOPED_TRACE(cut.name);
      const Parts parts(wavy, cut.rank_of_triangle(wavy.mesh));
      const DistributedSurface surface = parts.surface();
      SmoothFieldOptions of_piece;
      of_piece.last.directions = parts.of_piece(options.last.directions);
      if (uncertain) of_piece.last.confidence = parts.of_piece(options.last.confidence);
      // What is said of others' vertices does not count.
      for (std::size_t v = 0; v < parts.ids.size(); ++v) {
        if (!surface.is_own()[v]) of_piece.last.directions[v] = Vec3(1, 2, 3);
      }
      EXPECT_EQ(gathered(parts, surface, smooth_direction_field(surface, of_piece)), expected);
    }
  }
}

TEST(DistributedField, RefusesOnAllRanksWhatOneRankGetsWrong) {
  const Parts parts(wavy_surface("torus,resolution=16", kAxis, 20));
  const DistributedSurface surface = parts.surface();
  const bool is_wrong = rank() == rank_count() - 1;
  SmoothFieldOptions options;
  if (is_wrong) options.anchors = {{static_cast<Index>(parts.ids.size()), Vec3(1, 0, 0)}};
  EXPECT_THROW(smooth_direction_field(surface, options), Error);
  options = {};
  options.last.directions.assign(parts.ids.size() + (is_wrong ? 1 : 0), Vec3(1, 0, 0));
  EXPECT_THROW(smooth_direction_field(surface, options), Error);
  if (rank_count() == 1) return;
  options.last.directions.assign(is_wrong ? 0 : parts.ids.size(), Vec3(1, 0, 0));
  EXPECT_THROW(smooth_direction_field(surface, options), Error);
}

TEST(DistributedField, OfCurvatureIsThatOfOneProcess) {
  const WavySurface wavy = wavy_surface("torus,resolution=30", kAxis, 20);
  const auto curvatures =
      principal_curvatures(wavy.mesh.positions, wavy.normals, *wavy.neighborhood);
  DirectionField expected = curvature_direction_field(curvatures, CurvatureDirection::minimum);
  orient_alike(*wavy.neighborhood, expected);
  for (const Cut& cut : cuts()) {
    SCOPED_TRACE(cut.name);
    const Parts parts(wavy, cut.rank_of_triangle(wavy.mesh));
    const DistributedSurface surface = parts.surface();
    EXPECT_EQ(
        gathered(parts, surface, curvature_direction_field(surface, CurvatureDirection::minimum)),
        expected);
    const std::vector<float> greatest = greatest_curvatures(surface);
    ASSERT_EQ(greatest.size(), parts.ids.size());
    for (std::size_t v = 0; v < greatest.size(); ++v) {
      EXPECT_EQ(greatest[v], curvatures[parts.ids[v]].maximum);
    }
  }
}

/// A ring above a torus, where edges are as near as triangles; one through vertices; one with a
/// radius below the edges' lengths; and one that meets itself.
std::vector<FieldStroke> strokes_on(const Mesh& torus) {
  FieldStroke ring{{}, 0.2, 3}, through{{}, 0.3, 1}, thin{{}, 1e-4, 2}, again{{}, 0.35, 0.5};
  for (int i = 0; i <= 40; ++i) {
    const double angle = 0.15 * i;
    ring.points.emplace_back(1.03 * std::cos(angle), 1.03 * std::sin(angle), 0.003 * i);
  }
  for (std::size_t v = 0; v < 60; v += 7) {
    through.points.push_back(torus.positions[v].cast<double>() + torus.origin);
  }
  for (const double x : {0.2, 0.25, 0.3})
    thin.points.emplace_back(0.7 * std::cos(x), 0.7 * std::sin(x), 0.3);
  again.points = {{-0.6, 0.4, 0.28}, {-0.6, -0.4, 0.28}, {-0.5, 0, 0.25}, {-0.6, 0.4, 0.28}};
  return {ring, through, thin, again};
}

TEST(DistributedStrokes, AreThoseOfTheWholeHoweverItIsCut) {
  WavySurface torus = wavy_surface("torus,resolution=40", kAxis, 20);
  torus.mesh.origin = {100, -20, 3};
  std::vector<FieldStroke> strokes = strokes_on(make_shape("torus,resolution=40"));
  for (FieldStroke& stroke : strokes) {
    for (Eigen::Vector3d& point : stroke.points) point += torus.mesh.origin;
  }
  const std::vector<FieldAnchor> expected = stroke_anchors(make_surface(torus.mesh), strokes);
  ASSERT_GT(expected.size(), 100u);
  for (const Cut& cut : cuts()) {
    SCOPED_TRACE(cut.name);
    const Parts parts(torus, cut.rank_of_triangle(torus.mesh));
    const DistributedSurface surface = parts.surface();
    std::vector<std::vector<FieldAnchor>> at(torus.mesh.vertex_count());
    for (const FieldAnchor& anchor : expected) at[anchor.vertex].push_back(anchor);
    std::vector<std::size_t> next(at.size());
    for (const FieldAnchor& anchor : stroke_anchors(surface, strokes)) {
      const std::uint64_t id = parts.ids[anchor.vertex];
      ASSERT_LT(next[id], at[id].size());
      const FieldAnchor& whole = at[id][next[id]++];
      EXPECT_EQ(anchor.direction, whole.direction);
      EXPECT_EQ(anchor.weight, whole.weight);
    }
    for (const std::uint64_t id : parts.ids) EXPECT_EQ(next[id], at[id].size());
  }
}

TEST(DistributedStrokes, DrawTheFieldOfAllRanks) {
  const WavySurface torus = wavy_surface("torus,resolution=40", kAxis, 20);
  const std::vector<FieldStroke> strokes = strokes_on(torus.mesh);
  const Surface whole = make_surface(torus.mesh);
  SmoothFieldOptions options;
  options.anchors = stroke_anchors(whole, strokes);
  const DirectionField expected = smooth_direction_field(whole, options);
  ASSERT_NE(expected, smooth_direction_field(whole));
  for (const Cut& cut : cuts()) {
    SCOPED_TRACE(cut.name);
    const Parts parts(torus, cut.rank_of_triangle(torus.mesh));
    const DistributedSurface surface = parts.surface();
    options.anchors = stroke_anchors(surface, strokes);
    EXPECT_EQ(gathered(parts, surface, smooth_direction_field(surface, options)), expected);
  }
}

/// Edges of a box, and boundaries of a tube and a plane, as lines from corner to corner.
TEST(DistributedStrokes, AlongFeaturesAreThoseOfTheWhole) {
  constexpr float kAngle = 15;
  for (const char* shape : {"box,resolution=12", "tube,resolution=14", "plane,resolution=9"}) {
    const WavySurface wavy = wavy_surface(shape, kAxis, 20);
    const Surface whole = make_surface(wavy.mesh);
    const std::vector<FieldStroke> expected = feature_strokes(whole, kAngle, 0.2, 3);
    ASSERT_FALSE(expected.empty());
    for (const Cut& cut : cuts()) {
      SCOPED_TRACE(std::string(shape) + ", " + cut.name);
      const Parts parts(wavy, cut.rank_of_triangle(wavy.mesh));
      const DistributedSurface surface = parts.surface();
      EXPECT_EQ(feature_strokes(surface, kAngle, 0.2, 3), expected);
    }
  }
}

TEST(DistributedStrokes, AreRefusedWithTheWordsOfOneProcess) {
  const Parts parts(wavy_surface("torus,resolution=20", kAxis, 20));
  const DistributedSurface surface = parts.surface();
  const Surface whole = make_surface(parts.whole.mesh);
  const auto message = [](const auto& call) {
    try {
      call();
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const std::vector<FieldStroke> good = {{Points{{0.7, 0, 0.3}, {0.7, 0.2, 0.3}}, 0.2, 1}};
  for (const FieldStroke& wrong :
       {FieldStroke{Points{{0.7, 0, 0.3}, {5, 3, 0.3}}, 0.2, 1},
        FieldStroke{Points{{1, 0, 0}, {-1, 0, 0}}, 0.2, 1},
        FieldStroke{Points(1, {0.7, 0, 0.3}), 0.2, 1}, FieldStroke{good[0].points, -1, 1}}) {
    const std::vector<FieldStroke> strokes = {good[0], wrong};
    const std::string expected = message([&] { stroke_anchors(whole, strokes); });
    const std::string refusal = message([&] { stroke_anchors(surface, strokes); });
    EXPECT_NE(expected, "accepted");
    EXPECT_NE(refusal.find(expected), std::string::npos) << refusal;
  }
  EXPECT_TRUE(stroke_anchors(surface, {}).empty());
  SmoothFieldOptions options;
  options.anchors.push_back({static_cast<Index>(parts.ids.size()), kAxis});
  EXPECT_THROW(smooth_direction_field(surface, options), Error);
}

}  // namespace
}  // namespace brindle
