#include "gather.h"

#include <bit>
#include <cstddef>

#ifdef BRINDLE_HAS_HIGHWAY
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gather.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace brindle::bench::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// `count` is a multiple of 64.
std::uint64_t gather_all(const Index* index, std::size_t count, const std::uint64_t* z) {
  const hn::ScalableTag<std::uint64_t> wide;
  const hn::RebindToSigned<decltype(wide)> offset;
  const hn::Rebind<Index, decltype(wide)> narrow;
  const std::size_t lanes = hn::Lanes(wide);
  const auto gathered = [&](std::size_t i) HWY_ATTR {
    const auto slots = hn::PromoteTo(wide, hn::LoadU(narrow, index + i));
    return hn::GatherIndex(wide, z, hn::BitCast(offset, slots));
  };
  auto a = hn::Zero(wide), b = a, c = a, d = a;
  for (std::size_t i = 0; i < count; i += 4 * lanes) {
    a = hn::Add(a, gathered(i));
    b = hn::Add(b, gathered(i + lanes));
    c = hn::Add(c, gathered(i + 2 * lanes));
    d = hn::Add(d, gathered(i + 3 * lanes));
  }
  return hn::GetLane(hn::SumOfLanes(wide, hn::Add(hn::Add(a, b), hn::Add(c, d))));
}

}  // namespace brindle::bench::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if !defined(BRINDLE_HAS_HIGHWAY) || HWY_ONCE
namespace brindle::bench {
namespace {

constexpr std::size_t kBlock = 64;

std::uint64_t bits_of(Complex value) {
  return (std::uint64_t{std::bit_cast<std::uint32_t>(value.imag())} << 32) |
         std::bit_cast<std::uint32_t>(value.real());
}

std::uint64_t gather_rest(std::span<const Index> index, std::span<const Complex> z) {
  std::uint64_t sum = 0;
  for (const Index j : index) sum += bits_of(z[j]);
  return sum;
}

}  // namespace

std::uint64_t gather_portable(std::span<const Index> index, std::span<const Complex> z) {
  std::uint64_t sums[4] = {};
  const std::size_t whole = index.size() / kBlock * kBlock;
  for (std::size_t i = 0; i < whole; i += 4) {
    for (std::size_t k = 0; k < 4; ++k) sums[k] += bits_of(z[index[i + k]]);
  }
  return sums[0] + sums[1] + sums[2] + sums[3] + gather_rest(index.subspan(whole), z);
}

#ifdef BRINDLE_HAS_HIGHWAY
HWY_EXPORT(gather_all);

std::uint64_t gather_simd(std::span<const Index> index, std::span<const Complex> z) {
  const std::size_t whole = index.size() / kBlock * kBlock;
  return HWY_DYNAMIC_DISPATCH(gather_all)(index.data(), whole,
                                          reinterpret_cast<const std::uint64_t*>(z.data())) +
         gather_rest(index.subspan(whole), z);
}
#endif

}  // namespace brindle::bench
#endif
