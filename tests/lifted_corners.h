/// Triangles lifted from the waves of their corners alone.
#pragma once

#include <array>
#include <utility>

#include "brindle/pattern/stripe_pieces.h"

namespace brindle::testing_support {

inline LiftedTriangle lifted_triangle(const Triangle& triangle,
                                      const std::array<CornerWave, 3>& corners) {
  std::array<CornerWave, 3> own;
  std::array<Turns, 3> turns{};
  std::array<EdgeLift, 3> edges;
  for (int m = 0; m < 3; ++m) {
    if (corners[m].wave.direction.isZero(0)) return {};
    own[m] = canonical(corners[m]);
    turns[m] = turns_after_peak(own[m].z);
  }
  for (int m = 0; m < 3; ++m) {
    const int next = (m + 1) % 3;
    const auto [a, b] = triangle[m] < triangle[next] ? std::pair(m, next) : std::pair(next, m);
    edges[m] = lift_edge(own[a], turns[a], own[b], turns[b], PhaseShiftKind::aligned);
  }
  return brindle::lifted_triangle(triangle, turns, edges);
}

}  // namespace brindle::testing_support
