#include "brindle/phase_shift.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "brindle/waves/parsed_words.h"

namespace brindle {
namespace {

struct PlanarWaves {
  Wave j, i;
  Vec3 source;
};

Vec3 planar(float x, float y) { return {x, y, 0}; }

/// Two waves in the plane z = 0 whose lines meet in `source`, away from both.
PlanarWaves waves_from_a_source(std::mt19937& random) {
  std::uniform_real_distribution<float> coordinate(-1, 1);
  PlanarWaves waves;
  waves.source = planar(coordinate(random) + 4, coordinate(random));
  for (Wave* wave : {&waves.j, &waves.i}) {
    wave->position = planar(coordinate(random), coordinate(random));
    wave->direction = (waves.source - wave->position).normalized();
    wave->frequency = 1;
  }
  return waves;
}

TEST(AlignedDistance, IsTheDifferenceOfTheDistancesToTheCommonSource) {
  std::mt19937 random(1);
  for (int n = 0; n < 1000; ++n) {
    const PlanarWaves w = waves_from_a_source(random);
    const float expected = (w.source - w.j.position).norm() - (w.source - w.i.position).norm();
    EXPECT_NEAR(aligned_distance(w.j.position, w.j.direction, w.i.position, w.i.direction),
                expected, 1e-5);
    EXPECT_NEAR(aligned_distance(w.j.position, w.j.direction, w.i.position, -w.i.direction),
                expected, 1e-5)
        << "turning d_i round changes nothing";
    EXPECT_NEAR(aligned_distance(w.j.position, -w.j.direction, w.i.position, w.i.direction),
                -expected, 1e-5)
        << "turning d_j round changes the sign";
  }
}

TEST(AlignedDistance, IsTheWayThroughASourceBetweenTheVertices) {
  const Vec3 source = planar(0, 0), v_j = planar(-2, -0.2f), v_i = planar(3, 0.1f);
  const Vec3 d_j = (source - v_j).normalized(), d_i = (v_i - source).normalized();
  EXPECT_NEAR(aligned_distance(v_j, d_j, v_i, d_i), v_j.norm() + v_i.norm(), 1e-5);
}

TEST(AlignedDistance, OfParallelLinesIsThePlainProjection) {
  const Vec3 d = planar(0.6f, 0.8f);
  EXPECT_NEAR(aligned_distance(planar(1, 2), d, planar(4, -3), d), 3 * 0.6 - 5 * 0.8, 1e-6);
}

TEST(PhaseShiftKinds, AgreeWithThePaperWhereTheSourceLiesOutsideTheEdge) {
  std::mt19937 random(2);
  for (int n = 0; n < 1000; ++n) {
    const PlanarWaves w = waves_from_a_source(random);
    const PhaseShift closed = phase_shift(PhaseShiftKind::aligned, w.j, w.i);
    const PhaseShift paper = phase_shift(PhaseShiftKind::common_source, w.j, w.i);
    EXPECT_NEAR(paper.radians, closed.radians, 1e-3);
    EXPECT_EQ(paper.reflecting, closed.reflecting);
  }
}

TEST(PhaseShiftKinds, ThePaperTakesASourceBetweenTheVerticesForACentre) {
  const Wave j{planar(-2, -0.2f), planar(2, 0.2f).normalized(), 1};
  const Wave i{planar(3, 0.1f), planar(3, 0.1f).normalized(), 1};
  EXPECT_TRUE(phase_shift(PhaseShiftKind::common_source, j, i).reflecting);
  EXPECT_FALSE(phase_shift(PhaseShiftKind::aligned, j, i).reflecting);
}

TEST(PhaseShiftKinds, AgreeOnParallelWavesAndUseTheGeometricMeanOfFrequencies) {
  const Wave j{planar(0, 0), planar(1, 0), 2}, i{planar(0.25f, 1), planar(1, 0), 8};
  for (const auto kind :
       {PhaseShiftKind::aligned, PhaseShiftKind::common_source, PhaseShiftKind::trapezoid}) {
    const PhaseShift shift = phase_shift(kind, j, i);
    EXPECT_NEAR(shift.radians, 2 * M_PI * 4 * 0.25, 1e-5) << name_of(kind);
    EXPECT_FALSE(shift.reflecting) << name_of(kind);
  }
}

TEST(PhaseShiftKinds, ChangeTheirSignOnTheWayBackAndKeepItAcrossAReflection) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> coordinate(-1, 1);
  const auto random_wave = [&] {
    const auto vector = [&] {
      return Vec3(coordinate(random), coordinate(random), coordinate(random));
    };
    return Wave{vector(), vector().normalized(), 1.5f + coordinate(random)};
  };
  for (const auto kind :
       {PhaseShiftKind::aligned, PhaseShiftKind::common_source, PhaseShiftKind::trapezoid}) {
    for (int n = 0; n < 300; ++n) {
      const Wave j = random_wave(), i = random_wave();
      const PhaseShift there = phase_shift(kind, j, i), back = phase_shift(kind, i, j);
      ASSERT_EQ(there.reflecting, back.reflecting);
      const float tolerance = 1e-3f * std::max(1.0f, std::abs(there.radians));
      if (kind == PhaseShiftKind::common_source) {
        ASSERT_NEAR(std::abs(back.radians), std::abs(there.radians), tolerance);
      } else {
        ASSERT_NEAR(back.radians, there.reflecting ? there.radians : -there.radians, tolerance);
      }
    }
  }
}

TEST(PhaseShiftKinds, AreFiniteForWavesInOnePlace) {
  const Wave wave{planar(1, 1), planar(1, 0), 3};
  for (const auto kind :
       {PhaseShiftKind::aligned, PhaseShiftKind::common_source, PhaseShiftKind::trapezoid}) {
    EXPECT_EQ(phase_shift(kind, wave, wave).radians, 0) << name_of(kind);
  }
}

TEST(PhaseShiftKinds, AreFoundByName) {
  for (const auto kind :
       {PhaseShiftKind::aligned, PhaseShiftKind::common_source, PhaseShiftKind::trapezoid}) {
    EXPECT_EQ(parse_phase_shift_kind(name_of(kind)), kind);
  }
  EXPECT_FALSE(parse_phase_shift_kind("alined"));
}

}  // namespace
}  // namespace brindle
