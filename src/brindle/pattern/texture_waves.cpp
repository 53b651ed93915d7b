#include "brindle/texture_waves.h"

#include <numbers>
#include <string>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/pattern/corner_signs.h"

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

std::array<Vec3, 3> directions_of(const CornerWaves& corners) {
  return {corners[0].wave.direction, corners[1].wave.direction, corners[2].wave.direction};
}

float sum(const Signs& signs) { return signs[0] + signs[1] + signs[2]; }

void negate(Signs& signs) {
  for (float& sign : signs) sign = -sign;
}

bool has_zero(const std::array<Vec3, 3>& directions) {
  return directions[0].isZero(0) || directions[1].isZero(0) || directions[2].isZero(0);
}

CornerWave corner_at(const VertexWaves& waves, Index vertex, bool turned) {
  const CornerWave corner{
      {waves.positions[vertex], waves.directions[vertex], waves.frequencies[vertex]},
      waves.z[vertex]};
  return turned ? flipped(corner) : corner;
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

void turn_round(CornerWaves& corners) {
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

CornerSigns corner_signs(const std::array<Vec3, 3>& u, const std::array<Vec3, 3>& v) {
  auto signs_u = common_orientation(u);
  auto signs_v = common_orientation(v);
  if (!signs_u || !signs_v) return kUnoriented;
  if (sum(*signs_u) < 0) negate(*signs_u);
  float kept = 0;
  for (int m = 0; m < 3; ++m) kept += (*signs_u)[m] * (*signs_v)[m];
  if (kept < 0) negate(*signs_v);
  unsigned signs = has_zero(u) || has_zero(v) ? kUnoriented : 0;
  for (unsigned m = 0; m < 3; ++m) {
    signs |= static_cast<unsigned>((*signs_u)[m] < 0) << m;
    signs |= static_cast<unsigned>((*signs_v)[m] < 0) << (m + 3);
  }
  return static_cast<CornerSigns>(signs);
}

void corner_signs(std::span<const Triangle> triangles, std::span<const Vec3> u,
                  std::span<const Vec3> v, std::vector<CornerSigns>& signs) {
  signs.resize(triangles.size());
  parallel_for(triangles.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto& [a, b, c] = triangles[t];
      signs[t] = corner_signs({u[a], u[b], u[c]}, {v[a], v[b], v[c]});
    }
  });
}

void turn_signs(std::span<const std::uint8_t> turned, std::span<CornerSigns> signs) {
  for (std::size_t t = 0; t < signs.size(); ++t) {
    if (turned[t]) signs[t] ^= kTurnedRound;
  }
}

void set_texture_waves(std::span<const Triangle> triangles, std::span<const CornerSigns> signs,
                       const VertexWaves& u, const VertexWaves& v, TextureWaves& waves,
                       const Progress& progress) {
  waves.u.resize(triangles.size());
  progress.tick();
  waves.v.resize(triangles.size());
  parallel_for(triangles.size(), progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      for (Index m = 0; m < 3; ++m) {
        waves.u[t][m] = corner_at(u, triangles[t][m], turns_u(signs[t], m));
        waves.v[t][m] = corner_at(v, triangles[t][m], turns_v(signs[t], m));
      }
    }
  });
}

void orient_corners(TextureWaves& waves, const Progress& progress) {
  parallel_for(waves.triangle_count(), progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const CornerSigns signs = corner_signs(directions_of(waves.u[t]), directions_of(waves.v[t]));
      for (Index m = 0; m < 3; ++m) {
        if (turns_u(signs, m)) waves.u[t][m] = flipped(waves.u[t][m]);
        if (turns_v(signs, m)) waves.v[t][m] = flipped(waves.v[t][m]);
      }
    }
  });
}

// Keep in step with shaders/texture_fragment.glsl.
TextureFragment texture_fragment(const CornerWaves& u, const CornerWaves& v,
                                 const Vec3& barycentric) {
  return {split_fragment_phase(u, barycentric), split_fragment_phase(v, barycentric)};
}

float texture_coordinate(Complex z) {
  return elementary::arg(z) / (2 * std::numbers::pi_v<float>)+0.25f;
}

}  // namespace brindle
