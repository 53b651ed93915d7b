/// Ways over the surface from where a curve ends to the curve beside it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "brindle/pattern/lifted_waves.h"
#include "brindle/polylines.h"

namespace brindle {

/// Finds where curves that end alone in a branch or singularity run on to.
class EndWalks {
 public:
  /// `waves` must outlive it.
  explicit EndWalks(const LiftedWaves& waves);

  /// The way to the curve beside the inner end of `piece`, one of the joined `pieces` of triangle
  /// `t`: points on the edges passed, at last that on the curve; none if the end is on another
  /// piece already. It is the shorter one of two straight ways, half forward and half to either
  /// side. Nothing if neither meets a curve within two periods.
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
