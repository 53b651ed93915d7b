/// The phase at any point of a triangle, from the waves at its corners (paper, 3.5).
#pragma once

#include <array>
#include <optional>
#include <span>

#include "brindle/corner_phases.h"
#include "brindle/export.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// The wave at a fragment. `z` has length 1, or is 0 where the phase is undefined.
struct FragmentWave {
  Vec3 direction = Vec3::Zero();
  float frequency = 0;
  Complex z = 0;
};

/// Signs s_m that make the three directions run alike: all pairwise products are then positive. The
/// first is always +1. Empty if there are none: the triangle is a singularity of the field.
std::optional<std::array<float, 3>> common_orientation(const std::array<Vec3, 3>& directions);

/// The fragment's wave in any triangle, by Eq. 13 and 14 with the closed form of the phase shift.
/// Barycentric weights are not negative and sum to 1. If a corner has no wave, the result has z =
/// 0.
///
/// Where corners disagree by more than a third of a turn, the excess is first distributed evenly
/// along their edge. Around a branch the phase turns about a point where z = 0. In a singularity of
/// the field, whose corners cannot be oriented alike, the barycentre has a peak or a trough. Two
/// triangles agree along their common edge.
///
/// The result is defined up to reversal: two triangles share sin Phi along an edge. It depends
/// neither on the signs of the corners' waves nor on the order of the corners.
FragmentWave fragment_phase(const std::array<CornerWave, 3>& corners, const Vec3& barycentric);

/// As above, oriented like the first corner of the edge nearest to the fragment, in shares of the
/// triangle's heights. Where corners run alike, all of them give this orientation.
FragmentWave split_fragment_phase(const std::array<CornerWave, 3>& corners,
                                  const Vec3& barycentric);

/// Both functions at several points of a triangle, faster than one by one. The first of `waves`
/// become those at `barycentric`.
void fragment_phases(const std::array<CornerWave, 3>& corners, std::span<const Vec3> barycentric,
                     std::span<FragmentWave> waves);
void split_fragment_phases(const std::array<CornerWave, 3>& corners,
                           std::span<const Vec3> barycentric, std::span<FragmentWave> waves);

}  // namespace brindle
