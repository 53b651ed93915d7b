/// Waves and lifted phases at the corners of triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// A wave with its phase, z = exp(i Phi).
struct CornerWave {
  Wave wave;
  Complex z;
};

/// The same wave reversed: -d with pi - Phi, that is -conj(z).
CornerWave flipped(const CornerWave& corner);

/// The waves at the corners of one triangle, as stored at its vertices.
std::array<CornerWave, 3> corner_waves(const Triangle& triangle, const WaveSet& waves,
                                       std::span<const Complex> z);

/// Kinds of triangles, by the phases at their corners.
enum class TriangleKind : std::uint8_t {
  regular,            ///< phases lift to linear coordinates
  branch,             ///< the phase does not close: a stripe begins or ends here
  field_singularity,  ///< the corners cannot be oriented alike
  no_wave             ///< a corner has no wave
};

/// Whether a triangle counts in `PatternQuality::branches`.
inline bool is_branch(TriangleKind kind) {
  return kind == TriangleKind::branch || kind == TriangleKind::field_singularity;
}

/// Whether the corners of such a triangle have lifted phases.
inline bool is_lifted(TriangleKind kind) {
  return kind == TriangleKind::regular || kind == TriangleKind::branch;
}

/// The result of `corner_phases` for one triangle.
struct CornerPhases {
  std::array<float, 3> phase{};       ///< lifted phases of the oriented corners, in radians
  std::array<std::int8_t, 3> sign{};  ///< s_m: -1 where the corner's wave was reversed
  std::int8_t branch_index = 0;       ///< closing error over 2 pi, clamped to -127 .. 127
  TriangleKind kind = TriangleKind::no_wave;
};

/// The phase step from corner j to corner i, which run alike, in radians: the phase shift Phi_ji
/// plus the rest of the phase difference, wrapped to -pi .. pi.
float lifted_step(const CornerWave& j, const CornerWave& i, PhaseShiftKind kind);

/// Orients the corners alike (a reversed corner has pi - Phi), then lifts phases around the
/// triangle: each step is the phase shift plus the wrapped remainder. The closing error over 2 pi
/// is the branch index. A corner without direction has no wave, nor has a triangle whose phases are
/// no numbers.
CornerPhases corner_phases(const std::array<CornerWave, 3>& corners, PhaseShiftKind kind);

/// As above for all triangles of a mesh, with one wave per vertex.
std::vector<CornerPhases> corner_phases(std::span<const Triangle> triangles, const WaveSet& waves,
                                        std::span<const Complex> z, PhaseShiftKind kind,
                                        const Progress& progress = {});

/// As above, into `corners` with one entry per triangle. Allocates nothing, for use in frames.
/// Throws Error for another number of entries.
void fill_corner_phases(std::span<const Triangle> triangles, const WaveSet& waves,
                        std::span<const Complex> z, PhaseShiftKind kind,
                        std::span<CornerPhases> corners, const Progress& progress = {});

/// As above for triangles whose corners have their own waves (`TextureWaves`).
std::vector<CornerPhases> corner_phases(std::span<const std::array<CornerWave, 3>> triangles,
                                        PhaseShiftKind kind, const Progress& progress = {});

}  // namespace brindle
