#include "brindle/curve_measures.h"

#include <cmath>

#include <gtest/gtest.h>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/pattern/curve_spacing.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::wavy_surface;
using testing_support::WavySurface;

/// A cylinder of radius 1/2 and height 2 with a ring wherever f z + shift is whole.
struct Rings {
  static constexpr float kFrequency = 7;
  WavySurface surface = wavy_surface("cylinder,resolution=96", Vec3(0, 0, 1), 10);
  MeshEdges edges = mesh_edges(surface.mesh, *surface.neighborhood);
  std::vector<Complex> z;

  explicit Rings(float shift) {
    for (std::size_t i = 0; i < surface.mesh.vertex_count(); ++i) {
      surface.waves.directions[i] = Vec3::UnitZ();
      surface.waves.frequencies[i] = kFrequency;
      // Peaks are at a quarter of a turn.
      z.push_back(
          std::polar(1.0f, kTwoPi * (kFrequency * surface.mesh.positions[i].z() + shift + 0.25f)));
    }
  }
  WavePattern pattern() const { return {surface.mesh, edges, surface.normals, surface.waves, z}; }
  StripeCurves curves() const { return stripe_curves(LiftedWaves(pattern())); }
  double around() const { return 96 * 2 * 0.5 * std::sin(std::acos(-1) / 96); }
};

TEST(CurveMeasures, OfRingsAreExact) {
  // At z = k / 7 from -1 to 1, but for both rims: 13 rings within.
  const Rings rings(0.001f);
  const CurveLengths lengths = curve_lengths(rings.curves().lines);
  EXPECT_EQ(lengths.open, 0u);
  EXPECT_EQ(lengths.open_length, 0);
  ASSERT_EQ(lengths.closed, 14u);  // the one at the upper rim is 0.001 / 7 inside
  EXPECT_NEAR(lengths.closed_length, 14 * rings.around(), 1e-3);
  EXPECT_NEAR(lengths.shortest, rings.around(), 1e-4);
  EXPECT_NEAR(lengths.longest, rings.around(), 1e-4);
  EXPECT_NEAR(lengths.mean, rings.around(), 1e-4);
}

TEST(CurveMeasures, CoverageOfRingsIsWidthOverSpacing) {
  const Rings rings(0.5f);  // 14 rings, half a spacing from the rims
  const StripeCurves curves = rings.curves();
  const Mesh& mesh = rings.surface.mesh;
  for (const double share : {0.05, 0.3, 0.9}) {
    EXPECT_NEAR(curve_coverage(mesh, curves.lines, share / Rings::kFrequency), share, 0.003);
  }
  EXPECT_EQ(curve_coverage(mesh, curves.lines, 2), 1);
  EXPECT_EQ(curve_coverage(mesh, {}, 2), 0);
  for (const double bad : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(curve_coverage(mesh, curves.lines, bad), Error);
  }
}

TEST(CurveMeasures, RingsWiderThanTheirSpacingCoverTwice) {
  const Rings rings(0.5f);
  const StripeCurves curves = rings.curves();
  const Mesh& mesh = rings.surface.mesh;
  for (const double share : {0.3, 0.99}) {
    const CurveCoverage coverage = measure_coverage(mesh, curves.lines, share / Rings::kFrequency);
    EXPECT_NEAR(coverage.once, share, 0.003);
    EXPECT_EQ(coverage.twice, 0) << share;
  }
  // Between the 13 pairs of neighbours what is more than the spacing.
  for (const double share : {1.2, 1.5, 1.9}) {
    const CurveCoverage coverage = measure_coverage(mesh, curves.lines, share / Rings::kFrequency);
    EXPECT_EQ(coverage.once, 1);
    EXPECT_NEAR(coverage.twice, (share - 1) * 13 / 14, 0.005) << share;
  }
  EXPECT_EQ(measure_coverage(mesh, {}, 2).twice, 0);
  EXPECT_THROW(measure_coverage(mesh, curves.lines, 0), Error);
}

TEST(CurveMeasures, CoverageDoesNotReachBeyondTheRim) {
  // A ring on either rim covers half as much as another: 15 rings, as much as 14 in all.
  Rings rings(0.0001f);
  StripeCurves curves = rings.curves();
  ASSERT_EQ(curves.lines.count(), 14u);
  EXPECT_NEAR(curve_coverage(rings.surface.mesh, curves.lines, 0.2 / Rings::kFrequency),
              0.2 * 13.5 / 14, 0.003);
}

TEST(CurveMeasures, CoverageIsTheSameForEveryNumberOfThreads) {
  const Rings rings(0.5f);
  const StripeCurves curves = rings.curves();
  const ThreadLimit one(1);
  const double alone = curve_coverage(rings.surface.mesh, curves.lines, 0.05);
  const ThreadLimit two(2);
  EXPECT_EQ(curve_coverage(rings.surface.mesh, curves.lines, 0.05), alone);
}

TEST(CurveMeasures, OfNoCurvesAreZero) {
  const CurveLengths lengths = curve_lengths({});
  EXPECT_EQ(lengths.closed + lengths.open, 0u);
  EXPECT_EQ(lengths.shortest, 0);
  EXPECT_EQ(lengths.mean, 0);
}

#ifdef BRINDLE_HAS_NANOFLANN

TEST(CurveMeasures, GapsOfRingsAreTheirSpacing) {
  Rings rings(0.5f);
  const CurveGaps gaps = measure_curve_spacing(rings.pattern(), rings.curves()).gaps;
  EXPECT_GT(gaps.measured, 1000u);
  for (const double gap : {gaps.least, gaps.mean, gaps.most}) EXPECT_NEAR(gap, 1.0 / 7, 1e-4);
  for (const double r : {gaps.least_ratio, gaps.mean_ratio, gaps.most_ratio}) {
    EXPECT_NEAR(r, 1, 1e-3);
  }
  // The same rings, were twice as many asked for.
  const StripeCurves curves = rings.curves();
  for (float& f : rings.surface.waves.frequencies) f *= 2;
  const CurveGaps wide = measure_curve_spacing(rings.pattern(), curves).gaps;
  EXPECT_NEAR(wide.mean, 1.0 / 7, 1e-4);
  EXPECT_NEAR(wide.most_ratio, 2, 1e-3);
}

TEST(CurveMeasures, GapsAreToldOfTheFrequenciesAskedForAndChosen) {
  const Rings rings(0.5f);
  const StripeCurves curves = rings.curves();
  const std::vector<float> wanted(rings.z.size(), 0.8f * Rings::kFrequency);
  const CurveSpacing spacing =
      measure_curve_spacing(rings.pattern(), curves, kMostSpacingPoints, wanted);
  EXPECT_NEAR(spacing.mean, 1, 1e-3);
  EXPECT_EQ(spacing.share_within_10_percent, 1);
  EXPECT_NEAR(spacing.mean_wanted, 0.8, 1e-3);
  EXPECT_EQ(spacing.share_within_10_percent_wanted, 0);
  EXPECT_NEAR(spacing.gaps.mean_ratio_chosen, 1, 1e-3);
  EXPECT_NEAR(spacing.gaps.mean_ratio, 0.8, 1e-3);
  // Without others, both are the same.
  const CurveSpacing alone = measure_curve_spacing(rings.pattern(), curves);
  EXPECT_EQ(alone.mean_wanted, alone.mean);
  EXPECT_EQ(alone.deviation_wanted, alone.deviation);
  EXPECT_EQ(alone.gaps.most_ratio, alone.gaps.most_ratio_chosen);
}

#endif

}  // namespace
}  // namespace brindle
