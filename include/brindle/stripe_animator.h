/// Stripes that follow changing input, frame by frame (docs/method.md).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/phase_shift.h"
#include "brindle/progress.h"
#include "brindle/spacing_tolerance.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

struct AnimatorArchive;

/// Solvers that let a frame's phases follow the last frame's.
enum class FrameSolver {
  multilevel,  ///< a full descent, attracted to the last phases by anchors of weight lambda
  relaxation   ///< the paper's method (section 4, "Dynamic Input"): iterations from the last phases
};

/// Options of animators.
struct AnimatorOptions {
  FrameSolver solver = FrameSolver::multilevel;
  float lambda = 0.025f;  ///< weight of the anchor T_i = lambda deg_i z_i(last frame); 0: each
                          ///< frame from scratch
  int sweeps = 2;         ///< coloured sweeps per level, multilevel
  int cycles = 0;         ///< further descents, each from the phases of the one before
  int iterations = 3;     ///< per frame, relaxation
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;  ///< aligned or trapezoid
  /// One per directed edge, symmetric, not negative: multiplies the paper's weight; empty: 1; not
  /// for GpuAnimator and DistributedStripeAnimator.
  std::vector<float> edge_weights;
  Slack slack = 0;  ///< spacing tolerance (spacing_tolerance.h); needs an animator of a surface
};

/// One frame's input, one entry per vertex each. Spans are read during the call only.
struct FrameInput {
  std::span<const Vec3> positions;
  std::span<const Vec3> directions;  ///< unit tangent vectors, or zero for no wave
  std::span<const float> frequencies;
  /// Unit vectors that directions must be tangent to (as in `stripe_pattern`), or zero if unknown.
  /// Empty: those of the animator's surface, while vertices stay where they were there; otherwise
  /// tangency is not checked.
  std::span<const Vec3> normals = {};
};

/// Times of a frame's stages.
struct FrameMilliseconds {
  double frequency = 0;  ///< solving for frequencies, and comparing the input with the last one
  double couple = 0;     ///< waves into the solver's order, phase shifts, anchors
  double sum = 0;        ///< gauges and coarse sums
  double solve = 0;      ///< descents or iterations, phases back into vertex order
};

/// A frame's phases.
struct FrameResult {
  std::span<const Complex> z;  ///< one phase per vertex; valid until the next frame
  /// Mean |angle| between this frame's phases and the last one's, in radians, over vertices with a
  /// wave and a last phase; 0 in the first frame.
  double phase_step = 0;
  bool unchanged = false;  ///< input and phases are those of the last frame
  /// With slack: the frequencies of the phases, one per vertex, valid until the next frame, and
  /// their change. Empty without slack.
  std::span<const float> frequencies;
  FrequencyChange frequency_change;
  FrameMilliseconds milliseconds;
};

/// Lays stripes on one surface for one field that changes from frame to frame. The first frame
/// builds what depends only on connectivity. Later frames renew couplings, gauges and coarse sums,
/// allocate nothing, and take time linear in the number of edges. Two orthogonal fields need two
/// animators, the second from `sibling`.
class StripeAnimator {
 public:
  /// Throws Error for options out of range, and for slack, which needs the surface.
  explicit StripeAnimator(std::shared_ptr<const Adjacency> neighborhood,
                          const AnimatorOptions& options = {});

  /// As above with the surface's neighbourhood. With slack, frequencies follow each frame's input
  /// from those of the last frame. Does not refer to the surface afterwards.
  explicit StripeAnimator(const Surface& surface, const AnimatorOptions& options = {});
  ~StripeAnimator();
  StripeAnimator(StripeAnimator&&) noexcept;
  StripeAnimator& operator=(StripeAnimator&&) noexcept;

  /// Solves the next frame; the first one from scratch. `progress` reports the first frame's
  /// frequencies and topology, and cycles; a cancellable frame keeps a second copy of the waves.
  /// Throws Error unless the input has one entry per vertex, and for values that `stripe_pattern`
  /// rejects; Cancelled if `progress` cancels. Failed or cancelled calls leave the animator
  /// unchanged.
  FrameResult frame(const FrameInput& input, const Progress& progress = {});

  /// The energy of the last frame's phases, as `energy` of phase_graph.h defines it. Throws Error
  /// before the first frame.
  double energy() const;

  /// An animator for another field on the same surface that shares this one's topology. Call it
  /// after the first frame.
  StripeAnimator sibling() const;

  /// Forgets the last frame's phases: the next frame is solved from scratch.
  void restart();

  /// Makes the next frame follow these phases instead of the last frame's: a unit number per
  /// vertex, for the directions of the next frame, or 0 if unknown, as from `matched_phases` and
  /// `carried_phases`. Also before the first frame. Throws Error for other phases, and then changes
  /// nothing.
  void set_last_phases(std::span<const Complex> z);

  /// Sets the spacing tolerance of all following frames. Frequencies continue from the last ones
  /// or, if `branch_penalty` changes, from those of the input. Throws Error for a slack that
  /// `relaxed_frequencies` rejects, and for an animator that was made without slack; then nothing
  /// changes.
  void set_slack(const Slack& slack);

  /// Milliseconds that building the topology took in the first frame. Aggregates follow the first
  /// couplings, so their sums are included.
  double topology_milliseconds() const;

 private:
  struct State;
  friend struct AnimatorArchive;  // saved.h
  friend class TextureAnimator;   // keeps the frames of both its patterns, or neither
  explicit StripeAnimator(std::unique_ptr<State> state);
  void allow_take_back();
  FrameResult solve(const FrameInput& input, const Progress& progress);
  void sew(const FrameInput& input);
  void keep(const FrameInput& input, FrameResult& solved);
  void take_back(const FrameResult& solved);
  void start(const Progress& progress);
  void take_phases_back();
  Pimpl<State> state_;
};

}  // namespace brindle
