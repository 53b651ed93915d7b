/// The corners of triangles at which the waves of vertices are reversed.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/texture_waves.h"

namespace brindle {

/// Bit m: U at corner m is the vertex's reversed wave; bit 3 + m: V is. kUnoriented: the corners
/// cannot be oriented alike, or one has no wave. Texture orientation uses nothing else.
using CornerSigns = std::uint8_t;
inline constexpr CornerSigns kTurnedRound = 0x3f;
inline constexpr CornerSigns kUnoriented = 0x40;

inline bool turns_u(CornerSigns signs, Index corner) { return (signs >> corner & 1) != 0; }
inline bool turns_v(CornerSigns signs, Index corner) { return (signs >> (corner + 3) & 1) != 0; }

/// The waves that `orient_corners` reverses, for corners with these directions.
CornerSigns corner_signs(const std::array<Vec3, 3>& u, const std::array<Vec3, 3>& v);

/// The same for all triangles, from the directions of the vertices.
void corner_signs(std::span<const Triangle> triangles, std::span<const Vec3> u,
                  std::span<const Vec3> v, std::vector<CornerSigns>& signs);

/// Reverses all three waves (`flipped`).
void turn_round(CornerWaves& corners);

/// Reverses the triangles marked 1.
void turn_signs(std::span<const std::uint8_t> turned, std::span<CornerSigns> signs);

/// The waves of one of a texture's patterns, one per vertex, with their phases.
struct VertexWaves {
  std::span<const Vec3> positions;
  std::span<const Vec3> directions;
  std::span<const float> frequencies;
  std::span<const Complex> z;
};

/// Sets the waves at the corners of all triangles, reversed according to `signs`. Allocates nothing
/// if `waves` has enough capacity.
void set_texture_waves(std::span<const Triangle> triangles, std::span<const CornerSigns> signs,
                       const VertexWaves& u, const VertexWaves& v, TextureWaves& waves,
                       const Progress& progress = {});

}  // namespace brindle
