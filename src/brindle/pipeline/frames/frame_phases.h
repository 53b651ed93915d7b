/// Waves and phases of successive frames on the solver's finest level. Shared by the animators of
/// one process and of several.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "brindle/base/archive.h"
#include "brindle/base/stopwatch.h"
#include "brindle/phases/multilevel.h"
#include "brindle/phases/sliced_waves.h"
#include "brindle/progress.h"
#include "brindle/stripe_animator.h"
#include "brindle/types.h"

namespace brindle {

/// Sums over slots with a wave and a last phase: `angle` of |arg(z conj(last_z))|, in radians.
struct PhaseSteps {
  double angle = 0;  ///< of |arg(z conj(last_z))|, in radians
  double count = 0;

  PhaseSteps operator+(const PhaseSteps& other) const {
    return {angle + other.angle, count + other.count};
  }
  double mean() const { return count > 0 ? angle / count : 0; }
};

/// Times the stages of a frame.
struct FrameClock : Stopwatch {
  FrameMilliseconds spent;

  /// Adds the time since the last stage.
  void add(double FrameMilliseconds::*stage) { spent.*stage += lap(); }
};

/// A frame is coupled, solved, then kept or rolled back; until then the last frame stays intact.
/// Phases and waves are by slot of the finest level.
struct FramePhases {
  explicit FramePhases(const AnimatorOptions& options = {});

  /// Allocates all buffers for a new finest level, so that frames allocate nothing.
  void start(const SlicedLayout& layout);

  /// Makes these phases, by node, the last ones of the next frame.
  void give(std::span<const Complex> z);

  /// Loads the next waves. Last phases are flipped with reversed waves. Given phases belong to the
  /// new directions and replace the last ones. Returns whether anything has changed.
  bool load(const Level& finest, const FrameInput& input);

  /// Solves for phases of the finest level from the next waves, by a descent, which builds coarser
  /// levels at first, or by the paper's iterations. `levels` is a RankHierarchy or has its
  /// functions.
  template <class Levels>
  void solve(Levels& levels, const AnimatorOptions& options, FrameClock& clock,
             const Progress& progress);

  /// Whether nothing ties the frame's phases to those of the last one.
  bool starts_afresh() const { return !has_last || (descends() && lambda == 0); }

  /// Phase distances between the solution and the last frame.
  PhaseSteps steps(const Level& finest) const;

  /// Commits the frame that was solved last. Does not throw.
  void keep(const Level& finest);

  /// Rolls back the frame that was solved last, if there was a frame before it.
  void take_back(Level& finest);

  void restart();

  /// Saves the last frame by node, or restores it; throws Error for a frame that could not have
  /// been solved. `finest` is null before the first frame.
  void archive(Archive& archive, std::size_t nodes, Level* finest);

  void couple_to(Level& finest, std::span<const SlicedWave> of);
  std::vector<SlicedWave>& next_waves() { return may_be_taken_back ? cancellable_waves : waves; }

  FrameSolver solver;
  float lambda;
  int iterations;
  PhaseShiftKind phase_shift;

  /// Whether a frame may be rolled back. Frames without a listener need not be, if no step follows:
  /// their waves then overwrite the last ones, which saves memory.
  bool may_be_taken_back = false;
  bool has_frame = false;                     ///< whether a frame has been completed
  bool has_given = false;                     ///< whether given_z replaces last_z in the next frame
  bool has_last = false;                      ///< whether the next frame has last phases
  std::vector<SlicedWave> waves;              ///< of the last frame
  std::vector<SlicedWave> cancellable_waves;  ///< of the next frame, if reversible
  std::vector<float> weights;                 ///< of edges, by entry; empty: 1
  std::vector<float> degree;                  ///< by slot: sum of weights
  std::vector<Complex> last_z;
  std::vector<Complex> given_z;  ///< by node
  std::vector<Complex> z_by_node;
  Momentum momentum;
  std::vector<Complex> last_momentum;  ///< for rolling back; valid if has_iterated
  bool has_iterated = false;           ///< whether the frame has changed `momentum`
  int sweeps = 0;                      ///< over the finest level in the last descent, with cycles
  double topology_milliseconds = 0;    ///< to build levels

 private:
  /// Whether the next frame is solved by descent, not by the paper's iterations.
  bool descends() const { return solver == FrameSolver::multilevel || !has_last; }
  /// Couples the next waves and anchors them to the last phases, if any.
  void couple_next(Level& finest);
  /// The paper's iterations, starting from the last phases, or from the peak where there are none.
  /// `relax(momentum)` is one iteration.
  void iterate(Level& finest, const std::function<void(Momentum&)>& relax);
};

/// Waves by slot in an archive, by node. Throws Error as `check_waves` does.
void archive_waves(Archive& archive, const SlicedLayout& layout, std::vector<SlicedWave>& waves);

template <class Levels>
void FramePhases::solve(Levels& levels, const AnimatorOptions& options, FrameClock& clock,
                        const Progress& progress) {
  couple_next(levels.finest());
  clock.add(&FrameMilliseconds::couple);
  const bool builds = !levels.is_coarsened();
  if (builds) {
    levels.coarsen(progress.part(0, 0.6));
    topology_milliseconds += clock.lap();
  }
  if (descends() && !builds) levels.renew();
  clock.add(&FrameMilliseconds::sum);
  if (!descends()) {
    return iterate(levels.finest(), [&](Momentum& m) { levels.relax(m); });
  }
  const Index slots = levels.slots_of_all();
  const SweepPlan plan =
      builds ? SweepPlan::for_new_levels(options.sweeps, slots) : SweepPlan(options.sweeps);
  levels.descend(plan, progress.part(0.6, 0.7));
  levels.run_cycles(plan, options.cycles, progress.part(0.7, 1));
  sweeps = plan.on_level(slots).count * (1 + options.cycles);
}

}  // namespace brindle
