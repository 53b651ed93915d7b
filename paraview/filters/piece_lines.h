/// Centre lines of stripes in one rank's partition.
#pragma once

#include <brindle/polylines.h>
#include <brindle/stripe_pattern.h>

#include "rank_piece.h"

namespace brindle::paraview {

/// Collective. Lines in this rank's own triangles, cut at the borders: where a line continues,
/// exactly one on another rank ends at the same bits. As for one process, only ends may coincide,
/// no line has a single point, and waves run to the left if field and partition can be oriented.
Polylines piece_lines(const RankPiece& piece, const StripePattern& pattern);

}  // namespace brindle::paraview
