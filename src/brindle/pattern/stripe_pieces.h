/// The centre lines of stripes within one triangle, exact along its edges.
///
/// Stripe centres are the peaks, sin Phi = 1, which a wave shares with its reverse (pi - Phi). The
/// peaks on an edge, and their positions, follow from the two waves at its ends alone, in whole
/// numbers. So all triangles of an edge agree bit for bit at any frequency, and pieces of
/// neighbouring triangles meet.
#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "brindle/corner_phases.h"
#include "brindle/types.h"

namespace brindle {

/// A phase counted from a peak, Phi = pi/2 + 2 pi turns, in units of 2^-24 turns.
using Turns = std::int64_t;
inline constexpr Turns kWholeTurn = Turns{1} << 24;

/// The canonical one of a wave and its reverse, so that both round alike.
CornerWave canonical(const CornerWave& corner);

/// The phase since the last peak, above 0 and below a whole turn. No vertex is exactly on a peak:
/// one that would be counts as just beyond it.
Turns turns_after_peak(Complex z);

/// The wave along an edge, from its first vertex to its second, oriented like the first.
struct EdgeLift {
  std::int32_t peaks = 0;   ///< peaks crossed, negative if the phase falls
  bool reflecting = false;  ///< the second wave runs against the first
};

/// The phase shift plus the wrapped remainder, as in `corner_phases`. Both corners must have a
/// wave. Peaks are limited to 2^24, beyond which phases have no significant digits.
EdgeLift lift_edge(const CornerWave& first, Turns first_turns, const CornerWave& second,
                   Turns second_turns, PhaseShiftKind kind);

/// A triangle's three waves, lifted along its edges. Edge m joins corners m and m + 1.
struct LiftedTriangle {
  TriangleKind kind = TriangleKind::no_wave;
  std::array<Turns, 3> turns{};   ///< `turns_after_peak` of the corners' own waves
  std::array<EdgeLift, 3> edges;  ///< each from its vertex of the lower number
  std::array<bool, 3> forward{};  ///< whether that vertex is corner m
  /// In a field singularity: turns at the barycentre, oriented like corner m. If it is a peak, the
  /// cut stops just before it, or just beyond it where curves from both sides of the cut meet.
  std::array<Turns, 3> inner{};
  std::int32_t branch_index = 0;  ///< peaks left over going around
};

/// From the turns at the corners and the lifted edges.
LiftedTriangle lifted_triangle(const Triangle& triangle, const std::array<Turns, 3>& turns,
                               const std::array<EdgeLift, 3>& edges);

/// One end of a piece. Sides 0 to 2 are the triangle's edges; where the triangle is a singularity
/// of the field, sides 3 to 5 are the cuts from its corners to the barycentre.
struct PieceEnd {
  static constexpr std::uint8_t kInside = 6;  ///< on no side: a curve ends here

  std::uint8_t side = kInside;
  Index crossing = 0;  ///< number along the side, from the start of `EdgeLift`
  std::array<double, 3> barycentric{};
};

/// A straight piece of a centre line. Only the second end may be inside.
struct StripePiece {
  std::array<PieceEnd, 2> ends;
  std::uint8_t part = 0;  ///< in a field singularity: the edge of its part
};

/// The number of peaks on the cut from a corner of a singular triangle.
inline Index cut_crossings(const LiftedTriangle& triangle, int corner) {
  return static_cast<Index>(std::abs(triangle.inner[corner] >> 24));
}

/// The position of crossing `number` on an edge or cut, as a share of its length from its start.
/// `from` and `to` are the lifted turns at its ends.
double crossing_position(Turns from, Turns to, Index number);

/// The lifted turns at an edge's second vertex, from that vertex's own.
inline Turns lifted_end(const EdgeLift& lift, Turns second_turns) {
  return lift.peaks * kWholeTurn + (lift.reflecting ? kWholeTurn - second_turns : second_turns);
}

/// Replaces `pieces` by those of one triangle. Every crossing of an edge is the end of exactly one
/// piece. Pieces do not cross each other; in a branch, |branch_index| of them end inside. A field
/// singularity is split at its barycentre. If that is a peak, as in `fragment_phase`, one piece
/// ends there. With `join`, pieces that would end side by side are joined in pairs. A remaining one
/// is extended to its neighbour in the triangle, if there is one (`EndWalks` for one beyond it).
void stripe_pieces(const LiftedTriangle& triangle, bool join, std::vector<StripePiece>& pieces);

}  // namespace brindle
