/// What follows from waves and patterns that many processes hold: figures, curves and samples.
/// Needs a build with BRINDLE_MPI.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "brindle/curves.h"
#include "brindle/distributed_surface.h"
#include "brindle/export.h"
#include "brindle/phase_graph.h"
#include "brindle/progress.h"
#include "brindle/samples.h"
#include "brindle/wave_figures.h"

namespace BRINDLE_EXPORT brindle {

/// Collective. As `measure_waves` of the whole surface, on every rank; `waves` has an entry per
/// vertex of the piece, but positions, which may be missing. What counts of a vertex is what its
/// owner says. Counts and the extremes of frequencies are those of one process that has the same
/// waves, the other figures too, but for rounding. Throws Error on all ranks for waves that do not
/// match the piece.
WaveFigures measure_waves(const DistributedSurface& surface, const WaveSet& waves);

/// A solved pattern, as frames have it: entries per vertex of the piece. What counts of a vertex is
/// what its owner says. What it refers to must outlive the call that it is handed to.
struct PiecePattern {
  const DistributedSurface& surface;
  const WaveSet& waves;
  std::span<const Complex> z;
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;
};

/// Where a curve crosses the border of a piece.
struct BorderCrossing {
  std::array<std::uint64_t, 2> edge;  ///< the numbers of its ends in the whole, the lower one first
  std::uint32_t number;               ///< of the crossings of this edge, from that end

  auto operator<=>(const BorderCrossing&) const = default;
};

/// The parts of curves that run in one rank's triangles.
struct PieceCurves {
  Polylines lines;  ///< places are in the triangles of the piece, by their numbers there
  /// Why ends are ends, as of StripeCurves. Where `borders` has a crossing it is none: exactly one
  /// end on another rank has the same crossing, and its point has the same bits.
  std::vector<std::array<CurveEnd, 2>> ends;
  std::vector<std::array<std::optional<BorderCrossing>, 2>> borders;
};

/// Collective. The curves that `whole_curves` has, each rank's parts of them. Throws Error on all
/// ranks for patterns whose parts do not match the piece, for options that contradict each other,
/// and for `fair`, whose points do not lie on edges.
PieceCurves piece_curves(const PiecePattern& pattern, const CurveOptions& options = {});

/// Curves of a whole surface, on rank 0.
struct WholeCurves {
  StripeCurves curves;             ///< places are in triangles of ranks' pieces
  std::vector<int> rank_of_point;  ///< that has this triangle
};

/// Collective. The curves of `brindle::stripe_curves` with the same phases, on rank 0; nothing
/// elsewhere. Rank 0 gets the whole surface and makes them of that, so the pieces do not matter.
/// They have the bits of one process where triangles have numbers; without, curves come in another
/// order. Throws Error on all ranks where `piece_curves` and `stripe_curves` do, and Cancelled if
/// the `progress` of a rank asks for it.
WholeCurves whole_curves(const PiecePattern& pattern, const CurveOptions& options = {},
                         const Progress& progress = {});

/// Collective. Samples where the peaks of two patterns cross, in this rank's triangles, whose
/// numbers are those of the piece. Rank 0 finds them on the whole surface; each is one rank's.
std::vector<Sample> wave_samples(const PiecePattern& u, const PiecePattern& v);

/// Collective. As `drop_doubles` of all ranks' samples, in the order of ranks. Returns how many are
/// left out on all ranks. Rank 0 needs memory for all samples.
std::size_t drop_doubles(const DistributedSurface& surface, std::vector<Sample>& samples,
                         float share = kDoubleShare);

/// Collective. All ranks' samples on rank 0, in the order of ranks; nothing elsewhere.
std::vector<Sample> gathered_samples(const DistributedSurface& surface,
                                     std::span<const Sample> samples);

}  // namespace brindle
