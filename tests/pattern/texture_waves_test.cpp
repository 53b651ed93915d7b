#include "brindle/texture_waves.h"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "brindle/error.h"
#include "brindle/fragment_phase.h"
#include "brindle/normals.h"
#include "phase_graphs.h"

namespace brindle {
namespace {

using testing_support::flip_half;
using testing_support::wavy_surface;

/// A shape with waves along two orthogonal fields and random phases.
struct Pair {
  testing_support::WavySurface surface;
  WaveSet v;
  std::vector<Complex> z_u, z_v;

  TextureWaves texture() const {
    return texture_waves(surface.mesh.triangles, surface.waves, z_u, v, z_v);
  }
};

Pair random_pair(std::string_view shape, std::uint32_t seed) {
  Pair pair{wavy_surface(shape, Vec3(0.3f, 0.9f, 0.2f), 20), {}, {}, {}};
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> angle(-3, 3);
  flip_half(pair.surface.waves, seed);
  pair.v = pair.surface.waves;
  pair.v.directions =
      rotated(pair.surface.waves.directions, pair.surface.normals, std::numbers::pi_v<float> / 2);
  for (std::size_t i = 0; i < pair.v.positions.size(); ++i) {
    pair.z_u.push_back(std::polar(1.0f, angle(random)));
    pair.z_v.push_back(std::polar(1.0f, angle(random)));
  }
  return pair;
}

/// +1 where U, V and the triangle's normal are right-handed at the corner.
float handedness(const Mesh& mesh, const TextureWaves& waves, std::size_t t, int m) {
  const Vec3 normal = triangle_normal(mesh, mesh.triangles[t]);
  return waves.u[t][m].wave.direction.cross(waves.v[t][m].wave.direction).dot(normal);
}

TEST(TextureWaves, OrientationMakesCornersRunAlikeAndKeepsTheTurnFromUToV) {
  for (const char* shape : {"torus,resolution=40", "sphere,resolution=12", "trefoil"}) {
    const Pair pair = random_pair(shape, 3);
    TextureWaves waves = pair.texture();
    orient_corners(waves);
    std::size_t oriented = 0;
    for (std::size_t t = 0; t < waves.triangle_count(); ++t) {
      if (!run_alike(waves.u[t]) || !run_alike(waves.v[t])) continue;
      ++oriented;
      for (int m = 0; m < 3; ++m) EXPECT_GT(handedness(pair.surface.mesh, waves, t, m), 0);
    }
    EXPECT_GT(oriented, waves.triangle_count() * 9 / 10) << shape;
  }
}

TEST(TextureWaves, OrientationLeavesMostCornersAsTheyStand) {
  const Pair pair = random_pair("torus,resolution=40", 5);
  const TextureWaves before = pair.texture();
  TextureWaves after = before;
  orient_corners(after);
  for (std::size_t t = 0; t < after.triangle_count(); ++t) {
    int kept = 0;
    for (int m = 0; m < 3; ++m) {
      kept += after.u[t][m].wave.direction == before.u[t][m].wave.direction;
    }
    EXPECT_GE(kept, 2);
  }
}

TEST(TextureWaves, OrientationChangesNoFragmentButForItsSign) {
  const Pair pair = random_pair("sphere,resolution=8", 7);
  const TextureWaves before = pair.texture();
  TextureWaves after = before;
  orient_corners(after);
  const Vec3 point(0.5f, 0.3f, 0.2f);
  for (std::size_t t = 0; t < after.triangle_count(); ++t) {
    const FragmentWave a = fragment_phase(before.u[t], point);
    const FragmentWave b = fragment_phase(after.u[t], point);
    EXPECT_NEAR(a.z.imag(), b.z.imag(), 2e-4f);
  }
}

TEST(TextureWaves, CoordinatesOfAFlippedWaveAreNegative) {
  for (float phase = -3; phase < 3; phase += 0.37f) {
    const CornerWave wave{{Vec3::Zero(), Vec3::UnitX(), 1}, std::polar(1.0f, phase)};
    const float sum = texture_coordinate(wave.z) + texture_coordinate(flipped(wave).z);
    EXPECT_NEAR(sum, std::round(sum), 1e-6f);
  }
  EXPECT_FLOAT_EQ(texture_coordinate({0, 1}), 0.5f);
}

TEST(TextureWaves, RefuseWavesOfAnotherSize) {
  Pair pair = random_pair("torus,resolution=16", 1);
  pair.z_v.pop_back();
  EXPECT_THROW(pair.texture(), Error);
}

}  // namespace
}  // namespace brindle
