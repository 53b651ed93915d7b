/// Curves of patterns with branches, and what tests measure of them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/shapes.h"
#include "brindle/smooth_field.h"
#include "brindle/stripe_pattern.h"

namespace brindle {

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
  StripeCurves curves(float trim = 0, float fair = 0) const {
    return stripe_curves(surface, pattern, {.trim = trim, .fair = fair});
  }
};

inline const char* const kTracedShapes[] = {"trefoil", "sphere", "vessels,resolution=60",
                                            "hemisphere"};

inline bool is_inner(CurveEnd end) {
  return end == CurveEnd::branch || end == CurveEnd::singularity;
}

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

inline Hooks hooks_of(const StripeCurves& curves, float frequency) {
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

/// Points and segments at the places that lines tell.
inline void expect_on_surface(const Polylines& lines, const Mesh& mesh) {
  ASSERT_EQ(lines.places.size(), lines.points.size());
  ASSERT_EQ(lines.arrivals.size(), lines.points.size());
  const float size = bounding_box(mesh).diagonal();
  const auto at = [&](Index triangle, const std::array<double, 3>& weights) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t m = 0; m < 3; ++m) {
      sum += static_cast<float>(weights[m]) * mesh.positions[mesh.triangles[triangle][m]];
    }
    return sum;
  };
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const Index begin = lines.offsets[line], end = lines.offsets[line + 1];
    for (Index i = begin; i < end; ++i) {
      const TrianglePoint& place = lines.places[i];
      EXPECT_LT((at(place.triangle, place.barycentric) - lines.points[i]).norm(), 1e-5f * size);
      if (i + 1 == end) continue;
      EXPECT_LT((at(place.triangle, lines.arrivals[i]) - lines.points[i + 1]).norm(), 1e-5f * size);
    }
  }
}

}  // namespace brindle
