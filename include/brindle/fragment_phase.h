/// The phase at any point of a triangle, from the waves at its corners (paper, 3.5).
#pragma once

#include <array>
#include <optional>

#include "brindle/corner_phases.h"
#include "brindle/export.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// The wave at a fragment. `z` has length 1, or 0 exactly where the phase is undefined.
struct FragmentWave {
  Vec3 direction = Vec3::Zero();
  float frequency = 0;
  Complex z = 0;
};

/// Signs s_m that make the three directions run alike: all pairwise products are then positive.
/// The first is always +1. Empty if there are none: the triangle is a singularity of the field.
std::optional<std::array<float, 3>> common_orientation(const std::array<Vec3, 3>& directions);

/// Eq. 13 and 14 with the closed form of the phase shift, for corners that run alike. Barycentric
/// weights are not negative and sum to 1. If a corner has no wave, the result has z = 0.
FragmentWave oriented_fragment_phase(const std::array<CornerWave, 3>& corners,
                                     const Vec3& barycentric);

/// The fragment's wave in a triangle that is split at its barycentre: from the two corners of the
/// edge that its part keeps, with the sign of the first of them.
FragmentWave split_fragment_phase(const std::array<CornerWave, 3>& corners,
                                  const Vec3& barycentric);

/// The fragment's wave in any triangle. Corners that cannot be oriented alike are handled by
/// splitting the triangle at its barycentre (Knöppel et al. 2015), so that no edge shows a seam.
/// The result is defined up to a flip: sin Phi is what two triangles share along an edge.
FragmentWave fragment_phase(const std::array<CornerWave, 3>& corners, const Vec3& barycentric);

}  // namespace brindle
