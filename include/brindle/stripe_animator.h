/// Stripes that follow changing input, frame by frame (docs/method.md).
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/phase_shift.h"
#include "brindle/progress.h"
#include "brindle/surface.h"
#include "brindle/types.h"
#include "brindle/yielding_frequency.h"

namespace BRINDLE_EXPORT brindle {

class Stopwatch;

/// How a frame's phases follow from the last frame's.
enum class FrameSolver {
  multilevel,  ///< a whole descent, drawn towards the last phases by anchors of weight lambda
  relaxation   ///< the paper's way (section 4, "Dynamic Input"): iterations from the last phases
};

struct AnimatorOptions {
  FrameSolver solver = FrameSolver::multilevel;
  float lambda = 0.025f;  ///< weight of the anchor T_i = lambda deg_i z_i(last frame); 0: each
                          ///< frame from scratch
  int sweeps = 2;         ///< coloured sweeps per level, multilevel
  int cycles = 0;         ///< further descents, each from the phases of the one before
  int iterations = 3;     ///< per frame, relaxation
  PhaseShiftKind phase_shift = PhaseShiftKind::aligned;  ///< aligned or trapezoid
  std::vector<float> edge_weights;  ///< one per directed edge, symmetric, not negative: multiplies
                                    ///< the paper's weight; empty: 1; StripeAnimator alone
  Slack slack = 0;  ///< how far frequencies may depart from those of the input, so that fewer
                    ///< stripes begin or end (yielding_frequency.h): for animators of surfaces
};

/// One frame's input, one entry per vertex each. Spans are read during the call only.
struct FrameInput {
  std::span<const Vec3> positions;
  std::span<const Vec3> directions;  ///< unit tangent vectors, or zero for no wave
  std::span<const float> frequencies;
  /// Unit vectors that directions must be tangent to (as `stripe_pattern` asks), or zero
  /// where that is not known. Empty: those of the surface that an animator was made of, as long as
  /// vertices stand where they stood there; otherwise nobody looks.
  std::span<const Vec3> normals = {};
};

struct FrameMilliseconds {
  double frequency = 0;  ///< frequencies that yield, and comparing the input with the last one
  double couple = 0;     ///< waves into the solver's order, phase shifts, anchors
  double sum = 0;        ///< gauges and coarse sums
  double solve = 0;      ///< descents or iterations, phases back into vertex order
};

struct FrameResult {
  std::span<const Complex> z;  ///< one phase per vertex; valid until the next frame
  double phase_step = 0;       ///< mean |angle| between this frame's phases and the last one's, in
                               ///< radians, over vertices with a wave; 0 in the first frame. Where
                               ///< `set_last_phases` knows of none, vertices do not count
  bool unchanged = false;      ///< the input was that of the last frame, and so are the phases
  /// With slack: the frequencies that the phases are of, one per vertex, valid until the next
  /// frame, and what they have become. Empty without.
  std::span<const float> frequencies;
  FrequencyChange frequency_change;
  FrameMilliseconds milliseconds;
};

/// Lays stripes over one surface for one field that changes from frame to frame. What depends on
/// the connectivity alone is built in the first frame; later frames renew couplings, gauges and
/// coarse sums, allocate nothing, and take time linear in the number of edges. A field for two
/// orthogonal directions is two animators, the second made by `sibling`.
class StripeAnimator {
 public:
  /// Throws Error for options out of range, and for slack, which needs the surface.
  explicit StripeAnimator(std::shared_ptr<const Adjacency> neighborhood,
                          const AnimatorOptions& options = {});

  /// The same of the surface's neighbourhood; with slack, frequencies follow each frame's input
  /// from where they were in the last one. Nothing refers to the surface afterwards.
  explicit StripeAnimator(const Surface& surface, const AnimatorOptions& options = {});
  ~StripeAnimator();
  StripeAnimator(StripeAnimator&&) noexcept;
  StripeAnimator& operator=(StripeAnimator&&) noexcept;

  /// Solves for the next frame. The first frame has no last one and is solved from scratch.
  /// `progress` hears of the first frame's frequencies and topology, and of cycles; a frame that it
  /// can cancel keeps a second copy of the waves. Throws Error if the input has not one entry per
  /// vertex, and for values that `stripe_pattern` refuses; Cancelled if `progress` asks for it.
  /// Whatever it throws, the animator then is as it was before the call.
  FrameResult frame(const FrameInput& input, const Progress& progress = {});

  /// The energy of the last frame's phases, as `energy` of phase_graph.h defines it. Throws Error
  /// before the first frame.
  double energy() const;

  /// An animator for another field on the same surface that shares this one's topology. Call it
  /// after the first frame.
  StripeAnimator sibling() const;

  /// Forgets the last frame's phases: the next frame is solved from scratch.
  void restart();

  /// Lets the next frame follow these phases instead of the last frame's: a unit number per vertex,
  /// for the directions that the next frame has, or 0 where none is known; as `matched_phases` and
  /// `carried_phases` give them. Also before the first frame. Throws Error for other phases, and
  /// leaves all as it was.
  void set_last_phases(std::span<const Complex> z);

  /// How far frequencies may depart from those of the input in the next frame and all later ones.
  /// They go on from where they were, but where it is calm elsewhere, from those of the input.
  /// Throws Error for a slack that YieldingFrequency refuses, and for an animator that was
  /// made without slack; then all is as it was.
  void set_slack(const Slack& slack);

  /// Milliseconds that building the topology took, in the first frame. Aggregates follow the first
  /// couplings, so that their sums belong to it.
  double topology_milliseconds() const;

 private:
  struct State;
  friend class TextureAnimator;  // keeps the frames of both its patterns or none
  explicit StripeAnimator(std::unique_ptr<State> state);
  void allow_take_back();
  FrameResult solve(const FrameInput& input, const Progress& progress);
  void sew(const FrameInput& input);
  void keep(const FrameInput& input, FrameResult& solved);
  void take_back(const FrameResult& solved);
  void start(const Progress& progress);
  FrameMilliseconds solve_next(Stopwatch& watch, const Progress& progress);
  void take_phases_back();
  Pimpl<State> state_;
};

}  // namespace brindle
