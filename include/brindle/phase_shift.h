/// The phase shift from one wave to a neighbouring one (paper, 3.1).
#pragma once

#include <cmath>
#include <string_view>

#include "brindle/export.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// The distance between two points along their waves.
enum class PhaseShiftKind {
  aligned,        ///< closed form, exact for circular wave fronts (docs/method.md)
  common_source,  ///< the paper's Eq. 2 and 7, literally
  trapezoid       ///< mean of both directions (Knöppel et al. 2015)
};

std::string_view name_of(PhaseShiftKind kind);

/// A wave without its phase.
struct Wave {
  Vec3 position;
  Vec3 direction;   ///< of length 1, or zero for no wave
  float frequency;  ///< stripes per unit length
};

/// The phase shift Phi_ji from wave j to wave i.
struct PhaseShift {
  float radians;    ///< Phi_ji of Eq. 1
  bool reflecting;  ///< Phi_i = pi - (Phi_j + Phi_ji) instead of Phi_j + Phi_ji (Eq. 7)
};

/// The distance from j to i along both waves, <e, d_j + s d_i> / (1 + |<d_i, d_j>|) with e = v_i -
/// v_j and s = sign <d_i, d_j>: Eq. 2 in closed form. In the plane the wave lines meet in C = v_j +
/// a d_j = v_i + b s d_i, so that <e, d_j + s d_i> = (a - b)(1 + |<d_i, d_j>|), and a - b is the
/// difference of the distances to the common source. Smooth in all arguments; for parallel lines it
/// is the projection. Kernels and shaders repeat it for their own number types.
inline float aligned_distance(const Vec3& v_j, const Vec3& d_j, const Vec3& v_i, const Vec3& d_i) {
  const float cosine = d_i.dot(d_j);
  const float s = cosine < 0 ? -1.0f : 1.0f;
  return (v_i - v_j).dot(d_j + s * d_i) / (1 + std::abs(cosine));
}

/// Phi_ji of Eq. 1, f_ji = sqrt(f_i f_j), with the distance of `kind`.
PhaseShift phase_shift(PhaseShiftKind kind, const Wave& j, const Wave& i);

}  // namespace brindle
