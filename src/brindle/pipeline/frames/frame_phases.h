/// The waves and phases of one frame after another on the finest level of a solver: what animators
/// of one process and of many share.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "brindle/phases/hierarchy.h"
#include "brindle/phases/sliced_waves.h"
#include "brindle/stripe_animator.h"
#include "brindle/types.h"

namespace brindle {

/// Sums over slots with a wave and a last phase.
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

/// By slot, in whole slices. A slot without degree has no wave.
PhaseSteps phase_steps(std::span<const Complex> z, std::span<const Complex> last_z,
                       std::span<const float> degree);

/// Frames are coupled, solved, and then kept or taken back: until then nothing of the last frame is
/// given up. Phases and waves are by slot of the finest level. `waves` and `momentum` need room for
/// its slots before the first frame.
struct FramePhases {
  explicit FramePhases(const AnimatorOptions& options = {});

  bool has_given() const { return !given_z.empty(); }
  /// Whether the next frame is a descent, not the paper's iterations.
  bool descends() const { return solver == FrameSolver::multilevel || !has_last; }

  /// Takes the waves of the next frame. Last phases are turned with waves that are given the other
  /// way round; given phases are those of the frame's directions and replace the last ones. Returns
  /// whether anything has changed.
  bool load(const Level& finest, const FrameInput& input);

  /// The normals of the next waves, where there are links over creases.
  void load_normals(std::span<const Vec3> normals_by_node);

  /// Couples the next waves, and anchors them to the last phases where there are any.
  void couple_next(Level& finest);

  /// The paper's iterations from the last phases, and from the peak where none is known.
  /// `relax(momentum)` is one of them.
  void iterate(Level& finest, const std::function<void(Momentum&)>& relax);

  /// How far the phases that were found are from the last ones.
  PhaseSteps steps(const Level& finest) const;

  /// Makes the frame that was just solved the last one. Cannot fail.
  void keep(const Level& finest);

  /// Makes everything as it was before the frame that was just solved, if there was one before.
  void take_back(Level& finest);

  void restart();

  FrameSolver solver;
  float lambda;
  int iterations;
  PhaseShiftKind phase_shift;

  /// Whether a frame may be taken back. A frame without a listener need not be, if nothing comes
  /// after it, and its waves replace the last ones at once: that saves memory.
  bool may_be_taken_back = false;
  bool has_frame = false;                     ///< whether a frame has come to its end
  bool has_last = false;                      ///< whether the next frame follows one
  std::vector<SlicedWave> waves;              ///< of the last frame
  std::vector<SlicedWave> cancellable_waves;  ///< of the frame that is solved, if it may be taken
                                              ///< back
  std::vector<float> weights;                 ///< of edges by entry; empty: 1
  std::vector<LinkedEntry> linked;            ///< over creases
  std::vector<Vec3> normals, next_normals;  ///< by node, of the last and the next waves, for these
  std::vector<float> degree;                ///< sum of weights by slot
  std::vector<Complex> last_z;
  std::vector<Complex> given_z;  ///< by node: what the next frame follows instead; empty: none
  std::vector<Complex> z_by_node;
  Momentum momentum;
  std::vector<Complex> last_momentum;  ///< before the frame that is solved, if it has changed
  bool has_iterated = false;           ///< whether it has

 private:
  void couple_to(Level& finest, std::span<const SlicedWave> of, std::span<const Vec3> normals_of);
  std::vector<SlicedWave>& next_waves() { return may_be_taken_back ? cancellable_waves : waves; }
};

}  // namespace brindle
