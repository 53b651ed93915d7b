#include "piece_lines.h"

#include <brindle/distributed_pattern.h>

namespace brindle::paraview {

Polylines piece_lines(const RankPiece& piece, const StripePattern& pattern,
                      const CurveOptions& options) {
  return piece_curves(piece.part_of(pattern), options).lines;
}

}  // namespace brindle::paraview
