/// `bit_cast`, also where the library has none (libc++ before 14).
#pragma once

#include <bit>
#include <version>

namespace brindle {

#if defined(__cpp_lib_bit_cast)
using std::bit_cast;
#else
/// The value of another type that has the same bits.
template <class To, class From>
constexpr To bit_cast(const From& from) {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}
#endif

}  // namespace brindle
