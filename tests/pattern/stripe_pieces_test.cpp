#include "brindle/pattern/stripe_pieces.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "brindle/base/elementary.h"
#include "lifted_corners.h"

namespace brindle {
namespace {

using testing_support::lifted_triangle;

using Corners = std::array<CornerWave, 3>;

/// Three waves in the plane z = 0, as different as can be.
Corners random_corners(std::mt19937& random, float frequency) {
  std::uniform_real_distribution<float> angle(0, kTwoPi), size(0.5f, 1.5f);
  Corners corners;
  for (int m = 0; m < 3; ++m) {
    const float around = kTwoPi * static_cast<float>(m) / 3, direction = angle(random);
    corners[m] = {{size(random) * Vec3(std::cos(around), std::sin(around), 0),
                   Vec3(std::cos(direction), std::sin(direction), 0), frequency * size(random)},
                  std::polar(1.0f, angle(random))};
  }
  return corners;
}

Eigen::Vector2d in_plane(const PieceEnd& end) { return {end.barycentric[1], end.barycentric[2]}; }

double side_of(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
}

/// Whether the insides of two pieces meet.
bool cross(const StripePiece& p, const StripePiece& q) {
  const auto a = in_plane(p.ends[0]), b = in_plane(p.ends[1]);
  const auto c = in_plane(q.ends[0]), d = in_plane(q.ends[1]);
  const double tolerance = 1e-9;
  const auto strictly_apart = [&](double s, double t) {
    return (s > tolerance && t < -tolerance) || (s < -tolerance && t > tolerance);
  };
  return strictly_apart(side_of(c, a, b), side_of(d, a, b)) &&
         strictly_apart(side_of(a, c, d), side_of(b, c, d));
}

struct PieceCounts {
  std::map<std::pair<int, Index>, int> uses;  // of the crossings of every side
  std::size_t inside = 0;
};

PieceCounts count(const std::vector<StripePiece>& pieces) {
  PieceCounts counts;
  for (const StripePiece& piece : pieces) {
    EXPECT_NE(piece.ends[0].side, PieceEnd::kInside);
    for (const PieceEnd& end : piece.ends) {
      if (end.side == PieceEnd::kInside) {
        ++counts.inside;
      } else {
        ++counts.uses[{end.side, end.crossing}];
      }
      for (const double weight : end.barycentric) EXPECT_GE(weight, -1e-12);
    }
  }
  return counts;
}

struct StripePieces : testing::TestWithParam<bool> {};

TEST_P(StripePieces, UseEveryCrossingOnceAndDoNotCross) {
  std::mt19937 random(7);
  std::map<TriangleKind, int> kinds;
  std::vector<StripePiece> pieces;
  for (int trial = 0; trial < 3000; ++trial) {
    const Corners corners =
        random_corners(random, std::pow(4.0f, static_cast<float>(trial % 4) - 1));
    const LiftedTriangle triangle = lifted_triangle({5, 3, 8}, corners);
    ++kinds[triangle.kind];
    stripe_pieces(triangle, GetParam(), pieces);
    const PieceCounts counts = count(pieces);
    std::size_t crossings = 0, cuts = 0;
    for (int m = 0; m < 3; ++m) {
      crossings += static_cast<std::size_t>(std::abs(triangle.edges[m].peaks));
      cuts += triangle.kind == TriangleKind::field_singularity ? cut_crossings(triangle, m) : 0;
    }
    ASSERT_EQ(counts.uses.size(), crossings + cuts);
    for (const auto& [crossing, uses] : counts.uses) {
      ASSERT_EQ(uses, crossing.first < 3 ? 1 : 2) << "side " << crossing.first;
    }
    const auto index = static_cast<std::size_t>(std::abs(triangle.branch_index));
    if (triangle.kind != TriangleKind::field_singularity) {
      ASSERT_EQ(counts.inside, GetParam() ? index % 2 : index);
    }
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) ASSERT_FALSE(cross(pieces[i], pieces[j])) << trial;
    }
  }
  for (const auto kind :
       {TriangleKind::regular, TriangleKind::branch, TriangleKind::field_singularity}) {
    EXPECT_GT(kinds[kind], 100);
  }
}

INSTANTIATE_TEST_SUITE_P(Joined, StripePieces, testing::Bool());

