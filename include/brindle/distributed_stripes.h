/// Stripes on a surface partitioned over processes. Needs a build with BRINDLE_MPI.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "brindle/corner_phases.h"
#include "brindle/distributed_surface.h"
#include "brindle/export.h"
#include "brindle/progress.h"
#include "brindle/quality.h"
#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"

namespace BRINDLE_EXPORT brindle {

/// Options of a StripeAnimator; weights by edge are rejected. Slack and `branch_penalty` by vertex
/// have one entry per vertex of the partition; the owner's values of a vertex count.
struct DistributedOptions : AnimatorOptions {
  /// Rank 0 alone solves levels with fewer nodes on all ranks together.
  std::size_t gather_below = 16384;
  /// Rank 0 alone solves surfaces with fewer vertices or with creases, as one process does. It
  /// needs memory for the whole surface.
  std::size_t plan_below = 262144;
  /// From the partitions' geometry; replaces `edge_weights`.
  EdgeWeights weights = EdgeWeights::paper;
};

/// Metrics of a pattern over the measured triangles of all ranks.
struct DistributedMeasures {
  std::vector<CornerPhases> corners;  ///< of the partition's triangles; ghosts have no_wave
  PatternQuality quality;             ///< of the whole surface, on every rank
  std::optional<CreaseSlip> slip;     ///< as quality; empty without creases
};

/// Statistics of frames, on this rank. All but `ghosts` are 0 before the first frame.
struct DistributedMetrics {
  double topology_milliseconds = 0;    ///< of the first frame only
  std::size_t distributed_levels = 0;  ///< levels shared by all ranks; coarser ones are on rank 0
  int sweeps = 0;          ///< over the finest level in the last descent, cycles included
  std::size_t ghosts = 0;  ///< of the finest level
  /// The least number of bytes that sweeps of a frame without cycles bring to this rank: 8 per
  /// ghost, sweep and distributed level.
  std::size_t halo_bytes = 0;
  /// Bytes sent to solve for the frequencies of the last frame, if ranks do so together.
  std::uint64_t frequency_bytes = 0;
  /// Bytes that halos brought for them: 4 per ghost, sweep and distributed level, and per ghost of
  /// the finest level once a cycle.
  std::uint64_t frequency_halo_bytes = 0;
};

/// A StripeAnimator over all ranks. All members are collective. With one rank, creases, or below
/// `plan_below` vertices, phases and energies are bit-identical to a StripeAnimator's if triangles
/// have numbers. Otherwise the same partitions give the same bits in every run.
class DistributedStripeAnimator {
 public:
  /// Throws Error for options out of range and for weights by edge.
  explicit DistributedStripeAnimator(const DistributedSurface& surface,
                                     const DistributedOptions& options = {});
  ~DistributedStripeAnimator();
  DistributedStripeAnimator(DistributedStripeAnimator&&) noexcept;
  DistributedStripeAnimator& operator=(DistributedStripeAnimator&&) noexcept;

  /// As StripeAnimator::frame. The input has one entry per vertex of the partition; the owner's
  /// values of a vertex count. If `progress` cancels one rank, all are cancelled.
  FrameResult frame(const FrameInput& input, const Progress& progress = {});

  /// The energy of the last frame's phases, over all ranks. Throws Error before the first frame.
  double energy() const;

  /// Corner phases and quality of the last frame. Throws Error before the first frame.
  DistributedMeasures measure() const;

  /// Forgets the last frame's phases.
  void restart();

  /// As StripeAnimator::set_last_phases, for the partition's vertices, such as after
  /// repartitioning. The owner's values of a vertex count.
  void set_last_phases(std::span<const Complex> z);

  /// As StripeAnimator::set_slack. For slack and `branch_penalty` by vertex, the owner's values
  /// count.
  void set_slack(const Slack& slack);

  DistributedMetrics metrics() const;

 private:
  struct State;
  Pimpl<State> state_;
};

}  // namespace brindle
