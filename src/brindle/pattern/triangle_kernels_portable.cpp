#include <cmath>

#include "brindle/base/elementary.h"
#include "brindle/pattern/triangle_kernels.h"

namespace brindle::portable {
namespace {

using Real = float;
using Truth = bool;
constexpr std::size_t kReals = 1;

inline Real real(float value) { return value; }
inline Real load(const float* from) { return *from; }
inline void load_pairs(const float* from, Real& first, Real& second) {
  first = from[0];
  second = from[1];
}
inline void store(Real value, float* to) { *to = value; }
inline Real chosen(Truth truth, Real yes, Real no) { return truth ? yes : no; }
inline Real absolute(Real a) { return std::abs(a); }
inline Real square_root(Real a) { return std::sqrt(a); }
inline Real truncated(Real a) { return std::trunc(a); }
inline Real with_sign_of(Real size, Real sign) { return std::copysign(size, sign); }
inline Truth is_negative(Real a) { return std::signbit(a); }

}  // namespace

#define BRINDLE_KERNEL inline
#include "brindle/pattern/triangle_kernels_body.h"

void lift_first(const CornerLanes& corners, PhaseShiftKind kind, const ShiftLanes* given,
                LiftedLanes& lifted) {
  lift_lane(corners, kind, given, 0, lifted);
}

float phase_angle(Complex z) { return angle_of(z.imag(), z.real()); }

float lifted_step(Complex z_j, Complex z_i, float shift) {
  return step_between(z_j.real(), z_j.imag(), z_i.real(), z_i.imag(), shift);
}

}  // namespace brindle::portable
