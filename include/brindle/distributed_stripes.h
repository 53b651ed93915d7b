/// Stripes over a surface that many processes hold together. Needs a build with BRINDLE_MPI.
#pragma once

#include <cstddef>
#include <cstdint>
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

/// Those of a StripeAnimator but weights by edge, which are refused. Slack and calm by vertex are
/// those of the piece's vertices; what counts is what a vertex's owner says.
struct DistributedOptions : AnimatorOptions {
  /// Levels with fewer nodes on all ranks together are solved by rank 0 alone.
  std::size_t gather_below = 16384;
  /// Of a surface with fewer vertices rank 0 plans all levels, as one process would have them; then
  /// phases are one process's, but for rounding. It needs the room of the whole for that.
  std::size_t plan_below = 262144;
  EdgeWeights weights = EdgeWeights::paper;  ///< of the pieces' shape; in place of `edge_weights`
};

/// What the measured triangles of all ranks say of a pattern.
struct DistributedMeasures {
  std::vector<CornerPhases> corners;  ///< of the piece's triangles; of its ghosts no_wave
  PatternQuality quality;             ///< of the whole surface, on every rank
};

/// What frequencies that yield have sent, on this rank.
struct FrequencyTraffic {
  std::uint64_t bytes = 0;
  /// What halos brought to this rank: 4 bytes for each ghost, sweep and distributed level, and for
  /// each ghost of the finest level once a cycle.
  std::uint64_t halo_bytes = 0;
};

/// A StripeAnimator over all ranks. With one rank its phases, energies and measures are those of a
/// StripeAnimator, bit for bit; with more, the same bits in every run with the same pieces, and
/// below `plan_below` vertices those of one rank, the first frame's to the bit and later ones' to
/// rounding. All members are collective.
class DistributedStripeAnimator {
 public:
  /// Throws Error for options out of range and weights by edge.
  explicit DistributedStripeAnimator(const DistributedSurface& surface,
                                     const DistributedOptions& options = {});
  ~DistributedStripeAnimator();
  DistributedStripeAnimator(DistributedStripeAnimator&&) noexcept;
  DistributedStripeAnimator& operator=(DistributedStripeAnimator&&) noexcept;

  /// As StripeAnimator::frame. The input has one entry per vertex of the piece; what counts of a
  /// vertex is what its owner says. Where `progress` cancels one rank, all are cancelled.
  FrameResult frame(const FrameInput& input, const Progress& progress = {});

  /// The energy of the last frame's phases, over all ranks. Throws Error before the first frame.
  double energy() const;

  /// Corner phases and quality of the last frame. Throws Error before the first frame.
  DistributedMeasures measure() const;

  /// Forgets the last frame's phases.
  void restart();

  /// As StripeAnimator::set_last_phases, of the piece's vertices: so stripes go on where a surface
  /// has been dealt to ranks anew. What counts of a vertex is what its owner says.
  void set_last_phases(std::span<const Complex> z);

  /// As StripeAnimator::set_slack; of slack and calm by vertex, what counts of a vertex is what its
  /// owner says.
  void set_slack(const Slack& slack);

  /// Milliseconds of the first frame that later ones do not need.
  double topology_milliseconds() const;

  /// How many levels all ranks have parts of; coarser ones are on rank 0. 0 before the first frame.
  std::size_t distributed_levels() const;

  /// Sweeps of the last frame over the finest level, cycles included; 0 before the first frame and
  /// of relaxation.
  int sweeps() const;

  /// Ghosts of the finest level on this rank.
  std::size_t ghost_count() const;

  /// Bytes that the sweeps of a frame without cycles have to bring to this rank at least: 8 for
  /// each ghost, sweep and distributed level. 0 before the first frame.
  std::size_t halo_bytes() const;

  /// What the last frame's frequencies took; nothing without slack.
  FrequencyTraffic frequency_traffic() const;

 private:
  struct State;
  FrameMilliseconds solve_next(const Progress& progress);
  void couple_next();
  void iterate();
  void keep();
  void take_back();
  Pimpl<State> state_;
};

}  // namespace brindle
