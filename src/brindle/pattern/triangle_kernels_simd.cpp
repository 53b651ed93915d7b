#include "brindle/base/elementary.h"
#include "brindle/pattern/triangle_kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "brindle/pattern/triangle_kernels_simd.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace brindle::simd::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, kTriangleLanes>;

struct Real {
  hn::Vec<D> v;
};
struct Truth {
  hn::Mask<D> m;
};
constexpr std::size_t kReals = hn::MaxLanes(D());

HWY_INLINE Real operator+(Real a, Real b) { return {hn::Add(a.v, b.v)}; }
HWY_INLINE Real operator-(Real a, Real b) { return {hn::Sub(a.v, b.v)}; }
HWY_INLINE Real operator*(Real a, Real b) { return {hn::Mul(a.v, b.v)}; }
HWY_INLINE Real operator/(Real a, Real b) { return {hn::Div(a.v, b.v)}; }
HWY_INLINE Truth operator<(Real a, Real b) { return {hn::Lt(a.v, b.v)}; }
HWY_INLINE Truth operator>(Real a, Real b) { return {hn::Gt(a.v, b.v)}; }
HWY_INLINE Truth operator==(Real a, Real b) { return {hn::Eq(a.v, b.v)}; }
HWY_INLINE Truth operator&&(Truth a, Truth b) { return {hn::And(a.m, b.m)}; }
HWY_INLINE Truth operator||(Truth a, Truth b) { return {hn::Or(a.m, b.m)}; }
HWY_INLINE Truth operator!=(Truth a, Truth b) { return {hn::Xor(a.m, b.m)}; }
HWY_INLINE Truth operator!(Truth a) { return {hn::Not(a.m)}; }

HWY_INLINE Real real(float value) { return {hn::Set(D(), value)}; }
HWY_INLINE Real load(const float* from) { return {hn::Load(D(), from)}; }
HWY_INLINE void load_pairs(const float* from, Real& first, Real& second) {
  hn::LoadInterleaved2(D(), from, first.v, second.v);
}
HWY_INLINE void store(Real value, float* to) { hn::Store(value.v, D(), to); }
HWY_INLINE Real chosen(Truth truth, Real yes, Real no) {
  return {hn::IfThenElse(truth.m, yes.v, no.v)};
}
HWY_INLINE Real absolute(Real a) { return {hn::Abs(a.v)}; }
HWY_INLINE Real square_root(Real a) { return {hn::Sqrt(a.v)}; }
HWY_INLINE Real truncated(Real a) { return {hn::Trunc(a.v)}; }
HWY_INLINE Real with_sign_of(Real size, Real sign) { return {hn::CopySign(size.v, sign.v)}; }
HWY_INLINE Truth is_negative(Real a) {
  const hn::RebindToSigned<D> whole;
  return {hn::RebindMask(D(), hn::Lt(hn::BitCast(whole, a.v), hn::Zero(whole)))};
}

}  // namespace

#undef BRINDLE_KERNEL
#define BRINDLE_KERNEL HWY_INLINE
#include "brindle/pattern/triangle_kernels_body.h"

}  // namespace brindle::simd::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brindle::simd {

HWY_EXPORT(phase_distances);
HWY_EXPORT(lift_corners);
HWY_EXPORT(measure_errors);
HWY_EXPORT(measure_distortions);

void phase_distances(const Complex* a, const Complex* b, float* distances) {
  HWY_DYNAMIC_DISPATCH(phase_distances)(a, b, distances);
}

void lift_corners(const CornerLanes& corners, PhaseShiftKind kind, const ShiftLanes* given,
                  LiftedLanes& lifted) {
  HWY_DYNAMIC_DISPATCH(lift_corners)(corners, kind, given, lifted);
}

void measure_errors(const CornerLanes& corners, const LiftedLanes& lifted, ErrorLanes& errors) {
  HWY_DYNAMIC_DISPATCH(measure_errors)(corners, lifted, errors);
}

void measure_distortions(const CornerLanes& corners, const LiftedLanes& u, const LiftedLanes& v,
                         const DensityLanes& density, DistortionLanes& distortions) {
  HWY_DYNAMIC_DISPATCH(measure_distortions)(corners, u, v, density, distortions);
}

}  // namespace brindle::simd
#endif  // HWY_ONCE
