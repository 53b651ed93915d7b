/// Sums from which energies follow.
#pragma once

namespace brindle {

/// Sums over directed edges.
struct EnergySums {
  double energy = 0, weight = 0;

  EnergySums operator+(const EnergySums& other) const {
    return {energy + other.energy, weight + other.weight};
  }

  /// The energy, as defined by `energy` of phase_graph.h.
  double relative() const {
    if (weight == 0) return 0;
    const double relative = energy / weight;
    // Rounding may make a perfect pattern negative. NaN stays NaN.
    return relative < 0 ? 0 : relative;
  }
};

}  // namespace brindle
