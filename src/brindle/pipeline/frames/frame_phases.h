/// Waves and phases of successive frames on the solver's finest level. Shared by the animators of
/// one process and of several.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "brindle/phases/hierarchy.h"
#include "brindle/phases/sliced_waves.h"
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

/// T_i = lambda deg_i z_i of the last frame, by slot.
void set_anchors(std::span<const float> degree, std::span<const Complex> last_z, float lambda,
                 std::vector<Complex>& anchor);

/// Arrays are by slot, in whole slices. A slot with degree 0 has no wave.
PhaseSteps phase_steps(std::span<const Complex> z, std::span<const Complex> last_z,
                       std::span<const float> degree);

/// A frame is coupled, solved, then kept or rolled back; until then the last frame stays intact.
/// Phases and waves are by slot of the finest level. Reserve `waves` and `momentum` for its slots
/// before the first frame.
struct FramePhases {
  explicit FramePhases(const AnimatorOptions& options = {});

  bool has_given() const { return !given_z.empty(); }
  /// Whether the next frame is solved by descent, not by the paper's iterations.
  bool descends() const { return solver == FrameSolver::multilevel || !has_last; }

  /// Loads the next waves. Last phases are flipped with reversed waves. Given phases belong to the
  /// new directions and replace the last ones. Returns whether anything has changed.
  bool load(const Level& finest, const FrameInput& input);

  /// Sets the normals of the next waves; only used for links across creases.
  void load_normals(std::span<const Vec3> normals_by_node);

  /// Couples the next waves and anchors them to the last phases, if any.
  void couple_next(Level& finest);

  /// The paper's iterations, starting from the last phases, or from the peak where there are none.
  /// `relax(momentum)` is one iteration.
  void iterate(Level& finest, const std::function<void(Momentum&)>& relax);

  /// Phase distances between the solution and the last frame.
  PhaseSteps steps(const Level& finest) const;

  /// Commits the frame that was solved last. Does not throw.
  void keep(const Level& finest);

  /// Rolls back the frame that was solved last, if there was a frame before it.
  void take_back(Level& finest);

  void restart();

  FrameSolver solver;
  float lambda;
  int iterations;
  PhaseShiftKind phase_shift;

  /// Whether a frame may be rolled back. Frames without a listener need not be, if no step follows:
  /// their waves then overwrite the last ones, which saves memory.
  bool may_be_taken_back = false;
  bool has_frame = false;                     ///< whether a frame has been completed
  bool has_last = false;                      ///< whether the next frame has last phases
  std::vector<SlicedWave> waves;              ///< of the last frame
  std::vector<SlicedWave> cancellable_waves;  ///< of the next frame, if reversible
  std::vector<float> weights;                 ///< of edges, by entry; empty: 1
  std::vector<LinkedEntry> linked;            ///< links across creases
  std::vector<Vec3> normals, next_normals;    ///< by node, for `linked`
  std::vector<float> degree;                  ///< by slot: sum of weights
  std::vector<Complex> last_z;
  std::vector<Complex> given_z;  ///< by node: replaces last_z in the next frame; empty: none
  std::vector<Complex> z_by_node;
  Momentum momentum;
  std::vector<Complex> last_momentum;  ///< for rolling back; valid if has_iterated
  bool has_iterated = false;           ///< whether the frame has changed `momentum`

 private:
  void couple_to(Level& finest, std::span<const SlicedWave> of, std::span<const Vec3> normals_of);
  std::vector<SlicedWave>& next_waves() { return may_be_taken_back ? cancellable_waves : waves; }
};

}  // namespace brindle
