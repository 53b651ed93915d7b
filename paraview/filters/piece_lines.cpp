#include "piece_lines.h"

#include <brindle/distributed_pattern.h>

namespace brindle::paraview {

Polylines piece_lines(const RankPiece& piece, const StripePattern& pattern) {
  return piece_curves(piece.part_of(pattern)).lines;
}

}  // namespace brindle::paraview
