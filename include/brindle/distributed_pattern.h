/// Metrics, curves and samples of patterns on partitioned surfaces. Needs a build with BRINDLE_MPI.
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
#include "brindle/wave_metrics.h"

namespace BRINDLE_EXPORT brindle {

/// Collective. `measure_waves` of the whole surface, on every rank. `waves` has one entry per
/// vertex of the partition; positions may be missing. The owner's values of a vertex count. Counts
/// and extremes of frequencies equal those of one process with the same waves, other metrics up to
/// rounding. Throws Error on all ranks for waves that do not match the partition.
WaveMetrics measure_waves(const DistributedSurface& surface, const WaveSet& waves);

/// A solved pattern, as from frames, with one entry per vertex of the partition. The owner's values
/// of a vertex count. Referenced objects must outlive the call.
struct PiecePattern {
  const DistributedSurface& surface;
  const WaveSet& waves;
  std::span<const Complex> z;
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;
};

/// A crossing of a curve with the border of a partition.
struct BorderCrossing {
  std::array<std::uint64_t, 2> edge;  ///< vertex numbers of its ends in the whole, lower first
  std::uint32_t number;               ///< of the crossing along this edge, from that end

  auto operator<=>(const BorderCrossing&) const = default;
};

/// The parts of curves within one rank's triangles.
struct PieceCurves {
  Polylines lines;  ///< places are in triangles of the partition, by their numbers there
  /// Reasons of ends, as in StripeCurves. Where `borders` has a crossing, the curve continues:
  /// exactly one end on another rank has the same crossing, and its point has the same bits.
  std::vector<std::array<CurveEnd, 2>> ends;
  std::vector<std::array<std::optional<BorderCrossing>, 2>> borders;
};

/// Collective. Each rank's parts of the curves of `whole_curves`. Throws Error on all ranks for
/// patterns that do not match the partition, for contradictory options, and for `fair`, whose
/// points do not lie on edges.
PieceCurves piece_curves(const PiecePattern& pattern, const CurveOptions& options = {});

/// Curves of a whole surface, on rank 0.
struct WholeCurves {
  StripeCurves curves;             ///< places are in triangles of partitions
  std::vector<int> rank_of_point;  ///< the rank that has its triangle
};

/// Collective. The curves of `brindle::stripe_curves` with the same phases, on rank 0; empty
/// elsewhere. Rank 0 gathers the whole surface, so the curves do not depend on partitions. If
/// triangles have numbers, they have the bits of one process; otherwise only their order differs.
/// Throws Error on all ranks for patterns that do not match the partition and as `stripe_curves`
/// does, and Cancelled if the `progress` of any rank cancels.
WholeCurves whole_curves(const PiecePattern& pattern, const CurveOptions& options = {},
                         const Progress& progress = {});

/// Collective. Samples at crossings of the peaks of two patterns, in this rank's triangles, by
/// their numbers in the partition. Rank 0 finds them on the whole surface; each belongs to one
/// rank.
std::vector<Sample> wave_samples(const PiecePattern& u, const PiecePattern& v);

/// Collective. `drop_doubles` of all ranks' samples, in the order of ranks. Returns the number
/// removed on all ranks. Rank 0 needs memory for all samples.
std::size_t drop_doubles(const DistributedSurface& surface, std::vector<Sample>& samples,
                         float share = kDoubleShare);

/// Collective. All ranks' samples on rank 0, in the order of ranks; empty elsewhere.
std::vector<Sample> gathered_samples(const DistributedSurface& surface,
                                     std::span<const Sample> samples);

}  // namespace brindle
