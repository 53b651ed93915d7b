#include "brindle/pattern/trimmed_ends.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "brindle/error.h"

namespace brindle {
namespace {

/// Lines in the plane z = 0, of frequency 1.
struct Drawing {
  StripeCurves curves;

  void add(const std::vector<Vec3>& points, CurveEnd first, CurveEnd last) {
    Polylines& lines = curves.lines;
    lines.points.insert(lines.points.end(), points.begin(), points.end());
    lines.normals.resize(lines.points.size(), Vec3(0, 0, 1));
    lines.offsets.push_back(static_cast<Index>(lines.points.size()));
    lines.closed.push_back(first == CurveEnd::closed);
    curves.ends.push_back({first, last});
  }

  StripeCurves trimmed(float least_gap, float frequency = 1) const {
    const std::vector<float> frequencies(curves.lines.points.size(), frequency);
    return trimmed_ends(curves, frequencies, least_gap);
  }
};

constexpr float kFar = 12;
constexpr float kSlope = 0.1f;

/// Two lines that come together like a wedge, and one in the middle that begins in a branch where
/// they are one spacing apart.
Drawing wedge() {
  const float outer = 0.5f + kSlope * kFar;
  Drawing drawing;
  drawing.add({{0, 0.5f, 0}, {kFar, outer, 0}}, CurveEnd::boundary, CurveEnd::boundary);
  drawing.add({{0, -0.5f, 0}, {kFar, -outer, 0}}, CurveEnd::boundary, CurveEnd::boundary);
  drawing.add({{0, 0, 0}, {kFar, 0, 0}}, CurveEnd::branch, CurveEnd::boundary);
  return drawing;
}

/// Where the middle of a wedge has a gap.
float place_of_gap(float gap) { return (gap * std::sqrt(1 + kSlope * kSlope) - 0.5f) / kSlope; }

TEST(TrimmedEnds, BeginWhereTheGapIsWhatWasAskedFor) {
  for (const float gap : {0.52f, 0.6f, 0.8f}) {
    const StripeCurves trimmed = wedge().trimmed(gap);
    ASSERT_EQ(trimmed.lines.count(), 3);
    EXPECT_EQ(trimmed.trimmed_ends, 1);
    const auto middle = trimmed.lines.points_of(2);
    // Ends are cut at places a twentieth of a period apart.
    EXPECT_GE(middle.front().x(), place_of_gap(gap) - 1e-4f);
    EXPECT_LE(middle.front().x(), place_of_gap(gap) + 0.0501f);
    EXPECT_EQ(middle.back(), Vec3(kFar, 0, 0));
    EXPECT_EQ(trimmed.ends, wedge().curves.ends);
  }
}

TEST(TrimmedEnds, MeasureGapsInPeriods) {
  Drawing small = wedge();
  for (Vec3& point : small.curves.lines.points) point *= 0.01f;
  const StripeCurves trimmed = small.trimmed(0.6f, 100);
  const float begin = wedge().trimmed(0.6f).lines.points_of(2).front().x();
  EXPECT_NEAR(100 * trimmed.lines.points_of(2).front().x(), begin, 1e-3f);
}

TEST(TrimmedEnds, StayWhereThereIsRoom) {
  const StripeCurves trimmed = wedge().trimmed(0.49f);
  EXPECT_EQ(trimmed.trimmed_ends, 0);
  EXPECT_EQ(trimmed.lines.points, wedge().curves.lines.points);
}

TEST(TrimmedEnds, LeaveOutAHook) {
  Drawing drawing;
  drawing.add({{0, 0, 0}, {5, 0, 0}, {5, 0.4f, 0}}, CurveEnd::boundary, CurveEnd::singularity);
  const StripeCurves trimmed = drawing.trimmed(0.6f);
  ASSERT_EQ(trimmed.trimmed_ends, 1);
  const Vec3 end = trimmed.lines.points.back();
  EXPECT_NEAR(end.x(), 5, 0.051f);
  EXPECT_NEAR(end.y(), 0, 1e-6f);
}

TEST(TrimmedEnds, KeepALongBend) {
  Drawing drawing;
  std::vector<Vec3> spiral = {{0, -4, 0}};
  for (int i = 0; i <= 60; ++i) {
    const float angle = 0.2f * static_cast<float>(i);
    const float radius = 1 - 0.01f * static_cast<float>(i);
    spiral.push_back({1 - radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  drawing.add(spiral, CurveEnd::boundary, CurveEnd::branch);
  const StripeCurves trimmed = drawing.trimmed(0.05f);
  EXPECT_EQ(trimmed.lines.points.back(), spiral.back()) << "all of it is turned, no hook";
}

TEST(TrimmedEnds, LeaveSpaceBeforeALineAcrossTheirWay) {
  Drawing drawing;
  drawing.add({{-5, 0, 0}, {-0.1f, 0, 0}}, CurveEnd::boundary, CurveEnd::branch);
  drawing.add({{0, -5, 0}, {0, 5, 0}}, CurveEnd::boundary, CurveEnd::boundary);
  EXPECT_NEAR(drawing.trimmed(0.6f).lines.points[1].x(), -0.6f, 0.051f);
}

TEST(TrimmedEnds, MayMeetTheirContinuation) {
  Drawing drawing;
  drawing.add({{-5, 0, 0}, {-0.1f, 0, 0}}, CurveEnd::boundary, CurveEnd::branch);
  drawing.add({{0.1f, 0, 0}, {5, 0, 0}}, CurveEnd::branch, CurveEnd::boundary);
  EXPECT_EQ(drawing.trimmed(0.6f).trimmed_ends, 0);
}

TEST(TrimmedEnds, AreNotCrowdedByTheOtherSideOfASheet) {
  Drawing drawing = wedge();
  for (std::size_t i = 0; i < 4; ++i) drawing.curves.lines.normals[i] = Vec3(0, 0, -1);
  EXPECT_EQ(drawing.trimmed(0.9f).trimmed_ends, 0);
}

TEST(TrimmedEnds, LeaveNoSpecks) {
  Drawing drawing;
  drawing.add({{-5, 0, 0}, {5, 0, 0}}, CurveEnd::boundary, CurveEnd::boundary);
  drawing.add({{-1, 0.4f, 0}, {1, 0.4f, 0}}, CurveEnd::branch, CurveEnd::branch);
  drawing.add({{-1, 0.65f, 0}, {1, 0.65f, 0}}, CurveEnd::boundary, CurveEnd::branch);
  const StripeCurves trimmed = drawing.trimmed(0.6f);
  EXPECT_EQ(trimmed.lines.count(), 1);
  EXPECT_EQ(trimmed.trimmed_away, 2);
}

TEST(TrimmedEnds, RefuseWhatMakesNoSense) {
  const Drawing drawing = wedge();
  for (const float gap : {0.0f, -1.0f, 1.01f, std::nanf("")}) {
    EXPECT_THROW(drawing.trimmed(gap), Error) << gap;
  }
  EXPECT_THROW(trimmed_ends(drawing.curves, {}, 0.6f), Error);
}

}  // namespace
}  // namespace brindle
