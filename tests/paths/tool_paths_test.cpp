#include "brindle/tool_paths.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_pattern.h"
#include "brindle/threads.h"
#include "brindle/windings.h"

namespace brindle {
namespace {

constexpr float kPitch = 0.125f;

void add_line(Polylines& lines, const std::vector<Vec3>& points, bool closed = false) {
  for (const Vec3& point : points) lines.add(point, Vec3::UnitZ());
  lines.end_line(closed);
}

/// Lines along x over the square [-1, 1]^2, some of them backwards, in a mixed order.
Polylines hatching() {
  Polylines lines;
  for (const int k : {3, 0, 7, 1, 6, 2, 5, 4}) {
    const float y = kPitch * static_cast<float>(k) - 0.5f, side = k % 3 == 0 ? -1.0f : 1.0f;
    add_line(lines, {{-side, y, 0}, {0, y, 0}, {side, y, 0}});
  }
  return lines;
}

Mesh flat_mesh() { return make_shape("plane,resolution=8"); }

ToolPathOptions with_order(PathOrder order, float connect = 0, float width = kPitch) {
  ToolPathOptions options;
  options.order = order;
  options.connect = connect;
  options.width = width;
  return options;
}

TEST(ToolPaths, ParallelLinesAreLaidToAndFro) {
  for (const PathOrder order : {PathOrder::boustrophedon, PathOrder::nearest}) {
    const ToolPaths paths = tool_paths(flat_mesh(), hatching(), with_order(order));
    ASSERT_EQ(paths.lines.count(), 8u);
    EXPECT_NEAR(paths.metrics.travel, 7 * static_cast<double>(kPitch), 1e-6);
    EXPECT_NEAR(paths.metrics.length, 16, 1e-6);
    for (std::size_t line = 1; line < 8; ++line) {
      const Vec3 step =
          paths.lines.points_of(line).front() - paths.lines.points_of(line - 1).back();
      EXPECT_NEAR(std::abs(step.y()), kPitch, 1e-6f);
      EXPECT_EQ(step.x(), 0);
    }
    for (const float width : paths.widths) EXPECT_NEAR(width, kPitch, 1e-6f);
    EXPECT_EQ(paths.metrics.least_radius, std::numeric_limits<double>::infinity());
  }
}

TEST(ToolPaths, EndsAreJoinedAlongTheSurface) {
  const ToolPaths paths =
      tool_paths(flat_mesh(), hatching(), with_order(PathOrder::boustrophedon, 1.5f * kPitch));
  EXPECT_EQ(paths.lines.count(), 1u);
  EXPECT_EQ(paths.metrics.joins, 7u);
  EXPECT_EQ(paths.metrics.travel, 0);
  EXPECT_NEAR(paths.metrics.joined_length, 7 * static_cast<double>(kPitch), 1e-6);
  EXPECT_NEAR(paths.metrics.length, 16 + 7 * static_cast<double>(kPitch), 1e-5);
  // Joins stay on a bent surface.
  const Mesh ball = make_shape("sphere");
  Polylines arcs;
  for (const float height : {0.0f, 0.3f}) {
    for (int i = 0; i <= 40; ++i) {
      const float angle = 0.05f * static_cast<float>(i), r = std::sqrt(1 - height * height);
      const Vec3 point(r * std::cos(angle), r * std::sin(angle), height);
      arcs.add(point, point);
    }
    arcs.end_line(false);
  }
  const ToolPaths bent = tool_paths(ball, arcs, with_order(PathOrder::nearest, 0.5f, 0.3f));
  EXPECT_EQ(bent.metrics.joins, 1u);
  for (const Vec3& point : bent.lines.points) EXPECT_NEAR(point.norm(), 1, 2e-3);
}

TEST(ToolPaths, NoJoinCrossesACurveOrAGap) {
  Polylines crossed;
  add_line(crossed, {{-0.5f, -0.1f, 0}, {0.5f, -0.1f, 0}});
  add_line(crossed, {{-0.5f, 0.1f, 0}, {0.5f, 0.1f, 0}});
  const auto joins = [&](const Mesh& mesh) {
    return tool_paths(mesh, crossed, with_order(PathOrder::nearest, 0.25f)).metrics.joins;
  };
  EXPECT_EQ(joins(flat_mesh()), 1u);
  Mesh gap = make_shape("plane,width=2,height=0.4,resolution=8");
  const Mesh other = gap;
  translate(gap, {0, -0.25f, 0});
  Mesh upper = other;
  translate(upper, {0, 0.25f, 0});
  append(upper, gap);
  EXPECT_EQ(joins(gap), 0u);
  add_line(crossed, {{-0.9f, 0, 0}, {0.9f, 0, 0}});
  EXPECT_EQ(joins(flat_mesh()), 0u);
}

TEST(ToolPaths, RingsOfACylinderBecomeOneSpiral) {
  const Surface surface = make_surface(make_shape("cylinder,resolution=96"));
  const auto count = surface.mesh.vertex_count();
  constexpr float kFrequency = 12;
  const DirectionField up(count, Vec3::UnitZ());
  const StripePattern rings = stripe_pattern(surface, up, kFrequency);
  const WantedWinding once{"", 1};
  const StripePattern wound = wind(surface, rings, std::span(&once, 1)).pattern;
  const Polylines curves = stripe_curves(surface, wound).lines;
  const ToolPaths paths =
      tool_paths(surface.mesh, curves, with_order(PathOrder::spiral, 0, 1 / kFrequency));
  ASSERT_EQ(paths.lines.count(), 1u);
  EXPECT_EQ(paths.metrics.travel, 0);
  double turned = 0, last = 0;
  const auto angle_of = [](const Vec3& p) { return static_cast<double>(std::atan2(p.y(), p.x())); };
  const Vec3& first = paths.lines.points.front();
  last = angle_of(first);
  for (const Vec3& point : paths.lines.points) {
    turned += std::remainder(angle_of(point) - last, 2 * std::numbers::pi);
    last = angle_of(point);
    // The pitch is 1/f, and the path rises.
    EXPECT_NEAR(static_cast<double>(point.z() - first.z()),
                std::abs(turned) / (2 * std::numbers::pi) / static_cast<double>(kFrequency), 2e-6);
  }
  EXPECT_NEAR(std::abs(turned) / (2 * std::numbers::pi), 24, 1.01);
  // Inner turns have neighbours above and below, at the pitch seen at right angles to the helix.
  const double girth = std::numbers::pi * 1.0, pitch = 1.0 / static_cast<double>(kFrequency);
  const double across = pitch * girth / std::hypot(pitch, girth);
  EXPECT_NEAR(static_cast<double>(paths.widths[paths.widths.size() / 2]), across, 2e-3 * across);
}

TEST(ToolPaths, LayersRise) {
  const Surface surface = make_surface(make_shape("sphere"));
  const StripePattern pattern = stripe_pattern(surface, smooth_direction_field(surface), 6);
  const Polylines curves = stripe_curves(surface, pattern).lines;
  const ToolPaths paths =
      tool_paths(surface.mesh, curves, with_order(PathOrder::layers, 0, 1 / 6.0f));
  float top = -2;
  for (std::size_t line = 0; line < paths.lines.count(); ++line) {
    float height = 0;
    const std::size_t size = paths.lines.points_of(line).size();
    for (const Vec3& point : paths.lines.points_of(line)) height += point.z();
    height /= static_cast<float>(size);
    EXPECT_GT(height, top - 1 / 11.0f);
    top = std::max(top, height);
  }
}

struct PathsOfTrefoil {
  Surface surface = make_surface(make_shape("trefoil,resolution=24"));
  Polylines curves;
  ToolPathOptions options = with_order(PathOrder::nearest, 0.1f, 0.08f);

