#include "brindle/fragment_phase.h"

#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/base/elementary.h"

namespace brindle {
namespace {

using Corners = std::array<CornerWave, 3>;

Complex phase(float turns) { return std::polar(1.0f, kTwoPi * turns); }

struct Dice {
  std::mt19937 engine{7};
  float number(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(engine);
  }
  Vec3 point() { return {number(-1, 1), number(-1, 1), number(-1, 1)}; }
  CornerWave corner() {
    return {{point(), point().normalized(), number(0.5f, 4)}, phase(number(0, 1))};
  }
  Corners corners() { return {corner(), corner(), corner()}; }
  Vec3 barycentric() {
    const Vec3 b(number(0, 1), number(0, 1), number(0, 1));
    return b / b.sum();
  }
};

bool orientable(const Corners& c) {
  return common_orientation({c[0].wave.direction, c[1].wave.direction, c[2].wave.direction})
      .has_value();
}

TEST(FragmentPhase, ParallelWavesInAPlaneGiveTheLinearPhase) {
  const Vec3 d = Vec3(3, 4, 0) / 5;
  Corners corners;
  const std::array<Vec3, 3> points{Vec3(0, 0, 0), Vec3(1, 0.1f, 0), Vec3(0.3f, 0.8f, 0)};
  for (int m = 0; m < 3; ++m) {
    corners[m] = {{points[m], d, 5}, phase(5 * d.dot(points[m]))};
  }
  Dice dice;
  for (int n = 0; n < 100; ++n) {
    const Vec3 b = dice.barycentric();
    const Vec3 p = b[0] * points[0] + b[1] * points[1] + b[2] * points[2];
    EXPECT_NEAR(std::abs(fragment_phase(corners, b).z - phase(5 * d.dot(p))), 0, 1e-5);
  }
}

TEST(FragmentPhase, CircularWaveFrontThroughTheCornersIsExactInside) {
  const float radius = 3;
  Corners corners;
  const std::array<float, 3> angles{0.1f, 0.5f, 1.2f};
  for (int m = 0; m < 3; ++m) {
    const Vec3 d(std::cos(angles[m]), std::sin(angles[m]), 0);
    corners[m] = {{radius * d, d, 4}, phase(4 * radius)};
  }
  Dice dice;
  for (int n = 0; n < 100; ++n) {
    const Vec3 b = dice.barycentric();
    Vec3 p = Vec3::Zero();
    for (int m = 0; m < 3; ++m) p += b[m] * corners[m].wave.position;
    EXPECT_NEAR(std::abs(fragment_phase(corners, b).z - phase(4 * p.norm())), 0, 1e-4);
  }
}

TEST(FragmentPhase, FlippingAnyCornersKeepsTheSine) {
  Dice dice;
  int split = 0;
  for (int n = 0; n < 200; ++n) {
    const Corners corners = dice.corners();
    const Vec3 b = dice.barycentric();
    split += !orientable(corners);
    for (int mask = 1; mask < 8; ++mask) {
      Corners other = corners;
      for (int m = 0; m < 3; ++m) {
        if (mask >> m & 1) other[m] = flipped(other[m]);
      }
      EXPECT_NEAR(fragment_phase(other, b).z.imag(), fragment_phase(corners, b).z.imag(), 1e-4);
    }
  }
  EXPECT_GT(split, 20);
  EXPECT_LT(split, 180);
}

TEST(FragmentPhase, AtSeveralPointsIsWhatItIsAtEach) {
  Dice dice;
  for (int n = 0; n < 100; ++n) {
    Corners corners = dice.corners();
    if (n % 10 == 0) corners[n % 3].wave.direction.setZero();
    const std::array<Vec3, 3> points{dice.barycentric(), dice.barycentric(), dice.barycentric()};
    std::array<FragmentWave, 3> waves, split;
    waves.fill({Vec3::Ones(), 1, 1});
    split.fill({Vec3::Ones(), 1, 1});
    fragment_phases(corners, points, waves);
    split_fragment_phases(corners, points, split);
    const auto are_same = [](const FragmentWave& a, const FragmentWave& b) {
      return a.direction == b.direction && a.frequency == b.frequency && a.z == b.z;
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_TRUE(are_same(waves[i], fragment_phase(corners, points[i])));
      EXPECT_TRUE(are_same(split[i], split_fragment_phase(corners, points[i])));
    }
  }
}

TEST(FragmentPhase, CornerHasItsOwnPhase) {
  Dice dice;
  for (int n = 0; n < 200; ++n) {
    const Corners corners = dice.corners();
    for (int m = 0; m < 3; ++m) {
      const FragmentWave fragment = fragment_phase(corners, Vec3::Unit(m));
      EXPECT_NEAR(fragment.z.imag(), corners[m].z.imag(), 1e-5);
      EXPECT_NEAR(std::abs(fragment.z.real()), std::abs(corners[m].z.real()), 1e-5);
      EXPECT_NEAR(std::abs(fragment.direction.dot(corners[m].wave.direction)), 1, 1e-5);
      EXPECT_NEAR(fragment.frequency, corners[m].wave.frequency, 1e-5);
    }
  }
}

TEST(FragmentPhase, TrianglesOfAnEdgeShareTheSineAlongIt) {
  Dice dice;
  int mixed = 0;
  for (int n = 0; n < 400; ++n) {
    const CornerWave a = dice.corner();
    const CornerWave b = dice.corner();
    // Third corners on either side, and the edge's corners at other places of the triangle.
    const Corners left{a, b, dice.corner()};
    const Corners right{b, dice.corner(), a};
    mixed += orientable(left) != orientable(right);
    const float t = dice.number(0, 1);
    EXPECT_NEAR(fragment_phase(left, {1 - t, t, 0}).z.imag(),
                fragment_phase(right, {t, 0, 1 - t}).z.imag(), 1e-5);
  }
  EXPECT_GT(mixed, 50);
}

TEST(FragmentPhase, SplitTriangleHasNoSeamAlongItsCuts) {
  Dice dice;
  int seen = 0;
  for (int n = 0; n < 400; ++n) {
    const Corners corners = dice.corners();
    if (orientable(corners)) continue;
    ++seen;
    const float t = dice.number(0.05f, 1);  // along the cut from the barycentre to corner 0
    const Vec3 cut((1 + 2 * t) / 3, (1 - t) / 3, (1 - t) / 3);
    const Vec3 aside(0, 1e-6f, -1e-6f);
    EXPECT_NEAR(fragment_phase(corners, cut + aside).z.imag(),
                fragment_phase(corners, cut - aside).z.imag(), 2e-3);
  }
  EXPECT_GT(seen, 50);
}

TEST(FragmentPhase, SingularTriangleHasAPeakOrATroughAtItsBarycentre) {
  Dice dice;
  int peaks = 0, troughs = 0;
  for (int n = 0; n < 400; ++n) {
    const Corners corners = dice.corners();
    if (orientable(corners)) continue;
    const float centre = fragment_phase(corners, Vec3::Constant(1.0f / 3)).z.imag();
    EXPECT_NEAR(std::abs(centre), 1, 1e-5);
    (centre > 0 ? peaks : troughs) += 1;
    // All ways lead there: nothing turns about the barycentre.
    for (int way = 0; way < 12; ++way) {
      const Vec3 aside = dice.barycentric() - Vec3::Constant(1.0f / 3);
      const Vec3 near = Vec3::Constant(1.0f / 3) + 0.01f * aside;
      EXPECT_NEAR(fragment_phase(corners, near).z.imag(), centre, 0.05);
    }
  }
  EXPECT_GT(peaks, 20);
  EXPECT_GT(troughs, 20);
}

TEST(FragmentPhase, OrderOfCornersDoesNotMatter) {
  Dice dice;
  for (int n = 0; n < 400; ++n) {
    const Corners c = dice.corners();
    const Vec3 b = dice.barycentric();
    const float sine = fragment_phase(c, b).z.imag();
    EXPECT_NEAR(fragment_phase({c[1], c[2], c[0]}, {b[1], b[2], b[0]}).z.imag(), sine, 2e-4);
    EXPECT_NEAR(fragment_phase({c[1], c[0], c[2]}, {b[1], b[0], b[2]}).z.imag(), sine, 2e-4);
  }
}

TEST(FragmentPhase, EdgeBetweenOppositePhasesHasTwoSidesThatAgree) {
  // Half a turn is left: either way along the edge is as long as the other.
  Dice dice;
  const auto wave = [&](const Vec3& p, float turns) {
    return CornerWave{{p, Vec3(0, 1, 0), 1}, phase(turns)};
  };
  for (int n = 0; n < 100; ++n) {
    const float turns = 0.25f * static_cast<float>(n % 4);
    const CornerWave a = wave({0, 0, 0}, turns), b = wave({1, 0, 0}, turns + 0.5f);
    const CornerWave c = dice.corner(), d = dice.corner();
    const float t = dice.number(0, 1);
    EXPECT_NEAR(fragment_phase({a, b, c}, {1 - t, t, 0}).z.imag(),
                fragment_phase({flipped(b), flipped(a), d}, {t, 1 - t, 0}).z.imag(), 1e-5);
  }
}

TEST(FragmentPhase, RigidMotionChangesNothing) {
  Dice dice;
  for (int n = 0; n < 200; ++n) {
    const Corners corners = dice.corners();
    const Eigen::Matrix3f turn =
        Eigen::AngleAxisf(dice.number(0, 6), dice.point().normalized()).toRotationMatrix();
    const Vec3 shift = 3 * dice.point();
    Corners moved = corners;
    for (CornerWave& corner : moved) {
      corner.wave.position = turn * corner.wave.position + shift;
      corner.wave.direction = turn * corner.wave.direction;
    }
    const Vec3 b = dice.barycentric();
    EXPECT_NEAR(std::abs(fragment_phase(moved, b).z.imag() - fragment_phase(corners, b).z.imag()),
                0, 2e-4);
  }
}

TEST(FragmentPhase, CornerWithoutWaveLeavesNone) {
  Dice dice;
  Corners corners = dice.corners();
  corners[1].wave.direction = Vec3::Zero();
  EXPECT_EQ(fragment_phase(corners, dice.barycentric()).z, Complex(0));
  EXPECT_EQ(split_fragment_phase(corners, dice.barycentric()).z, Complex(0));
}

TEST(CommonOrientation, SignsMakeAllDirectionsRunAlike) {
  Dice dice;
  int found = 0;
  for (int n = 0; n < 200; ++n) {
    const std::array<Vec3, 3> d{dice.point(), dice.point(), dice.point()};
    const auto s = common_orientation(d);
    const bool exists = d[0].dot(d[1]) * d[1].dot(d[2]) * d[2].dot(d[0]) > 0;
    ASSERT_EQ(s.has_value(), exists);
    if (!s) continue;
    ++found;
    EXPECT_EQ((*s)[0], 1);
    for (int m = 0; m < 3; ++m) {
      EXPECT_GT((*s)[m] * (*s)[(m + 1) % 3] * d[m].dot(d[(m + 1) % 3]), 0);
    }
  }
  EXPECT_GT(found, 50);
}

}  // namespace
}  // namespace brindle
