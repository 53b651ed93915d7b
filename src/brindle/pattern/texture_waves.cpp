#include "brindle/texture_waves.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "brindle/base/parallel.h"
#include "brindle/error.h"

namespace brindle {
namespace {

using Signs = std::array<float, 3>;

void check_size(std::size_t size, std::size_t vertices, const char* what) {
  if (size == vertices) return;
  throw Error("texture: there are " + std::to_string(size) + " " + what + " for " +
              std::to_string(vertices) + " vertices");
}

void check_waves(const WaveSet& waves, std::span<const Complex> z, std::size_t vertices) {
  check_size(waves.positions.size(), vertices, "positions");
  check_size(waves.directions.size(), vertices, "directions");
  check_size(waves.frequencies.size(), vertices, "frequencies");
  check_size(z.size(), vertices, "phases");
}

std::optional<Signs> common_signs(const CornerWaves& corners) {
  return common_orientation(
      {corners[0].wave.direction, corners[1].wave.direction, corners[2].wave.direction});
}

float sum(const Signs& signs) { return signs[0] + signs[1] + signs[2]; }

void negate(Signs& signs) {
  for (float& sign : signs) sign = -sign;
}

void turn_round(const Signs& signs, CornerWaves& corners) {
  for (int m = 0; m < 3; ++m) {
    if (signs[m] < 0) corners[m] = flipped(corners[m]);
  }
}

void orient(CornerWaves& u, CornerWaves& v) {
  auto signs_u = common_signs(u);
  auto signs_v = common_signs(v);
  if (!signs_u || !signs_v) return;
  if (sum(*signs_u) < 0) negate(*signs_u);
  float kept = 0;
  for (int m = 0; m < 3; ++m) kept += (*signs_u)[m] * (*signs_v)[m];
  if (kept < 0) negate(*signs_v);
  turn_round(*signs_u, u);
  turn_round(*signs_v, v);
}

}  // namespace

TextureWaves texture_waves(std::span<const Triangle> triangles, const WaveSet& u,
                           std::span<const Complex> z_u, const WaveSet& v,
                           std::span<const Complex> z_v) {
  check_waves(u, z_u, u.positions.size());
  check_waves(v, z_v, u.positions.size());
  TextureWaves waves;
  waves.u.resize(triangles.size());
  waves.v.resize(triangles.size());
  parallel_for(triangles.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      waves.u[t] = corner_waves(triangles[t], u, z_u);
      waves.v[t] = corner_waves(triangles[t], v, z_v);
    }
  });
  return waves;
}

void flip(CornerWaves& corners) {
  for (CornerWave& corner : corners) corner = flipped(corner);
}

bool run_alike(const CornerWaves& corners) {
  for (int m = 0; m < 3; ++m) {
    const Vec3& direction = corners[m].wave.direction;
    if (direction.isZero(0) || direction.dot(corners[(m + 1) % 3].wave.direction) < 0) return false;
  }
  return true;
}

bool is_oriented(const TextureWaves& waves, std::size_t triangle) {
  return run_alike(waves.u[triangle]) && run_alike(waves.v[triangle]);
}

void orient_corners(TextureWaves& waves) {
  parallel_for(waves.triangle_count(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) orient(waves.u[t], waves.v[t]);
  });
}

// The twin is shaders/texture_fragment.glsl.
TextureFragment texture_fragment(const CornerWaves& u, const CornerWaves& v,
                                 const Vec3& barycentric) {
  const bool oriented = run_alike(u) && run_alike(v);
  const auto phase = oriented ? oriented_fragment_phase : split_fragment_phase;
  return {phase(u, barycentric), phase(v, barycentric)};
}

float texture_coordinate(Complex z) { return std::arg(z) / (2 * std::numbers::pi_v<float>)+0.25f; }

}  // namespace brindle
