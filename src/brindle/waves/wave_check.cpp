#include "brindle/waves/wave_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/base/text.h"
#include "brindle/error.h"
#include "brindle/wave_metrics.h"

namespace brindle {
namespace {

constexpr float kLargest = std::numeric_limits<float>::max();
constexpr float kSquareTolerance = 0.01f;
constexpr float kTurnable = 0.07f;    // sine of 4 degrees
constexpr float kSlanted = 0.1737f;   // of 10, and a little for rounding
constexpr float kSteep = 0.866f;      // of 60
constexpr double kMostSlanted = 0.1;  // share

bool is_unit_or_zero(const Vec3& d) {
  return std::abs(d.squaredNorm() - 1) <= kSquareTolerance || d.isZero(0);
}

bool is_wave(const Vec3& position, const Vec3& direction, float frequency) {
  return position.allFinite() && is_unit_or_zero(direction) && frequency > 0 &&
         frequency <= kLargest;
}

/// A minimum, as a sum for `parallel_sum`.
struct First {
  std::size_t number = std::numeric_limits<std::size_t>::max();
  First operator+(const First& other) const { return {std::min(number, other.number)}; }
};

/// The first of `count` items for which `holds` is false, or `count`. `all_hold(begin, end)` is a
/// fast test of a range, which may be false although all items hold.
template <class AllHold, class Holds>
std::size_t first_without(std::size_t count, const AllHold& all_hold, const Holds& holds) {
  const First first = parallel_sum<First>(count, [&](std::size_t begin, std::size_t end) {
    if (all_hold(begin, end)) return First{};
    for (std::size_t i = begin; i < end; ++i) {
      if (!holds(i)) return First{i};
    }
    return First{};
  });
  return std::min(first.number, count);
}

// Loops without an early exit, which compilers vectorise.

bool all_finite(std::span<const Vec3> vectors) {
  const float* const components = vectors.front().data();
  unsigned bad = 0;
  for (std::size_t c = 0; c < 3 * vectors.size(); ++c)
    bad |= !(std::abs(components[c]) <= kLargest);
  return bad == 0;
}

bool all_unit(std::span<const Vec3> directions) {
  const float* const d = directions.front().data();
  unsigned bad = 0;
  for (std::size_t c = 0; c < 3 * directions.size(); c += 3) {
    const float square = d[c] * d[c] + d[c + 1] * d[c + 1] + d[c + 2] * d[c + 2];
    bad |= !(std::abs(square - 1) <= kSquareTolerance);
  }
  return bad == 0;
}

bool all_unit_or_zero(std::span<const Vec3> directions) {
  return all_unit(directions) || std::all_of(directions.begin(), directions.end(), is_unit_or_zero);
}

bool all_positive(std::span<const float> frequencies) {
  unsigned bad = 0;
  for (const float f : frequencies) bad |= !(f > 0) | !(f <= kLargest);
  return bad == 0;
}

std::string text_of(const Vec3& v) { return formatted("(%g, %g, %g)", v.x(), v.y(), v.z()); }

std::string degrees_text(float sine) {
  return formatted("%.3g degrees",
                   std::asin(std::min(sine, 1.0f)) * 180 / std::numbers::pi_v<float>);
}

[[noreturn]] void refuse(std::size_t vertex, const Vec3& position, const Vec3& direction,
                         float frequency) {
  const std::string which = "waves: vertex " + std::to_string(vertex);
  if (!position.allFinite()) {
    throw Error(which + " is at " + text_of(position) + "; give it a finite position");
  }
  if (!is_unit_or_zero(direction)) {
    throw Error(which + " has the direction " + text_of(direction) +
                "; give it a unit vector, as tangent_directions makes them, or zero for no wave");
  }
  throw Error(which + formatted(" has the frequency %g", frequency) +
              "; give every vertex a finite one above zero, also where there is no wave");
}

}  // namespace

void check_waves(std::span<const Vec3> positions, std::span<const Vec3> directions,
                 std::span<const float> frequencies) {
  const auto all_waves = [&](std::size_t begin, std::size_t end) {
    const std::size_t count = end - begin;
    return all_finite(positions.subspan(begin, count)) &&
           all_unit_or_zero(directions.subspan(begin, count)) &&
           all_positive(frequencies.subspan(begin, count));
  };
  const std::size_t bad = first_without(positions.size(), all_waves, [&](std::size_t i) {
    return is_wave(positions[i], directions[i], frequencies[i]);
  });
  if (bad < positions.size()) refuse(bad, positions[bad], directions[bad], frequencies[bad]);
}

TangentStats tally_tangent(std::span<const Vec3> normals, std::span<const Vec3> directions) {
  struct Sum {
    TangentStats tally;
    Sum operator+(const Sum& other) const {
      const TangentStats& a = tally;
      const TangentStats& b = other.tally;
      const TangentStats& worse = b.largest_sine > a.largest_sine ? b : a;
      return {{a.counted + b.counted, a.slanted + b.slanted, worse.largest_sine, worse.vertex}};
    }
  };
  const auto body = [&](std::size_t begin, std::size_t end) {
    TangentStats tally;
    for (std::size_t i = begin; i < end; ++i) {
      if (directions[i].isZero(0) || normals[i].isZero(0)) continue;
      const float sine = std::abs(normals[i].dot(directions[i]));
      ++tally.counted;
      tally.slanted += sine > kSlanted;
      if (sine > tally.largest_sine) {
        tally.largest_sine = sine;
        tally.vertex = i;
      }
    }
    return Sum{tally};
  };
  return parallel_sum<Sum>(directions.size(), body).tally;
}

void check_tangent(const TangentStats& tally) {
  const double most_slanted = kMostSlanted * static_cast<double>(tally.counted);
  const bool few = static_cast<double>(tally.slanted) <= most_slanted;
  if (few && tally.largest_sine <= kSteep) return;
  std::string text = "waves: the direction of vertex " + std::to_string(tally.vertex) +
                     " sticks out of the surface by " + degrees_text(tally.largest_sine);
  if (!few) {
    text += ", and " + std::to_string(tally.slanted) + " of " + std::to_string(tally.counted) +
            " by more than 10";
  }
  throw Error(text + "; project directions into the tangent planes with tangent_directions");
}

void check_tangent(std::span<const Vec3> normals, std::span<const Vec3> directions) {
  check_tangent(tally_tangent(normals, directions));
}

void check_turnable(std::span<const Vec3> normals, std::span<const Vec3> directions) {
  const TangentStats tally = tally_tangent(normals, directions);
  if (tally.largest_sine <= kTurnable) return;
  throw Error("waves: the direction of vertex " + std::to_string(tally.vertex) +
              " sticks out of the surface by " + degrees_text(tally.largest_sine) +
              ", and is not tangent to it; project it with tangent_directions");
}

void check_last_phases(std::span<const Complex> z, std::size_t count) {
  if (z.size() != count) {
    throw Error("last phases: there are " + std::to_string(z.size()) + " for " +
                std::to_string(count) + " vertices; give one to each, 0 where none is known");
  }
  const std::size_t bad = first_without(
      count, [](std::size_t, std::size_t) { return false; },
      [&](std::size_t i) {
        return z[i] == Complex(0) || std::abs(std::norm(z[i]) - 1) <= kSquareTolerance;
      });
  if (bad == count) return;
  throw Error("last phases: that of vertex " + std::to_string(bad) +
              formatted(" is (%g,%g)", z[bad].real(), z[bad].imag()) +
              "; give exp(i Phi), of length 1, or 0 where none is known");
}

void check_edge_weights(std::span<const float> weights) {
  const std::size_t bad = first_without(
      weights.size(), [](std::size_t, std::size_t) { return false; },
      [&](std::size_t edge) { return weights[edge] >= 0 && weights[edge] <= kLargest; });
  if (bad == weights.size()) return;
  throw Error("edge weights: that of directed edge " + std::to_string(bad) +
              formatted(" is %g", weights[bad]) + "; give finite weights of 0 or above");
}

void check_coupled_waves(const Adjacency& adjacency, const WaveSet& waves,
                         std::span<const float> edge_weights) {
  const std::size_t nodes = adjacency.node_count();
  const std::size_t edges = adjacency.directed_edge_count();
  if (waves.positions.size() != nodes || waves.directions.size() != nodes ||
      waves.frequencies.size() != nodes ||
      (!edge_weights.empty() && edge_weights.size() != edges)) {
    throw Error("waves: positions, directions and frequencies must have one entry for each of " +
                std::to_string(nodes) + " nodes, weights one for each of " + std::to_string(edges) +
                " directed edges");
  }
  check_waves(waves.positions, waves.directions, waves.frequencies);
  check_edge_weights(edge_weights);
}

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

void archive_waves(Archive& archive, std::size_t nodes, WaveSet& waves) {
  archive.list_of(nodes, waves.positions);
  archive.list_of(nodes, waves.directions);
  archive.list_of(nodes, waves.frequencies);
  check_waves(waves.positions, waves.directions, waves.frequencies);
}

void archive_change(Archive& archive, FrequencyChange& change) {
  archive(change.ratio_min, change.ratio_max, change.ratio_mean, change.share_at_bounds,
          change.sweeps, change.residual);
}

}  // namespace brindle
