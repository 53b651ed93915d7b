/// Stripes that follow changing input on the device, from waves to phases, without reading back
/// (twin: stripe_animator.h).
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "brindle/export.h"
#include "brindle/gpu_solver.h"
#include "brindle/stripe_animator.h"

namespace BRINDLE_EXPORT brindle {

/// A stage of the work on the device and its milliseconds there.
using StageTime = std::pair<std::string_view, double>;

/// Names of OpenGL buffers with one frame's input, one entry per vertex each. They are read only.
struct WaveBuffers {
  unsigned positions;    ///< 3 floats a vertex
  unsigned directions;   ///< 3 floats a vertex: unit tangent vectors, or zero for no wave
  unsigned frequencies;  ///< 1 float a vertex
};

/// Metrics of a frame's phases.
struct FrameMeasure {
  int frame;  ///< its number from 0, as `GpuAnimator::frame` counts
  double energy;
  double phase_step;  ///< as in FrameResult
};

/// A StripeAnimator on OpenGL's device. The first frame builds on the processor all that depends
/// only on connectivity; later ones read nothing back. All calls need the context of the kernels,
/// or one that shares its objects. They change the current program, storage bindings 0 to 7 and
/// uniform binding 0. Subsequent OpenGL commands use a new frame's phases.
class GpuAnimator {
 public:
  /// Also supports common-source phase shifts. Throws Error for options out of range, for edge
  /// weights, which the device does not support, and for slack, which needs the surface.
  GpuAnimator(std::shared_ptr<const GpuKernels> kernels,
              std::shared_ptr<const Adjacency> neighborhood, const AnimatorOptions& options = {});

  /// As above with the surface's neighbourhood. With slack, the processor solves for each frame's
  /// frequencies and uploads them; they are bit-identical to StripeAnimator's.
  GpuAnimator(std::shared_ptr<const GpuKernels> kernels, const Surface& surface,
              const AnimatorOptions& options = {});
  ~GpuAnimator();
  GpuAnimator(GpuAnimator&&) noexcept;
  GpuAnimator& operator=(GpuAnimator&&) noexcept;

  /// Solves the next frame; the first one from scratch. Returns whether the input has changed: if
  /// not, the phases stay as they are. `progress` reports the first frame's topology, and cycles.
  /// Throws Error unless the input has one entry per vertex, for waves that are not valid
  /// (`WaveSet`), and if the mesh does not fit the device; Cancelled if `progress` cancels. Then
  /// the animator is unchanged.
  bool frame(const FrameInput& input, const Progress& progress = {});

  /// As above from buffers, which are not compared with the last frame's. The first frame reads
  /// them back once, to build on and check them. Later frames do not check values: a NaN makes the
  /// measured energy NaN. Throws Error with slack, because the processor solves for frequencies.
  void frame(const WaveBuffers& input, const Progress& progress = {});

  /// With slack: the frequencies of the last frame's phases, one per vertex, and their change,
  /// until the next frame. Empty without slack and after a frame from buffers.
  std::span<const float> frequencies() const;
  const FrequencyChange& frequency_change() const;

  /// The name of the buffer of phases: one exp(i Phi) per vertex, as 2 floats. It is the same for
  /// the animator's lifetime; there is none before the first frame.
  unsigned phases() const;

  /// A copy of the phases. Waits for the device.
  std::vector<Complex> read_phases() const;

  /// Whether every frame from the next one on is measured; costs two dispatches a frame.
  void measure_frames(bool measures);

  /// The latest measure that is available without waiting: of the frame before the last.
  const std::optional<FrameMeasure>& measured() const;

  /// The measure of the last frame. Waits for the device.
  std::optional<FrameMeasure> measure_now();

  /// Times of the last frame's stages on the device: "load" (uploads, and waves into the solver's
  /// order), "couple", "sums" (gauges and sums of large levels), "small levels" (their gauges, sums
  /// and descent), "sweeps" (descent through large levels) or "relaxation", "nodes" (phases into
  /// vertex order), "measure". Waits for the device.
  std::vector<StageTime> stage_milliseconds() const;

  /// The number of dispatches of the last frame.
  std::size_t dispatches() const;

  /// As in StripeAnimator.
  GpuAnimator sibling() const;
  void restart();
  void set_last_phases(std::span<const Complex> z);
  void set_slack(const Slack& slack);
  double topology_milliseconds() const;

 private:
  struct State;
  explicit GpuAnimator(std::unique_ptr<State> state);
  template <class Prepare>
  void solve(const Progress& progress, const Prepare& prepare);
  Pimpl<State> state_;
};

}  // namespace brindle
