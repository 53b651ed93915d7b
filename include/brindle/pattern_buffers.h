/// Buffers for your own shaders to draw a pattern at every pixel, in the layout of the installed
/// GLSL (docs/gpu.md).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/corner_phases.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// A vertex of 48 bytes: three times four floats, for textures and storage buffers.
struct PatternVertex {
  std::array<float, 3> position;
  float frequency;  ///< stripes per unit length
  std::array<float, 3> direction;
  float cosine;  ///< of the phase
  std::array<float, 3> normal;
  float sine;  ///< of the phase
};
static_assert(sizeof(PatternVertex) == 48);

/// A triangle of 16 bytes. Triangles in which a stripe begins or ends need no special data: shaders
/// find the phase at every pixel from the three corners.
struct PatternTriangle {
  std::array<std::uint32_t, 3> vertices;
  std::uint32_t kind;  ///< a TriangleKind; regular if unknown
};
static_assert(sizeof(PatternTriangle) == 16);

/// A pattern, or a frame of one, with one entry per vertex each.
struct PatternArrays {
  std::span<const Vec3> positions;
  std::span<const Vec3> normals;     ///< of unit length, or zero
  std::span<const Vec3> directions;  ///< of unit length, or zero for no wave
  std::span<const float> frequencies;
  std::span<const Complex> z;  ///< phases, as in StripePattern and FrameResult
};

/// The contents of both buffers.
struct PatternBuffers {
  std::vector<PatternVertex> vertices;
  std::vector<PatternTriangle> triangles;
};

/// Fills both. `corners` has one entry per triangle, or is empty if kinds are unknown. Throws
/// Error, naming the mismatch, if sizes differ or a triangle has no such vertex.
PatternBuffers pattern_buffers(const PatternArrays& arrays, std::span<const Triangle> triangles,
                               std::span<const CornerPhases> corners = {});

/// Fills only the vertices, for frames, into your own memory, such as a mapped buffer, with one
/// entry per vertex. Throws Error as `pattern_buffers` does.
void fill_pattern_vertices(const PatternArrays& arrays, std::span<PatternVertex> vertices);

}  // namespace brindle
