#include "brindle/pattern/curve_spacing.h"

#include <cmath>

#include <gtest/gtest.h>

#include "brindle/base/elementary.h"
#include "brindle/error.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::wavy_surface;
using testing_support::WavySurface;

#ifdef BRINDLE_HAS_NANOFLANN

CurveSpacing spacing_of(const WavySurface& surface, std::span<const Complex> z) {
  const MeshEdges edges = mesh_edges(surface.mesh, *surface.neighborhood);
  const WavePattern pattern{surface.mesh, edges, surface.normals, surface.waves, z};
  return measure_curve_spacing(pattern, stripe_curves(LiftedWaves(pattern)));
}

TEST(CurveSpacing, OfAPlaneWaveIsOne) {
  WavySurface surface = wavy_surface("plane,resolution=20", Vec3(1, 0.4f, 0), 30);
  std::vector<Complex> z;
  for (std::size_t i = 0; i < surface.mesh.vertex_count(); ++i) {
    z.push_back(std::polar(1.0f, kTwoPi * surface.waves.frequencies[i] *
                                     surface.waves.directions[i].dot(surface.mesh.positions[i])));
  }
  const CurveSpacing spacing = spacing_of(surface, z);
  EXPECT_GT(spacing.measured, 1000u);
  EXPECT_NEAR(spacing.mean, 1, 1e-3);
  EXPECT_NEAR(spacing.deviation, 0, 0.01);
  EXPECT_GT(spacing.share_within_10_percent, 0.999);

  // The same lines, were they asked to be a quarter closer.
  WavySurface wrong = surface;
  const MeshEdges edges = mesh_edges(surface.mesh, *surface.neighborhood);
  const WavePattern right{surface.mesh, edges, surface.normals, surface.waves, z};
  const StripeCurves curves = stripe_curves(LiftedWaves(right));
  for (float& f : wrong.waves.frequencies) f *= 1.25f;
  const CurveSpacing off =
      measure_curve_spacing({wrong.mesh, edges, wrong.normals, wrong.waves, z}, curves);
  EXPECT_NEAR(off.mean, 1.25, 2e-3);
  EXPECT_EQ(off.share_within_10_percent, 0);
}

TEST(CurveSpacing, IsMeasuredAlongArcs) {
  // Lines along a cylinder, twelve around it: chords are 1.1 % shorter than arcs.
  WavySurface surface = wavy_surface("cylinder,resolution=96", Vec3(0, 0, 1), 10);
  std::vector<Complex> z;
  for (std::size_t i = 0; i < surface.mesh.vertex_count(); ++i) {
    const Vec3& p = surface.mesh.positions[i];
    surface.waves.directions[i] = Vec3(-p.y(), p.x(), 0).normalized();
    surface.waves.frequencies[i] = 12 / (kTwoPi * p.head<2>().norm());
    z.push_back(std::polar(1.0f, 12 * std::atan2(p.y(), p.x()) + 0.3f));
  }
  const CurveSpacing spacing = spacing_of(surface, z);
  EXPECT_NEAR(spacing.mean, 1, 0.003);
  EXPECT_GT(spacing.share_within_10_percent, 0.999);
}

TEST(CurveSpacing, IsNotMeasuredBeyondThePointsAllowed) {
  const WavySurface surface = wavy_surface("plane,resolution=20", Vec3(1, 0.4f, 0), 30);
  const std::vector<Complex> z(surface.mesh.vertex_count(), Complex(1));
  const MeshEdges edges = mesh_edges(surface.mesh, *surface.neighborhood);
  const WavePattern pattern{surface.mesh, edges, surface.normals, surface.waves, z};
  const StripeCurves curves = stripe_curves(LiftedWaves(pattern));
  EXPECT_EQ(measure_curve_spacing(pattern, curves, 100).measured, 0u);
  EXPECT_GT(measure_curve_spacing(pattern, curves).measured, 100u);
}

TEST(CurveSpacing, NoCurvesMeasureNothing) {
  WavySurface surface = wavy_surface("plane,resolution=4", Vec3(1, 0.4f, 0), 3);
  for (Vec3& d : surface.waves.directions) d.setZero();
  const std::vector<Complex> z(surface.mesh.vertex_count(), Complex(1));
  EXPECT_EQ(spacing_of(surface, z).measured, 0u);
}

#else

TEST(CurveSpacing, IsAnErrorInABuildWithoutNanoflann) {
  const WavySurface surface = wavy_surface("plane,resolution=20", Vec3(1, 0.4f, 0), 30);
  const std::vector<Complex> z(surface.mesh.vertex_count(), Complex(1));
  const MeshEdges edges = mesh_edges(surface.mesh, *surface.neighborhood);
  const WavePattern pattern{surface.mesh, edges, surface.normals, surface.waves, z};
  EXPECT_THROW(measure_curve_spacing(pattern, stripe_curves(LiftedWaves(pattern))), Error);
}

#endif

}  // namespace
}  // namespace brindle
