/// The waves that meet in a triangle, corner by corner.
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

/// The same wave running the other way: -d with pi - Phi, that is -conj(z).
CornerWave flipped(const CornerWave& corner);

/// The corners of one triangle, each with the wave of its vertex, as it stands there.
std::array<CornerWave, 3> corner_waves(const Triangle& triangle, const WaveSet& waves,
                                       std::span<const Complex> z);

enum class TriangleKind : std::uint8_t {
  regular,            ///< phases lift to linear coordinates
  branch,             ///< the phase does not close: a stripe begins or ends here
  field_singularity,  ///< the corners cannot be oriented alike
  no_wave             ///< a corner has no wave
};

/// Whether a triangle counts among `PatternQuality::branches`.
inline bool is_branch(TriangleKind kind) {
  return kind == TriangleKind::branch || kind == TriangleKind::field_singularity;
}

/// Whether the corners of such a triangle have lifted phases.
inline bool is_lifted(TriangleKind kind) {
  return kind == TriangleKind::regular || kind == TriangleKind::branch;
}

/// What `corner_phases` finds for one triangle.
struct CornerPhases {
  std::array<float, 3> phase{};       ///< lifted phases of the oriented corners, in radians
  std::array<std::int8_t, 3> sign{};  ///< s_m: -1 where the corner's wave was turned round
  std::int8_t branch_index = 0;       ///< closing error over 2 pi, at most 127 either way
  TriangleKind kind = TriangleKind::no_wave;
};

/// What the phase gains from corner j to corner i, in radians, both running alike: the phase shift
/// Phi_ji plus what it leaves of the difference of the phases, wrapped to between -pi and pi.
float lifted_step(const CornerWave& j, const CornerWave& i, PhaseShiftKind kind);

/// Orients the corners alike (a flipped corner has pi - Phi), then goes round: each step is the
/// phase shift plus the wrapped remainder. The closing error over 2 pi is the branch index.
/// A corner without direction has no wave, and neither has a triangle whose phases are no numbers.
CornerPhases corner_phases(const std::array<CornerWave, 3>& corners, PhaseShiftKind kind);

/// The same for all triangles of a mesh, with the wave of every vertex.
std::vector<CornerPhases> corner_phases(std::span<const Triangle> triangles, const WaveSet& waves,
                                        std::span<const Complex> z, PhaseShiftKind kind,
                                        const Progress& progress = {});

/// The same into `corners`, which has one entry per triangle, as frames need it: allocates nothing.
/// Throws Error for another number of entries.
void fill_corner_phases(std::span<const Triangle> triangles, const WaveSet& waves,
                        std::span<const Complex> z, PhaseShiftKind kind,
                        std::span<CornerPhases> corners, const Progress& progress = {});

/// The same for triangles whose corners have waves of their own, as TextureWaves has them.
std::vector<CornerPhases> corner_phases(std::span<const std::array<CornerWave, 3>> triangles,
                                        PhaseShiftKind kind, const Progress& progress = {});

}  // namespace brindle
