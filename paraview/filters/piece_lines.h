/// Centre lines of stripes in one rank's partition.
#pragma once

#include <brindle/curves.h>
#include <brindle/polylines.h>
#include <brindle/stripe_pattern.h>

#include "rank_piece.h"

namespace brindle::paraview {

/// Collective. Lines in this rank's own triangles, cut at the borders: where one goes on, exactly
/// one on another rank ends in a point of the same bits. As in lines of one process, no point but
/// an end is at the place of another, there are no lines of one point, and waves run to the left
/// where the field and the piece can be oriented.
Polylines piece_lines(const RankPiece& piece, const StripePattern& pattern,
                      const CurveOptions& options);

}  // namespace brindle::paraview
