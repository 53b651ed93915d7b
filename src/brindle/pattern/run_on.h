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
class RunOn {
 public:
  /// `waves` must outlive it.
  explicit RunOn(const LiftedWaves& waves);

  /// From the inner end of `piece`, one of the joined `pieces` of triangle `t`, half forward and
  /// half sideways over the surface to the nearer of the curves beside it: points on the edges
  /// passed, the last one on that curve. No points if the end is on another piece; nothing if there
  /// is no curve within two periods.
  std::optional<std::vector<TrianglePoint>> way(std::size_t t, const StripePiece& piece,
                                                std::span<const StripePiece> pieces) const;

 private:
  struct Walker;
  struct Step;

  Step next_step(const Walker& walker) const;
  bool cross_edge(Walker& walker, int edge) const;
  bool walk(Walker& walker) const;

  const LiftedWaves& waves_;
  std::vector<std::array<Index, 2>> triangles_;  // of every edge of the mesh, the first two
};

}  // namespace brindle