  PathsOfTrefoil() {
    const StripePattern pattern =
        stripe_pattern(surface, smooth_direction_field(surface), 1 / options.width);
    curves = stripe_curves(surface, pattern).lines;
  }
};

TEST(ToolPaths, FramesAreOrthogonalUnitVectorsOfTheirQuaternions) {
  const PathsOfTrefoil made;
  const ToolPaths paths = tool_paths(made.surface.mesh, made.curves, made.options);
  const std::vector<Eigen::Vector4f> poses = path_poses(paths);
  ASSERT_EQ(poses.size(), paths.lines.points.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vec3 &normal = paths.lines.normals[i], &direction = paths.directions[i];
    ASSERT_NEAR(normal.norm(), 1, 1e-4);
    ASSERT_NEAR(direction.norm(), 1, 1e-4);
    ASSERT_NEAR(normal.dot(direction), 0, 1e-4);
    const Eigen::Quaternionf q(poses[i][0], poses[i][1], poses[i][2], poses[i][3]);
    ASSERT_NEAR(q.norm(), 1, 1e-5);
    ASSERT_GE(q.w(), 0);
    ASSERT_LT((q * Vec3::UnitX() - direction).norm(), 1e-3);
    ASSERT_LT((q * Vec3::UnitZ() - normal).norm(), 1e-3);
  }
}

TEST(ToolPaths, TravelIsAtMostThatOfNearestEndsAndWidthsAreGaps) {
  const PathsOfTrefoil made;
  ToolPathOptions options = made.options;
  options.connect = 0;
  const ToolPathMetrics metrics = tool_paths(made.surface.mesh, made.curves, options).metrics;
  EXPECT_LE(metrics.travel, metrics.travel_nearest);
  EXPECT_GT(metrics.travel, 0);
  EXPECT_NEAR(metrics.mean_width, static_cast<double>(options.width), 0.1 * 0.08);
  EXPECT_LE(metrics.most_width, 2.001 * static_cast<double>(options.width));
}

TEST(ToolPaths, ThreadsChangeNoBitAndMotionOnlyPlaces) {
  const PathsOfTrefoil made;
  const ToolPaths paths = tool_paths(made.surface.mesh, made.curves, made.options);
  {
    const ThreadLimit one(1);
    const ToolPaths same = tool_paths(made.surface.mesh, made.curves, made.options);
    EXPECT_EQ(same.lines.points, paths.lines.points);
    EXPECT_EQ(same.widths, paths.widths);
  }
  const Eigen::Matrix3f rotation =
      Eigen::AngleAxisf(0.7f, Vec3(3, 1, 2).normalized()).toRotationMatrix();
  Polylines curves = made.curves;
  Mesh mesh = made.surface.mesh;
  for (Vec3& point : curves.points) point = 2 * (rotation * point) + Vec3(1, 2, 3);
  for (Vec3& normal : curves.normals) normal = rotation * normal;
  for (Vec3& point : mesh.positions) point = 2 * (rotation * point) + Vec3(1, 2, 3);
  ToolPathOptions options = made.options;
  options.width *= 2;
  *options.connect *= 2;
  const ToolPathMetrics moved = tool_paths(mesh, curves, options).metrics;
  EXPECT_NEAR(moved.travel, 2 * paths.metrics.travel, 0.03 * moved.travel);
  EXPECT_NEAR(moved.length, 2 * paths.metrics.length, 0.01 * moved.length);
  EXPECT_NEAR(moved.mean_width, 2 * paths.metrics.mean_width, 1e-3 * moved.mean_width);
}

TEST(ToolPaths, FibreIsMarkedWhereItIsCut) {
  Polylines lines;
  add_line(lines, {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}});
  add_line(lines, {{-1, 0.5f, 0}, {-0.8f, 0.5f, 0}});
  ToolPathOptions options = with_order(PathOrder::nearest);
  options.cut_length = 0.25f;
  const ToolPaths paths = tool_paths(flat_mesh(), lines, options);
  EXPECT_EQ(paths.metrics.left_out, 1u);
  ASSERT_EQ(paths.lines.points.size(), 4u);
  EXPECT_NEAR((paths.lines.points[2] - paths.lines.points[3]).norm(), 0.25f, 1e-6f);
  EXPECT_EQ(paths.cut, (std::vector<std::uint8_t>{0, 0, 1, 1}));
}

TEST(ToolPaths, TightBendsAreCut) {
  Polylines lines;
  std::vector<Vec3> corner, circle;
  for (int i = 0; i <= 20; ++i) corner.emplace_back(-1 + 0.05f * static_cast<float>(i), 0, 0);
  for (int i = 1; i <= 20; ++i) corner.emplace_back(0, 0.05f * static_cast<float>(i), 0);
  for (int i = 0; i < 360; ++i) {
    const float angle = std::numbers::pi_v<float> * static_cast<float>(i) / 180;
    circle.emplace_back(0.4f * std::cos(angle), -0.5f + 0.4f * std::sin(angle), 0);
  }
  add_line(lines, corner);
  ToolPathOptions options = with_order(PathOrder::nearest);
  options.least_radius = 0.3f;
  const ToolPaths cut = tool_paths(flat_mesh(), lines, options);
  EXPECT_EQ(cut.metrics.bends_cut, 1u);
  EXPECT_EQ(cut.lines.count(), 2u);
  EXPECT_NEAR(cut.metrics.length, 2, 1e-5);
  EXPECT_EQ(cut.metrics.least_radius, std::numeric_limits<double>::infinity());
  lines = {};
  add_line(lines, circle, true);
  const ToolPaths round = tool_paths(flat_mesh(), lines, options);
  EXPECT_EQ(round.metrics.bends_cut, 0u);
  EXPECT_NEAR(round.metrics.least_radius, 0.4, 2e-3) << "points between corners are inside";
}

TEST(ToolPaths, RejectsWhatItCannotFollow) {
  const auto rejects = [](const std::string& why, const Polylines& curves,
                          const ToolPathOptions& options) {
    try {
      tool_paths(flat_mesh(), curves, options);
      ADD_FAILURE() << why;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
    }
  };
  rejects("width", hatching(), with_order(PathOrder::nearest, 0, 0));
  rejects("lengths", hatching(), with_order(PathOrder::nearest, -1));
  rejects("8 curves", hatching(), with_order(PathOrder::spiral));
  Polylines bare = hatching();
  bare.normals.clear();
  rejects("normal", bare, with_order(PathOrder::nearest));
  EXPECT_EQ(tool_paths(flat_mesh(), {}, with_order(PathOrder::layers)).lines.count(), 0u);
  Machine machine;
  machine.axes = 4;
  EXPECT_THROW(machine_points({}, machine), Error);
}

}  // namespace
}  // namespace brindle
