#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/curve_measures.h"
#include "brindle/error.h"
#include "brindle/pattern/trimmed_ends.h"
#include "brindle/threads.h"
#include "traced_curves.h"

namespace brindle {
namespace {

TEST(TrimmedCurves, RefuseWhatMakesNoSense) {
  const Surface surface = make_surface(make_shape("torus,resolution=20"));
  const StripePattern pattern = stripe_pattern(surface, smooth_direction_field(surface), 3);
  EXPECT_THROW(stripe_curves(surface, pattern, {.trim = 1.5f}), Error);
  EXPECT_THROW(stripe_curves(surface, pattern, {.trim = -0.1f}), Error);
  EXPECT_THROW(stripe_curves(surface, pattern, {.join = true, .trim = 0.6f}), Error);
}

TEST(TrimmedCurves, HaveNoHooksByDefault) {
  Hooks before, after;
  for (const char* shape : kTracedShapes) {
    const Traced traced(shape);
    for (const auto& [options, hooks] :
         {std::pair(CurveOptions{.trim = 0}, &before), std::pair(CurveOptions{}, &after)}) {
      const StripeCurves curves = stripe_curves(traced.surface, traced.pattern, options);
      const Hooks here = hooks_of(curves, traced.frequency);
      hooks->ends += here.ends;
      hooks->turned += here.turned;
    }
  }
  EXPECT_GT(before.ends, 150);
  EXPECT_GT(before.share(), 0.4f) << "nothing is shown if there were none";
  EXPECT_LT(after.share(), 0.02f);
}

TEST(TrimmedCurves, AreThoseOfTheDefaultExceptWithJoin) {
  const Traced traced("sphere");
  const auto points = [&](const CurveOptions& options) {
    return stripe_curves(traced.surface, traced.pattern, options).lines.points;
  };
  EXPECT_EQ(points({}), points({.trim = CurveOptions::kTrim}));
  EXPECT_NE(points({}), points({.trim = 0}));
  EXPECT_EQ(points({.join = true}), points({.join = true, .trim = 0}));
}

/// The nearest point of other lines beside an end or across its way, asked of every segment.
float room_at(const Polylines& lines, std::size_t line, const LineEnd& end, float period) {
  const Vec3 p = end.points[0];
  const Vec3 along = (p - end.points[end.segment_at(period)]).normalized();
  float room = 1e9f;
  for (std::size_t other = 0; other < lines.count(); ++other) {
    if (other == line) continue;
    const auto points = lines.points_of(other);
    const auto normals = lines.normals_of(other);
    const std::size_t segments = points.size() - (lines.closed[other] ? 0 : 1);
    for (std::size_t i = 0; i < segments; ++i) {
      const Vec3 a = points[i], side = points[(i + 1) % points.size()] - a;
      if (side.squaredNorm() == 0 || normals[i].dot(end.normals[0]) < 0.4f) continue;
      const float t = std::clamp((p - a).dot(side) / side.squaredNorm(), 0.0f, 1.0f);
      const Vec3 way = a + t * side - p;
      const bool beside = std::abs(way.normalized().dot(along)) < 0.6f;
      const bool across = std::abs(side.normalized().dot(along)) < 0.6f;
      if (beside || across) room = std::min(room, way.norm());
    }
  }
  return room;
}

TEST(TrimmedCurves, HaveRoomBesideThem) {
  for (const char* shape : kTracedShapes) {
    const Traced traced(shape);
    const float period = 1 / traced.frequency;
    const StripeCurves all = traced.curves(), trimmed = traced.curves(0.6f);
    EXPECT_GT(trimmed.trimmed_ends, 0) << shape;
    for (std::size_t line = 0; line < trimmed.lines.count(); ++line) {
      for (const std::size_t end : {0u, 1u}) {
        if (!is_inner(trimmed.ends[line][end])) continue;
        // Straight ways are shorter than those along the surface.
        const float room = room_at(trimmed.lines, line, LineEnd(trimmed.lines, line, end), period);
        EXPECT_GT(room, 0.5f * period) << shape << ' ' << line << ' ' << end;
      }
    }
    const double kept =
        curve_lengths(trimmed.lines).open_length + curve_lengths(trimmed.lines).closed_length;
    const double whole =
        curve_lengths(all.lines).open_length + curve_lengths(all.lines).closed_length;
    EXPECT_GT(kept, 0.95 * whole) << shape;
  }
}

TEST(TrimmedCurves, LieOnTheSurfaceAtTheirPlaces) {
  for (const char* shape : kTracedShapes) {
    const Traced traced(shape);
    expect_on_surface(traced.curves(0.6f).lines, traced.surface.mesh);
  }
}

TEST(TrimmedCurves, OfBoundariesStay) {
  const Traced traced("hemisphere");
  const auto boundary = [](const StripeCurves& curves) {
    std::vector<std::array<float, 3>> points;
    for (std::size_t line = 0; line < curves.lines.count(); ++line) {
      for (const std::size_t end : {0u, 1u}) {
        if (curves.ends[line][end] != CurveEnd::boundary) continue;
        const auto all = curves.lines.points_of(line);
        const Vec3& p = end == 0 ? all.front() : all.back();
        points.push_back({p.x(), p.y(), p.z()});
      }
    }
    return points;
  };
  const StripeCurves trimmed = traced.curves(0.6f);
  EXPECT_GT(boundary(trimmed).size(), 10);
  ASSERT_EQ(trimmed.trimmed_away, 0) << "take a shape of which all lines are left";
  EXPECT_EQ(boundary(trimmed), boundary(traced.curves()));
}

TEST(TrimmedCurves, AreTheSameForTurnedDirectionsAndAnyThreads) {
  Traced traced("sphere");
  const auto bits = [&] {
    std::vector<float> numbers;
    for (const Vec3& p : traced.curves(0.6f).lines.points) {
      numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
    }
    return numbers;
  };
  std::vector<float> one, many;
  {
    const ThreadLimit limit(1);
    one = bits();
  }
  {
    const ThreadLimit limit(4);
    many = bits();
  }
  EXPECT_EQ(one, many);
  for (std::size_t v = 0; v < traced.pattern.waves.directions.size(); v += 2) {
    traced.pattern.waves.directions[v] *= -1;
    traced.pattern.solution.z[v] = -std::conj(traced.pattern.solution.z[v]);
  }
  EXPECT_EQ(bits(), one);
}

TEST(TrimmedCurves, AreTheSameInAnyOrder) {
  const Traced traced("trefoil");
  const StripeCurves curves = traced.curves();
  StripeCurves turned;
  std::vector<std::vector<Vec3>> expected;
  for (std::size_t line = curves.lines.count(); line-- > 0;) {
    const LineEnd all(curves.lines, line, 1);
    turned.lines.points.insert(turned.lines.points.end(), all.points.begin(), all.points.end());
    turned.lines.normals.insert(turned.lines.normals.end(), all.normals.begin(), all.normals.end());
    turned.lines.offsets.push_back(static_cast<Index>(turned.lines.points.size()));
    turned.lines.closed.push_back(curves.lines.closed[line]);
    turned.ends.push_back({curves.ends[line][1], curves.ends[line][0]});
  }
  const auto trimmed = [&](const StripeCurves& lines) {
    const std::vector<float> frequencies(lines.lines.points.size(), traced.frequency);
    return trimmed_ends(lines, frequencies, 0.6f);
  };
  const StripeCurves one = trimmed(curves), other = trimmed(turned);
  ASSERT_EQ(one.lines.count(), other.lines.count());
  EXPECT_EQ(one.trimmed_ends, other.trimmed_ends);
  for (std::size_t line = 0; line < one.lines.count(); ++line) {
    const LineEnd all(other.lines, other.lines.count() - 1 - line, 1);
    const auto points = one.lines.points_of(line);
    ASSERT_EQ(points.size(), all.points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_LT((points[i] - all.points[i]).norm() * traced.frequency, 1e-3f);
    }
  }
}

}  // namespace
}  // namespace brindle
