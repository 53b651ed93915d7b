/// Smoothing scales in periods of the stripes: range checks, distances along edges in periods, and
/// pairs of opposite singularities.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "brindle/base/graph.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace brindle {

/// Throws Error, "<of>: ...", for a smoothing scale or fill distance out of range, in periods.
inline void check_scale(const std::string& of, float periods, float fill) {
  if (!(periods > 0 && periods <= 100)) {
    throw Error(of + ": the detail must be a number of periods above 0, and 100 at most");
  }
  if (!(std::isfinite(fill) && fill >= 0)) {
    throw Error(of + ": holes are filled for a finite number of periods, 0 or above");
  }
}

/// Repeated shortest-path searches along edges (Dijkstra 1959) on one surface.
class PeriodWalk {
 public:
  /// `frequencies` are stripes per unit length, one per vertex. Both must outlive the walk.
  PeriodWalk(const Surface& surface, std::span<const float> frequencies)
      : surface_(surface), frequencies_(frequencies), ways_(frequencies.size()) {}

  /// Visits the vertices within `reach` periods of the nearest source, in order of distance, until
  /// `visit(vertex, distance)` returns false.
  template <class Visit>
  void from(std::span<const Index> sources, float reach, const Visit& visit) {
    for (const Index source : sources) ways_.offer(source, 0);
    while (const auto next = ways_.next()) {
      const auto [far, i] = *next;
      if (!visit(i, far)) break;
      for (const Index j : surface_.neighborhood->of(i)) {
        const float length = (surface_.mesh.positions[j] - surface_.mesh.positions[i]).norm();
        const float farther = far + 0.5f * (frequencies_[i] + frequencies_[j]) * length;
        if (farther <= reach) ways_.offer(j, farther);
      }
    }
    ways_.clear();
  }

 private:
  const Surface& surface_;
  std::span<const float> frequencies_;
  ShortestWays<float> ways_;
};

/// Distance of every vertex from the nearest datum, in periods; infinite beyond `reach`. A vertex
/// may be neither datum nor hole.
template <class IsDatum, class IsHole>
std::vector<float> periods_from_data(const Surface& surface, std::span<const float> frequencies,
                                     const IsDatum& is_datum, const IsHole& is_hole, float reach) {
  std::vector<float> distance(frequencies.size(), std::numeric_limits<float>::infinity());
  std::vector<Index> borders;
  for (Index i = 0; i < frequencies.size(); ++i) {
    if (!is_datum(i)) continue;
    distance[i] = 0;
    if (ranges::any_of(surface.neighborhood->of(i), is_hole)) borders.push_back(i);
  }
  PeriodWalk(surface, frequencies).from(borders, reach, [&](Index i, float far) {
    distance[i] = std::min(distance[i], far);
    return true;
  });
  return distance;
}

/// Singular triangles of opposite index.
struct OppositeSingularities {
  Index positive;
  Index negative;
  float distance;  ///< along edges, in periods
};

struct FoundSingularities {
  std::size_t count = 0;
  std::vector<OppositeSingularities> pairs;  ///< nearest first; each triangle in at most one pair
};

/// The number of singularities of a field of symmetry N, and the opposite pairs within `reach`
/// periods. One direction and frequency (stripes per unit length) per vertex.
FoundSingularities opposite_singularities(const Surface& surface, std::span<const Vec3> directions,
                                          int symmetry, std::span<const float> frequencies,
                                          float reach);

}  // namespace brindle
