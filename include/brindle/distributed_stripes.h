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
  /// A surface with fewer vertices is solved by rank 0 alone, as one process would solve it. It
  /// needs the room of the whole for that.
  std::size_t plan_below = 262144;
  EdgeWeights weights = EdgeWeights::paper;  ///< of the pieces' shape; in place of `edge_weights`
};

/// What the measured triangles of all ranks say of a pattern.
struct DistributedMeasures {
  std::vector<CornerPhases> corners;  ///< of the piece's triangles; of its ghosts no_wave
  PatternQuality quality;             ///< of the whole surface, on every rank
};

/// What frames took, on this rank. All but `ghosts` are 0 before the first frame.
struct DistributedFigures {
  double topology_milliseconds = 0;    ///< of the first frame, that later ones do not need
  std::size_t distributed_levels = 0;  ///< that all ranks have parts of; rank 0 has coarser ones
  int sweeps = 0;          ///< over the finest level in the last descent, cycles included
  std::size_t ghosts = 0;  ///< of the finest level
  /// What the sweeps of a frame without cycles have to bring to this rank at least: 8 for each
  /// ghost, sweep and distributed level.
  std::size_t halo_bytes = 0;
  /// What the frequencies of the last frame have sent, where ranks solve for them together.
  std::uint64_t frequency_bytes = 0;
  /// What halos brought for them: 4 bytes for each ghost, sweep and distributed level, and for each
  /// ghost of the finest level once a cycle.
  std::uint64_t frequency_halo_bytes = 0;
};

/// A StripeAnimator over all ranks. With one rank, and below `plan_below` vertices with any number,
/// its phases and energies are those of a StripeAnimator, bit for bit, where triangles have
/// numbers; else the same bits in every run with the same pieces. All members are collective.
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

  DistributedFigures figures() const;

 private:
  struct State;
  Pimpl<State> state_;
};

}  // namespace brindle
