/// Paths over the surface from the end of a curve to the curve beside it.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "brindle/pattern/lifted_waves.h"
#include "brindle/polylines.h"

namespace brindle {

/// Extends curves that end alone in a branch or singularity.
class EndWalks {
 public:
  /// `waves` must outlive it.
  explicit EndWalks(const LiftedWaves& waves);

  /// The path from the inner end of `piece`, one of the joined `pieces` of triangle `t`, to the
  /// curve beside it: points on the crossed edges, and finally on the curve. Empty if the end
  /// already lies on another piece. The path is the shorter of two straight ones, at 45 degrees
  /// forward to either side; nullopt if neither meets a curve within two periods.
  std::optional<std::vector<TrianglePoint>> way_on(std::size_t t, const StripePiece& piece,
                                                   std::span<const StripePiece> pieces) const;

 private:
  struct Walker;
  struct Step;

  Step next_step(const Walker& walker) const;
  bool cross_edge(Walker& walker, int edge) const;
  void walk(Walker& walker) const;

  const LiftedWaves& waves_;
};

}  // namespace brindle
