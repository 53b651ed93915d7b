#include <cmath>

#include <gtest/gtest.h>

#include "brindle/distributed_surface.h"
#include "brindle/error.h"
#include "brindle/smooth_field.h"
#include "brindle/surface.h"
#include "ranks.h"

namespace brindle {
namespace {

using namespace testing_support;
using Points = std::vector<Eigen::Vector3d>;

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
  for (const Cut& cut : kCuts) {
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
  options.curvature_anchor = 0.1f;
  options.anchors = stroke_anchors(whole, {strokes.data(), 1});
  for (FieldAnchor& anchor : options.anchors) anchor.weight *= 1000;
  const DirectionField expected = smooth_direction_field(whole, options);
  const std::vector<FieldAnchor> anchors = options.anchors;
  for (const Cut& cut : kCuts) {
    SCOPED_TRACE(cut.name);
    const Parts parts(torus, cut.rank_of_triangle(torus.mesh));
    const DistributedSurface surface = parts.surface();
    options.anchors = stroke_anchors(surface, {strokes.data(), 1});
    for (FieldAnchor& anchor : options.anchors) anchor.weight *= 1000;
    const DirectionField field = smooth_direction_field(surface, options);
    if (rank_count() == 1) {
      EXPECT_TRUE(same_bits(std::span<const Vec3>(field), std::span<const Vec3>(expected)));
    }
    std::vector<float> weight(whole.mesh.vertex_count());
    for (const FieldAnchor& anchor : anchors) weight[anchor.vertex] = anchor.weight;
    for (std::size_t v = 0; v < field.size(); ++v) {
      if (weight[parts.ids[v]] < 300) continue;
      EXPECT_GT(std::abs(field[v].dot(expected[parts.ids[v]])), 0.999f);
    }
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
    SmoothFieldOptions options;
    options.feature_anchor = 3;
    options.feature_radius = 0.2f;
    options.feature_angle_deg = kAngle;
    const DirectionField field = smooth_direction_field(whole, options);
    for (const Cut& cut : kCuts) {
      SCOPED_TRACE(std::string(shape) + ", " + cut.name);
      const Parts parts(wavy, cut.rank_of_triangle(wavy.mesh));
      const DistributedSurface surface = parts.surface();
      EXPECT_EQ(feature_strokes(surface, kAngle, 0.2, 3), expected);
      const DirectionField own = smooth_direction_field(surface, options);
      if (rank_count() > 1) continue;
      EXPECT_TRUE(same_bits(std::span<const Vec3>(own), std::span<const Vec3>(field)));
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
