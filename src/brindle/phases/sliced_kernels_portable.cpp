#include <cmath>

#include "brindle/phases/sliced_kernels.h"
#include "brindle/phases/sliced_waves.h"

namespace brindle::portable {
namespace {

using Real = float;
using Truth = bool;
using Bits = std::uint32_t;
constexpr Index kReals = 1;

inline Real real(float value) { return value; }
inline Real zero() { return 0; }
inline Real load(const float* from) { return *from; }
inline Real load_unaligned(const float* from) { return *from; }
inline void store(Real value, float* to) { *to = value; }
inline void store_unaligned(Real value, float* to) { *to = value; }
inline Real negative(Real a) { return -a; }
inline Real absolute(Real a) { return std::abs(a); }
inline Real square_root(Real a) { return std::sqrt(a); }
inline Real nearest(Real a) { return std::nearbyint(a); }

inline Truth less(Real a, Real b) { return a < b; }
inline Real chosen(Truth truth, Real yes, Real no) { return truth ? yes : no; }
inline Real zero_where(Truth truth, Real a) { return truth ? 0 : a; }
inline Real zero_unless(Truth truth, Real a) { return truth ? a : 0; }
inline Truth both(Truth a, Truth b) { return a && b; }
inline Truth any(Truth a) { return a; }
template <class Body>
void for_each(Truth truth, const Body& body) {
  if (truth) body(Index{0});
}

inline Bits bits(std::uint32_t value) { return value; }
inline Bits ascending_bits(Index first) { return first; }
inline Bits load_bits(const Index* from) { return *from; }
inline void store_bits(Bits a, Index* to) { *to = a; }
inline Bits times_four(Bits a) { return 4 * a; }
inline Bits bits_of(Real a) { return bit_cast<Bits>(a); }
inline Real real_of(Bits a) { return bit_cast<Real>(a); }
inline Truth equal(Bits a, Bits b) { return a == b; }
inline Bits without(Bits a, Bits mask) { return a & ~mask; }
inline Bits to_sign(Bits a) { return a << 31; }
inline Bits sign_if_odd(Real whole) { return to_sign(static_cast<Bits>(static_cast<int>(whole))); }

struct Numbers {
  Real re;
  Real im;
};
inline Numbers load_complex(const Complex* from) { return {from->real(), from->imag()}; }
inline void store_complex(const Numbers& z, Complex* to) { *to = {z.re, z.im}; }
inline Numbers gathered(const Complex* from, const Index* index) {
  return load_complex(from + *index);
}
inline Numbers gathered_couplings(const float* direct, const Index* entry) {
  const float* const a = direct + SlicedCouplings::real_part(*entry == kNone ? 0 : *entry);
  return {a[0], a[kLanes]};
}

}  // namespace

#define BRINDLE_KERNEL inline
#include "brindle/phases/sliced_kernels_body.h"

}  // namespace brindle::portable
