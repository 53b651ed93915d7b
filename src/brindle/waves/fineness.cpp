#include "brindle/waves/fineness.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/wave_metrics.h"

namespace brindle {
namespace {

/// Magnitudes of floats are ordered like their bits, whose maximum compilers vectorise.
struct LargestMagnitude {
  std::uint32_t bits = 0;
  LargestMagnitude operator+(const LargestMagnitude& other) const {
    return {std::max(bits, other.bits)};
  }
};

double largest_magnitude(std::span<const float> numbers) {
  const auto body = [&](std::size_t begin, std::size_t end) {
    std::uint32_t most = 0;
    for (std::size_t i = begin; i < end; ++i) {
      most = std::max(most, bit_cast<std::uint32_t>(numbers[i]) & 0x7fffffffu);
    }
    return LargestMagnitude{most};
  };
  const std::uint32_t bits = parallel_sum<LargestMagnitude>(numbers.size(), body).bits;
  return static_cast<double>(bit_cast<float>(bits));
}

}  // namespace

/// No edge is longer than the diagonal of a box about the origin that contains all positions.
bool may_be_too_fine(std::span<const Vec3> positions, std::span<const float> frequencies) {
  if (positions.empty()) return false;
  const double reach = largest_magnitude({positions.front().data(), 3 * positions.size()});
  const double longest = 2 * std::sqrt(3.0) * reach;
  return largest_magnitude(frequencies) * longest * kFewestEdgesAtHalf >= 1;
}

double mean_length_along(std::span<const Vec3> positions, Index vertex,
                         std::span<const Index> neighbors, const Vec3& direction) {
  double sum = 0;
  for (const Index neighbor : neighbors) {
    const Vec3 edge = positions[neighbor] - positions[vertex];
    sum += std::abs(static_cast<double>(edge.dot(direction)));
  }
  return sum / static_cast<double>(neighbors.size());
}

FinenessTally FinenessTally::operator+(const FinenessTally& other) const {
  FinenessTally sum = other.fewest < fewest ? other : *this;
  sum.measured = measured + other.measured;
  sum.too_fine = too_fine + other.too_fine;
  return sum;
}

FinenessTally tally_fineness(const Adjacency& neighborhood, std::span<const Vec3> positions,
                             std::span<const Vec3> directions, std::span<const float> frequencies) {
  const auto body = [&](std::size_t begin, std::size_t end) {
    FinenessTally sum;
    for (auto v = static_cast<Index>(begin); v < end; ++v) {
      const std::span<const Index> neighbors = neighborhood.of(v);
      if (neighbors.empty() || directions[v].isZero(0)) continue;
      const double length = mean_length_along(positions, v, neighbors, directions[v]);
      if (!(length > 0)) continue;
      const double edges = 1 / (static_cast<double>(frequencies[v]) * length);
      const std::size_t too_fine = edges <= kFewestEdgesAtHalf ? 1 : 0;
      sum = sum + FinenessTally{1, too_fine, edges, v, frequencies[v]};
    }
    return sum;
  };
  return parallel_sum<FinenessTally>(directions.size(), body);
}

void check_fineness(const FinenessTally& tally) {
  // These are the waves whose `edges_per_period_median` is kFewestEdgesAtHalf or less.
  const bool half = tally.too_fine > tally.measured / 2;
  if (!half && tally.fewest > kFewestEdgesAnywhere) return;
  const std::string where = " at vertex " + std::to_string(tally.vertex) +
                            formatted(", whose frequency is %g", tally.frequency);
  refuse_noise(tally.fewest, where, WarningWords().fewer);
}

void check_fineness(const Adjacency& neighborhood, std::span<const Vec3> positions,
                    std::span<const Vec3> directions, std::span<const float> frequencies) {
  if (!may_be_too_fine(positions, frequencies)) return;
  check_fineness(tally_fineness(neighborhood, positions, directions, frequencies));
}

void refuse_noise(double edges_per_period, const std::string& where, const std::string& fewer) {
  throw Error(formatted("a wave passes %.2g edges a period", edges_per_period) + where +
              ": nothing can be told of such stripes; " + fewer);
}

}  // namespace brindle