TEST(LiftedTriangle, DoesNotCareWhichWayWavesRun) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 500; ++trial) {
    Corners corners = random_corners(random, 5);
    const LiftedTriangle before = lifted_triangle({0, 1, 2}, corners);
    for (CornerWave& corner : corners) {
      if (random() % 2) corner = flipped(corner);
    }
    const LiftedTriangle after = lifted_triangle({0, 1, 2}, corners);
    EXPECT_EQ(before.turns, after.turns);
    EXPECT_EQ(before.kind, after.kind);
    EXPECT_EQ(before.inner, after.inner);
    for (int m = 0; m < 3; ++m) EXPECT_EQ(before.edges[m].peaks, after.edges[m].peaks);
  }
}

TEST(LiftedTriangle, AgreesWithCornerPhases) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 2000; ++trial) {
    const Corners corners = random_corners(random, 2);
    const LiftedTriangle lifted = lifted_triangle({0, 1, 2}, corners);
    const CornerPhases phases = corner_phases(corners, PhaseShiftKind::aligned);
    ASSERT_EQ(lifted.kind, phases.kind);
    ASSERT_EQ(std::abs(lifted.branch_index), std::abs(phases.branch_index));
  }
}

TEST(LiftedTriangle, NeighboursAgreeAlongTheirEdge) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 500; ++trial) {
    const Corners a = random_corners(random, 5), c = random_corners(random, 5);
    const Corners b = {flipped(a[1]), a[0], c[2]};  // shares vertices 4 and 9
    const LiftedTriangle left = lifted_triangle({4, 9, 2}, a);
    const LiftedTriangle right = lifted_triangle({9, 4, 7}, b);
    EXPECT_EQ(left.edges[0].peaks, right.edges[0].peaks);
    EXPECT_EQ(left.edges[0].reflecting, right.edges[0].reflecting);
    EXPECT_EQ(left.forward[0], !right.forward[0]);
  }
}

TEST(TurnsAfterPeak, CountFromThePeakAndAreNeverWhole) {
  EXPECT_EQ(turns_after_peak(Complex(0, 1)), 1);
  EXPECT_EQ(turns_after_peak(Complex(-1, 0)), kWholeTurn / 4);
  EXPECT_EQ(turns_after_peak(Complex(0, -1)), kWholeTurn / 2);
  EXPECT_EQ(turns_after_peak(Complex(1, 0)), 3 * kWholeTurn / 4);
  EXPECT_EQ(turns_after_peak(std::polar(1.0f, kTwoPi / 4 - 1e-9f)), 1);
}

TEST(TurnsAfterPeak, TooManyPeaksAreBounded) {
  const CornerWave a{{Vec3(0, 0, 0), Vec3(1, 0, 0), 1e30f}, 1};
  const CornerWave b{{Vec3(1e8f, 0, 0), Vec3(1, 0, 0), 1e30f}, 1};
  EXPECT_EQ(lift_edge(a, 5, b, 5, PhaseShiftKind::aligned).peaks, 1 << 24);
}

TEST(StripePiecesOfAPlaneWave, AreItsPeaks) {
  std::mt19937 random(6);
  std::vector<StripePiece> pieces;
  for (const float frequency : {0.3f, 3.0f, 30.0f}) {
    Corners corners = random_corners(random, 1);
    for (CornerWave& corner : corners) {
      corner.wave.direction = Vec3(0.6f, 0.8f, 0);
      corner.wave.frequency = frequency;
      corner.z =
          std::polar(1.0f, kTwoPi * frequency * Vec3(0.6f, 0.8f, 0).dot(corner.wave.position));
    }
    stripe_pieces(lifted_triangle({0, 1, 2}, corners), false, pieces);
    for (const StripePiece& piece : pieces) {
      std::array<double, 2> turns{};
      for (int e = 0; e < 2; ++e) {
        Vec3 p = Vec3::Zero();
        for (int m = 0; m < 3; ++m) {
          p += static_cast<float>(piece.ends[e].barycentric[m]) * corners[m].wave.position;
        }
        turns[e] = frequency * Vec3(0.6f, 0.8f, 0).dot(p) - 0.25;
        EXPECT_NEAR(turns[e], std::round(turns[e]), 1e-4);
      }
      EXPECT_EQ(std::round(turns[0]), std::round(turns[1]));
    }
  }
}

}  // namespace
}  // namespace brindle
