/// What shaders of your own need to draw a pattern at every pixel, in the layout that the installed
/// GLSL reads (docs/gpu.md).
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

/// 48 bytes: three times four floats, as textures and storage buffers have them.
struct PatternVertex {
  std::array<float, 3> position;
  float frequency;  ///< stripes per unit length
  std::array<float, 3> direction;
  float cosine;  ///< of the phase
  std::array<float, 3> normal;
  float sine;  ///< of the phase
};
static_assert(sizeof(PatternVertex) == 48);

/// 16 bytes. Triangles in which a stripe begins or ends need no more than others: shaders find the
/// phase at every pixel from the three corners.
struct PatternTriangle {
  std::array<std::uint32_t, 3> vertices;
  std::uint32_t kind;  ///< a TriangleKind; regular where nothing was said
};
static_assert(sizeof(PatternTriangle) == 16);

/// A pattern, or a frame of one. All have one entry per vertex.
struct PatternArrays {
  std::span<const Vec3> positions;
  std::span<const Vec3> normals;     ///< of unit length, or zero
  std::span<const Vec3> directions;  ///< of unit length, or zero for no wave
  std::span<const float> frequencies;
  std::span<const Complex> z;  ///< phases, as StripePattern and FrameResult have them
};

struct PatternBuffers {
  std::vector<PatternVertex> vertices;
  std::vector<PatternTriangle> triangles;
};

/// Fills both. `corners` has one entry per triangle, or none: then no kinds are known.
/// Throws Error, naming what does not fit, if sizes differ or a triangle has no such vertex.
PatternBuffers pattern_buffers(const PatternArrays& arrays, std::span<const Triangle> triangles,
                               std::span<const CornerPhases> corners = {});

/// Fills the vertices alone, as a frame needs it: into memory of yours, such as a mapped buffer,
/// with one entry per vertex. Throws Error as `pattern_buffers` does.
void fill_pattern_vertices(const PatternArrays& arrays, std::span<PatternVertex> vertices);

}  // namespace brindle
