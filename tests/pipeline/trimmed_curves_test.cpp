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
#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_pattern.h"
#include "brindle/threads.h"

namespace brindle {
namespace {

TEST(TrimmedCurves, RefuseWhatMakesNoSense) {
  const Surface surface = make_surface(make_shape("torus,resolution=20"));
  const StripePattern pattern = stripe_pattern(surface, smooth_direction_field(surface), 3);
  EXPECT_THROW(stripe_curves(surface, pattern, {.trim = 1.5f}), Error);
  EXPECT_THROW(stripe_curves(surface, pattern, {.trim = -0.1f}), Error);
  EXPECT_THROW(stripe_curves(surface, pattern, {.join = true, .trim = 0.6f}), Error);
}

/// Patterns with branches and singularities, and one with a boundary.
struct Traced {
  Surface surface;
  StripePattern pattern;
  float frequency;

  explicit Traced(const std::string& shape, float stripes = 60)
      : surface(make_surface(make_shape(shape))),
        frequency(stripes / bounding_box(surface.mesh).diagonal()) {
    pattern = stripe_pattern(surface, smooth_direction_field(surface), frequency);
  }
  StripeCurves curves(float trim = 0) const {
    return stripe_curves(surface, pattern, {.trim = trim});
  }
};

const char* const kShapes[] = {"trefoil", "sphere", "vessels,resolution=60", "hemisphere"};

bool is_inner(CurveEnd end) { return end == CurveEnd::branch || end == CurveEnd::singularity; }

/// One end of a line, seen along the line.
struct LineEnd {
  std::vector<Vec3> points, normals;  ///< from the end on

  LineEnd(const Polylines& lines, std::size_t line, std::size_t end)
      : points(lines.points_of(line).begin(), lines.points_of(line).end()),
        normals(lines.normals_of(line).begin(), lines.normals_of(line).end()) {
    if (end == 0) return;
    std::ranges::reverse(points);
    std::ranges::reverse(normals);
  }

  /// The segment that has this length before it; the last one if there is none.
  std::size_t segment_at(float length) const {
    for (std::size_t i = 0; i + 2 < points.size(); ++i) {
      length -= (points[i + 1] - points[i]).norm();
      if (length < 0) return i;
    }
    return points.size() - 2;
  }
  Vec3 direction(std::size_t segment) const {
    return (points[segment] - points[segment + 1]).normalized();
  }

  /// Against the line one period before, but for how the surface bends.
  float turned_degrees(float period) const {
    const std::size_t before = segment_at(period);
    const auto bend = Eigen::Quaternionf::FromTwoVectors(normals[before], normals[0]);
    const float cosine = direction(0).dot(bend * direction(before));
    return std::acos(std::clamp(cosine, -1.0f, 1.0f)) * 57.29578f;
  }
};

struct Hooks {
  int ends = 0, turned = 0;
  float share() const { return static_cast<float>(turned) / static_cast<float>(ends); }
};

Hooks hooks_of(const StripeCurves& curves, float frequency) {
  Hooks hooks;
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    for (const std::size_t end : {0u, 1u}) {
      if (!is_inner(curves.ends[line][end])) continue;
      ++hooks.ends;
      hooks.turned += LineEnd(curves.lines, line, end).turned_degrees(1 / frequency) > 30;
    }
  }
  return hooks;
}

TEST(TrimmedCurves, HaveNoHooks) {
  Hooks before, after;
  for (const char* shape : kShapes) {
    const Traced traced(shape);
    for (const auto& [trim, hooks] : {std::pair(0.0f, &before), std::pair(0.6f, &after)}) {
      const Hooks here = hooks_of(traced.curves(trim), traced.frequency);
      hooks->ends += here.ends;
      hooks->turned += here.turned;
    }
  }
  EXPECT_GT(before.ends, 150);
  EXPECT_GT(before.share(), 0.4f) << "nothing is shown if there were none";
  EXPECT_LT(after.share(), 0.02f);
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
  for (const char* shape : kShapes) {
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
  for (const char* shape : kShapes) {
    const Traced traced(shape);
    const Polylines lines = traced.curves(0.6f).lines;
    ASSERT_EQ(lines.places.size(), lines.points.size());
    ASSERT_EQ(lines.arrivals.size(), lines.points.size());
    const float size = bounding_box(traced.surface.mesh).diagonal();
    const auto at = [&](Index triangle, const std::array<double, 3>& weights) {
      Vec3 sum = Vec3::Zero();
      for (std::size_t m = 0; m < 3; ++m) {
        sum += static_cast<float>(weights[m]) *
               traced.surface.mesh.positions[traced.surface.mesh.triangles[triangle][m]];
      }
      return sum;
    };
    for (std::size_t line = 0; line < lines.count(); ++line) {
      const Index begin = lines.offsets[line], end = lines.offsets[line + 1];
      for (Index i = begin; i < end; ++i) {
        const TrianglePoint& place = lines.places[i];
        EXPECT_LT((at(place.triangle, place.barycentric) - lines.points[i]).norm(), 1e-5f * size);
        if (i + 1 == end) continue;
        EXPECT_LT((at(place.triangle, lines.arrivals[i]) - lines.points[i + 1]).norm(),
                  1e-5f * size);
      }
    }
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
