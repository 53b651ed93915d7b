/// The centre lines of stripes within one triangle, exact along its edges.
///
/// A stripe's centre is where sin Phi = 1: at the peaks, which a wave and the same wave turned
/// round (pi - Phi) have in common. Which peaks an edge crosses, and where, follows from the two
/// waves at its ends alone, in whole numbers. So all triangles of an edge agree on it bit for bit,
/// at any frequency, and pieces of neighbouring triangles meet.
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

/// One of a wave and its reverse, the same one for either, so that rounding does not tell them
/// apart.
CornerWave canonical(const CornerWave& corner);

/// What the wave has turned since its last peak, above 0 and below a whole turn: no vertex is ever
/// exactly on a peak, one that is counts as just beyond it.
Turns turns_after_peak(Complex z);

/// The wave along an edge, from its first vertex to its second, in the first one's sense.
struct EdgeLift {
  std::int32_t peaks = 0;   ///< crossed on the way, negative where the phase falls
  bool reflecting = false;  ///< the second wave runs against the first
};

/// The phase shift plus the wrapped remainder, as in `corner_phases`. Both corners have a wave.
/// Beyond 2^24 peaks an edge has just so many: phases have no digits left there.
EdgeLift lift_edge(const CornerWave& first, Turns first_turns, const CornerWave& second,
                   Turns second_turns, PhaseShiftKind kind);

/// A triangle's three waves, lifted along its edges. Edge m joins corners m and m + 1.
struct LiftedTriangle {
  TriangleKind kind = TriangleKind::no_wave;
  std::array<Turns, 3> turns{};   ///< of the corners' own waves, as `turns_after_peak` gives them
  std::array<EdgeLift, 3> edges;  ///< each from that end whose vertex has the lower number
  std::array<bool, 3> forward{};  ///< whether that end is corner m
  /// Of a singularity of the field: at the barycentre, in the sense of corner m. Where that is a
  /// peak the cut stops just before it, or is just beyond where curves from both of its sides meet.
  std::array<Turns, 3> inner{};
  std::int32_t branch_index = 0;  ///< peaks left over on the way round
};

/// From what is known of the corners and edges.
LiftedTriangle lifted_triangle(const Triangle& triangle, const std::array<Turns, 3>& turns,
                               const std::array<EdgeLift, 3>& edges);

/// From the corners' waves alone, whichever waves they are: each vertex may lend another one to
/// each triangle (cross fields). Two triangles agree along an edge if their waves there are the
/// same up to a flip.
LiftedTriangle lifted_triangle(const Triangle& triangle, const std::array<CornerWave, 3>& corners,
                               PhaseShiftKind kind = PhaseShiftKind::aligned);

/// One end of a piece. Sides 0 to 2 are the triangle's edges; where the triangle is a singularity
/// of the field, sides 3 to 5 are the cuts from its corners to the barycentre.
struct PieceEnd {
  static constexpr std::uint8_t kInside = 6;  ///< on no side: a curve ends here

  std::uint8_t side = kInside;
  Index crossing = 0;  ///< its number along the side, from the end that `EdgeLift` starts at
  std::array<double, 3> barycentric{};
};

/// A straight piece of a centre line. Only the second end may be inside.
struct StripePiece {
  std::array<PieceEnd, 2> ends;
  std::uint8_t part = 0;  ///< of a singularity of the field: the edge whose part this is in
};

/// How many peaks the cut from a corner of a singular triangle crosses.
inline Index cut_crossings(const LiftedTriangle& triangle, int corner) {
  return static_cast<Index>(std::abs(triangle.inner[corner] >> 24));
}

/// Where crossing `number` of an edge or cut is: the share of the way from the end it starts at.
/// `from` and `to` are the lifted turns at its ends.
double crossing_position(Turns from, Turns to, Index number);

/// The lifted turns at an edge's second vertex, from that vertex's own.
inline Turns lifted_end(const EdgeLift& lift, Turns second_turns) {
  return lift.peaks * kWholeTurn + (lift.reflecting ? kWholeTurn - second_turns : second_turns);
}

/// Replaces `pieces` by those of one triangle. Every crossing of an edge is the end of exactly one.
/// Pieces do not cross each other; in a branch, |branch_index| of them end inside. A singularity of
/// the field is split at its barycentre. If that is on a peak, as `fragment_phase` has it, one
/// piece ends there. With `join`, pieces that would end side by side are joined in pairs, and one
/// that is left over runs on into its neighbour, if it has one in the triangle (`EndWalks` for one
/// beyond it).
void stripe_pieces(const LiftedTriangle& triangle, bool join, std::vector<StripePiece>& pieces);

}  // namespace brindle
