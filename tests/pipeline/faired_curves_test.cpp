#include "brindle/pattern/fairing/faired_curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/geometry/topology.h"
#include "brindle/pattern/stripe_curves.h"
#include "brindle/stripe_tracer.h"
#include "brindle/threads.h"
#include "traced_curves.h"

namespace brindle {
namespace {

constexpr float kFair = 0.25f;
const char* const kBentShapes[] = {"trefoil", "sphere", "vessels,resolution=60", "hemisphere",
                                   "box",     "mobius", "sphere,resolution=8"};

TEST(FairedCurves, RefuseWhatMakesNoSense) {
  const Traced traced("torus,resolution=20", 10);
  for (const float fair : {-0.1f, 1.1f, std::nanf("")}) {
    EXPECT_THROW(traced.curves(0, fair), Error) << fair;
  }
}

/// Debris of a scan, round which a curve closes that is smaller than any step of fairing.
TEST(FairedCurves, OfSpecksStayAsTheyAre) {
  Mesh mesh = make_shape("sphere,resolution=30");
  Mesh speck = make_shape("sphere,resolution=6");
  const auto first = static_cast<Index>(mesh.vertex_count());
  for (const Vec3& position : speck.positions) {
    mesh.positions.push_back(Vec3(1.5f, 0, 0) + 1e-6f * position);
  }
  for (const Triangle& t : speck.triangles) {
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
  const Surface surface = make_surface(std::move(mesh));
  const DirectionField field = projected_direction_field({0.2f, 1, 0.3f}, surface.normals);
  for (const float stripes : {10.0f, 20.0f, 33.0f, 47.0f}) {
    const WaveSet waves{surface.mesh.positions, field,
                        FrequencyField(field.size(), stripes / 3.4f)};
    const StripePattern pattern = stripe_pattern(surface, waves);
    const StripeCurves curves = stripe_curves(surface, pattern, {.fair = kFair});
    for (Index line = 0; line < curves.lines.count(); ++line) {
      EXPECT_GT(curves.lines.offsets[line + 1], curves.lines.offsets[line]) << stripes;
    }
  }
}

float degrees_between(const Vec3& a, const Vec3& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 57.29578f;
}

/// By how much a line turns at a point, but for the bend between the triangles beside it.
float corner_at(const Polylines& lines, const Mesh& mesh, Index before, Index at, Index after) {
  const auto normal = [&](Index i) {
    const Triangle& t = mesh.triangles[lines.places[i].triangle];
    const Vec3& a = mesh.positions[t[0]];
    return Vec3((mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a));
  };
  const float bend = degrees_between(normal(before), normal(at));
  const float turn = degrees_between(lines.points[at] - lines.points[before],
                                     lines.points[after] - lines.points[at]);
  return turn - std::min(bend, 180 - bend);  // triangles may be turned round
}

std::vector<float> corners_of_lines(const Polylines& lines, const Mesh& mesh) {
  std::vector<float> corners;
  for (std::size_t line = 0; line < lines.count(); ++line) {
    const Index begin = lines.offsets[line], end = lines.offsets[line + 1];
    const Index count = end - begin;
    for (Index i = lines.closed[line] ? 0 : 1; i + (lines.closed[line] ? 0 : 1) < count; ++i) {
      corners.push_back(corner_at(lines, mesh, begin + (i + count - 1) % count, begin + i,
                                  begin + (i + 1) % count));
    }
  }
  return corners;
}

TEST(FairedCurves, HaveCornersOnlyWhereTheSurfaceHasThem) {
  std::size_t before = 0;
  for (const char* shape : kBentShapes) {
    const Traced traced(shape);
    for (const float corner : corners_of_lines(traced.curves(0.6f).lines, traced.surface.mesh)) {
      before += corner > 45;
    }
    const StripeCurves faired = traced.curves(0.6f, kFair);
    for (const float corner : corners_of_lines(faired.lines, traced.surface.mesh)) {
      EXPECT_LT(corner, 45) << shape;
    }
  }
  EXPECT_GT(before, 40u) << "nothing is shown if there were none";
}

TEST(FairedCurves, HaveFewTurnedEnds) {
  for (const char* shape : kTracedShapes) {
    const Traced traced(shape);
    const Hooks hooks = hooks_of(traced.curves(0.6f, kFair), traced.frequency);
    EXPECT_GT(hooks.ends, 5) << shape;
    EXPECT_LE(hooks.share(), 0.05f) << shape;
  }
}

TEST(FairedCurves, LieOnTheSurfaceAtTheirPlaces) {
  for (const char* shape : kBentShapes) {
    const Traced traced(shape);
    expect_on_surface(traced.curves(0, kFair).lines, traced.surface.mesh);
  }
}

float distance_to_line(const Vec3& p, const Polylines& lines, std::size_t line) {
  const auto points = lines.points_of(line);
  float least = 1e9f;
  const std::size_t segments = points.size() - (lines.closed[line] ? 0 : 1);
  for (std::size_t i = 0; i < segments; ++i) {
    least = std::min(least, distance_to_segment(p, points[i], points[(i + 1) % points.size()]));
  }
  return least;
}

TEST(FairedCurves, MoveByNoMoreThanATenthOfThePeriod) {
  for (const char* shape : {"vessels,resolution=60", "box", "sphere,resolution=8"}) {
    const Traced traced(shape, 40);
    const StripeCurves before = traced.curves(), after = traced.curves(0, kFair);
    ASSERT_EQ(after.lines.count(), before.lines.count());
    EXPECT_GT(after.largest_move, 0.05) << shape;
    EXPECT_LE(after.largest_move, 0.1 * (1 + 1e-6)) << shape;
    for (std::size_t line = 0; line < before.lines.count(); ++line) {
      for (const Vec3& p : after.lines.points_of(line)) {
        EXPECT_LE(distance_to_line(p, before.lines, line) * traced.frequency, 0.101f) << shape;
      }
    }
  }
}

TEST(FairedCurves, KeepTheirDistances) {
  for (const char* shape : kTracedShapes) {
    const Traced traced(shape);
    const auto spacing = [&](float fair) {
      return *StripeTracer(traced.surface).spacing(traced.pattern, traced.curves(0.6f, fair));
    };
    const CurveSpacing before = spacing(0), after = spacing(kFair);
    EXPECT_GE(after.share_within_10_percent, before.share_within_10_percent) << shape;
    EXPECT_LE(after.deviation, 1.02 * before.deviation) << shape;
    EXPECT_GE(after.gaps.least_ratio, before.gaps.least_ratio - 0.05) << shape;
  }
}

TEST(FairedCurves, KeepTheirEnds) {
  const Traced traced("hemisphere");
  const StripeCurves before = traced.curves(), after = traced.curves(0, kFair);
  EXPECT_EQ(after.ends, before.ends);
  EXPECT_EQ(after.lines.closed, before.lines.closed);
  for (std::size_t line = 0; line < before.lines.count(); ++line) {
    if (before.lines.closed[line]) continue;
    const auto from = before.lines.points_of(line), to = after.lines.points_of(line);
    EXPECT_LT((from.front() - to.front()).norm() * traced.frequency, 1e-3f);
    EXPECT_LT((from.back() - to.back()).norm() * traced.frequency, 1e-3f);
  }
}

TEST(FairedCurves, AreTheSameForTurnedDirectionsAndAnyThreads) {
  Traced traced("sphere");
  const auto bits = [&](int threads) {
    const ThreadLimit limit(threads);
    std::vector<float> numbers;
    const StripeCurves curves =
        stripe_curves(traced.surface, traced.pattern, {.join = true, .fair = kFair});
    for (const Vec3& p : curves.lines.points) {
      numbers.insert(numbers.end(), {p.x(), p.y(), p.z()});
    }
    return numbers;
  };
  const std::vector<float> one = bits(1);
  EXPECT_EQ(bits(4), one);
  for (std::size_t v = 0; v < traced.pattern.waves.directions.size(); v += 2) {
    traced.pattern.waves.directions[v] *= -1;
    traced.pattern.solution.z[v] = -std::conj(traced.pattern.solution.z[v]);
  }
  EXPECT_EQ(bits(2), one);
}

/// What fairing asks of a pattern.
struct Waves {
  MeshEdges edges;
  WavePattern pattern;

  Waves(const Surface& surface, const StripePattern& stripes)
      : edges(mesh_edges(surface.mesh, *surface.neighborhood)), pattern{surface.mesh,
                                                                        edges,
                                                                        surface.normals,
                                                                        stripes.waves,
                                                                        stripes.solution.z,
                                                                        stripes.phase_shift} {}
};

StripeCurves with_middles(const StripeCurves& curves) {
  StripeCurves fine = curves;
  Polylines& lines = fine.lines;
  const Polylines& from = curves.lines;
  lines = {};
  lines.closed = from.closed;
  for (std::size_t line = 0; line < from.count(); ++line) {
    for (Index i = from.offsets[line]; i < from.offsets[line + 1]; ++i) {
      const bool last = i + 1 == from.offsets[line + 1];
      lines.points.push_back(from.points[i]);
      lines.normals.push_back(from.normals[i]);
      lines.places.push_back(from.places[i]);
      lines.arrivals.push_back(from.arrivals[i]);
      if (last && !from.closed[line]) continue;
      TrianglePoint middle = from.places[i];
      for (std::size_t m = 0; m < 3; ++m) {
        middle.barycentric[m] = 0.5 * (middle.barycentric[m] + from.arrivals[i][m]);
      }
      const Index next = last ? from.offsets[line] : i + 1;
      lines.arrivals.back() = middle.barycentric;
      lines.points.push_back(0.5f * (from.points[i] + from.points[next]));
      lines.normals.push_back(from.normals[i]);
      lines.places.push_back(middle);
      lines.arrivals.push_back(from.arrivals[i]);
    }
    lines.offsets.push_back(static_cast<Index>(lines.points.size()));
  }
  return fine;
}

TEST(FairedCurves, DoNotDependOnPointsAlongThem) {
  const Traced traced("trefoil", 20);
  const Waves waves(traced.surface, traced.pattern);
  const auto faired = [&](const StripeCurves& curves) {
    return faired_curves(curves, waves.pattern, kFair);
  };
  const StripeCurves curves = traced.curves();
  const StripeCurves one = faired(curves), other = faired(with_middles(curves));
  ASSERT_EQ(one.lines.count(), other.lines.count());
  for (std::size_t line = 0; line < one.lines.count(); ++line) {
    for (const Vec3& p : other.lines.points_of(line)) {
      EXPECT_LT(distance_to_line(p, one.lines, line) * traced.frequency, 1e-3f);
    }
  }
}

/// Two large triangles, and a curve of frequency 1 in one of them.
struct FlatCurve {
  Surface surface = make_surface(
      {{{-100, -100, 0}, {100, -100, 0}, {0, 100, 0}, {0, -300, 0}}, {{0, 1, 2}, {1, 0, 3}}});
  StripePattern stripes;
  StripeCurves curves;

  explicit FlatCurve(const std::vector<Vec3>& points, bool closed = false) {
    stripes.waves.directions.assign(4, Vec3(0, 1, 0));
    stripes.waves.frequencies.assign(4, 1);
    stripes.solution.z.assign(4, Complex(1, 0));
    Polylines& lines = curves.lines;
    lines.points = points;
    for (const Vec3& p : points) {
      const double top = (static_cast<double>(p.y()) + 100) / 200;
      const double right = 0.5 * (1 - top) + static_cast<double>(p.x()) / 200;
      lines.normals.push_back({0, 0, 1});
      lines.places.push_back({0, {1 - top - right, right, top}});
      if (lines.places.size() > 1) lines.arrivals.push_back(lines.places.back().barycentric);
    }
    lines.arrivals.push_back(lines.places[closed ? 0 : points.size() - 1].barycentric);
    lines.offsets.push_back(static_cast<Index>(points.size()));
    lines.closed.push_back(closed);
    const CurveEnd end = closed ? CurveEnd::closed : CurveEnd::branch;
    curves.ends.push_back({end, end});
  }

  std::vector<Vec3> faired() const {
    const Waves waves(surface, stripes);
    return faired_curves(curves, waves.pattern, kFair).lines.points;
  }
};

constexpr float kTurn = 2 * std::numbers::pi_v<float>;

/// What a spline leaves of a wave.
float share_left(float wave_number) { return 1 / (1 + std::pow(wave_number * kFair, 4.0f)); }

TEST(FairedCurves, DampWavesAsSplinesDo) {
  for (const float wave_length : {1.0f, 2.0f, 4.0f}) {
    constexpr float kAmplitude = 0.02f;
    std::vector<Vec3> wave;
    for (int i = -1500; i <= 1500; ++i) {
      const float x = static_cast<float>(i) / 150;
      wave.push_back({x, kAmplitude * std::cos(kTurn * x / wave_length), 0});
    }
    float highest = 0;
    for (const Vec3& p : FlatCurve(wave).faired()) {
      if (std::abs(p.x()) < 5) highest = std::max(highest, p.y());
    }
    const float expected = kAmplitude * share_left(kTurn / wave_length);
    EXPECT_NEAR(highest, expected, 0.03f * kAmplitude) << wave_length;
  }
}

TEST(FairedCurves, KeepCirclesRound) {
  for (const float radius : {0.5f, 1.0f, 3.0f}) {
    std::vector<Vec3> circle;
    for (int i = 0; i < 2000; ++i) {
      const float angle = kTurn * static_cast<float>(i) / 2000;
      circle.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
    }
    for (const Vec3& p : FlatCurve(circle, true).faired()) {
      EXPECT_NEAR(p.norm(), radius * share_left(1 / radius), 1e-3f * radius) << p.transpose();
    }
  }
}

/// The end of a line that lies on another one, or on a farther part of its own.
struct Meeting {
  float distance = 1e9f;  ///< between both, in periods
  float degrees = 0;      ///< between their directions
};

Meeting meeting_of(const Polylines& lines, std::size_t line, std::size_t end, float period) {
  const LineEnd own(lines, line, end);
  const Vec3 direction = own.points[0] - own.points[own.segment_at(0.2f * period)];
  Meeting meeting;
  for (std::size_t other = 0; other < lines.count(); ++other) {
    const LineEnd all(lines, other, other == line ? end : 0);
    float passed = 0;
    for (std::size_t i = 0; i + 1 < all.points.size(); ++i) {
      const Vec3 along = all.points[i + 1] - all.points[i];
      passed += along.norm();
      if (other == line && passed < 1.5f * period) continue;
      const float gap = distance_to_segment(own.points[0], all.points[i], all.points[i + 1]);
      if (gap >= meeting.distance * period) continue;
      const float degrees = degrees_between(direction, along);
      meeting = {gap / period, std::min(degrees, 180 - degrees)};
    }
  }
  return meeting;
}

struct Meetings {
  std::size_t all = 0, smooth = 0;
};

Meetings meetings_of(const Traced& traced, const StripeCurves& curves) {
  Meetings meetings;
  for (std::size_t line = 0; line < curves.lines.count(); ++line) {
    for (const std::size_t end : {0u, 1u}) {
      if (!is_inner(curves.ends[line][end])) continue;
      const Meeting meeting = meeting_of(curves.lines, line, end, 1 / traced.frequency);
      if (meeting.distance > 0.02f) continue;
      ++meetings.all;
      meetings.smooth += meeting.degrees < 30;
    }
  }
  return meetings;
}

StripeCurves joined_curves_of(const Traced& traced, float fair) {
  return stripe_curves(traced.surface, traced.pattern, {.join = true, .fair = fair});
}

TEST(FairedCurves, MeetTheirNeighboursWithNoAngle) {
  const std::vector<std::pair<std::string, double>> shapes = {{"trefoil", 1},
                                                              {"trefoil,resolution=60", 0.7},
                                                              {"sphere", 0.7},
                                                              {"vessels,resolution=60", 0.3}};
  for (const auto& [shape, share] : shapes) {
    const Traced traced(shape);
    const StripeCurves joined = joined_curves_of(traced, 0),
                       faired = joined_curves_of(traced, kFair);
    const Meetings before = meetings_of(traced, joined), after = meetings_of(traced, faired);
    EXPECT_EQ(joined.smooth_forks, 0u);
    EXPECT_EQ(faired.ends, joined.ends) << shape;
    EXPECT_EQ(faired.ends_at_neighbors, joined.ends_at_neighbors) << shape;
    EXPECT_GE(static_cast<double>(faired.smooth_forks), share * static_cast<double>(before.all))
        << shape;
    EXPECT_GE(after.smooth, faired.smooth_forks) << shape;
    EXPECT_LT(before.smooth, before.all / 4) << "nothing is shown if they had none before";
    expect_on_surface(faired.lines, traced.surface.mesh);
  }
}

TEST(FairedCurves, JoinNeighboursTheWayTheyCame) {
  Hooks all;
  for (const char* shape : {"trefoil", "sphere", "hemisphere", "sphere,resolution=60"}) {
    const Traced traced(shape);
    const Hooks joined = hooks_of(joined_curves_of(traced, 0), traced.frequency);
    const Hooks faired = hooks_of(joined_curves_of(traced, kFair), traced.frequency);
    EXPECT_GT(joined.share(), 0.6f) << shape;
    EXPECT_LE(faired.share(), 0.1f) << shape << ", " << faired.turned << " of " << faired.ends;
    all.ends += faired.ends;
    all.turned += faired.turned;
  }
  EXPECT_LE(all.share(), 0.06f) << all.turned << " of " << all.ends;
}

TEST(FairedCurves, HaveAsManyForksOnFinerMeshes) {
  const auto share = [](const std::string& shape) {
    const StripeCurves curves = joined_curves_of(Traced(shape, 40), kFair);
    return static_cast<double>(curves.smooth_forks) / static_cast<double>(curves.ends_at_neighbors);
  };
  EXPECT_GE(share("sphere,resolution=80"), share("sphere,resolution=20") - 0.05);
}

TEST(FairedCurves, KeepEndsOnOtherCurves) {
  for (const char* shape : kTracedShapes) {
    const Traced traced(shape);
    const float period = 1 / traced.frequency;
    const StripeCurves joined = joined_curves_of(traced, 0),
                       faired = joined_curves_of(traced, kFair);
    ASSERT_EQ(faired.lines.count(), joined.lines.count());
    std::size_t touching = 0;
    for (std::size_t line = 0; line < joined.lines.count(); ++line) {
      for (const std::size_t end : {0u, 1u}) {
        if (!is_inner(joined.ends[line][end])) continue;
        if (meeting_of(joined.lines, line, end, period).distance > 1e-4f) continue;
        ++touching;
        EXPECT_LT(meeting_of(faired.lines, line, end, period).distance, 0.02f)
            << shape << ' ' << line << ' ' << end;
      }
    }
    EXPECT_GT(touching, 5u) << shape;
  }
}

}  // namespace
}  // namespace brindle
