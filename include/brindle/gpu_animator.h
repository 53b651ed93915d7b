/// Stripes that follow changing input on the device, from waves to phases without a copy back
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

/// A stage of GpuAnimator and the bytes that it moves at least.
using StageBytes = std::pair<std::string_view, std::size_t>;

/// Names of OpenGL buffers with one frame's input, one entry per vertex each. They are read only.
struct WaveBuffers {
  unsigned positions;    ///< 3 floats a vertex
  unsigned directions;   ///< 3 floats a vertex: unit tangent vectors, or zero for no wave
  unsigned frequencies;  ///< 1 float a vertex
};

/// What a frame's phases are worth.
struct FrameMeasure {
  int frame;  ///< its number from 0, as `GpuAnimator::frame` counts
  double energy;
  double phase_step;  ///< as in FrameResult
};

/// StripeAnimator on the device that OpenGL works on. The first frame builds on the processor what
/// depends on the connectivity alone; later ones bring nothing back. All calls need the context of
/// the kernels, or one that shares its objects; they change the current program, storage bindings 0
/// to 7 and uniform binding 0. A new frame's phases are seen by whatever OpenGL does after it.
class GpuAnimator {
 public:
  /// Common-source phase shifts work here, too. Throws Error for options out of range, for edge
  /// weights, which the device does not know, and for slack, which needs the surface.
  GpuAnimator(std::shared_ptr<const GpuKernels> kernels,
              std::shared_ptr<const Adjacency> neighborhood, const AnimatorOptions& options = {});

  /// The same of the surface's neighbourhood; with slack, frequencies follow each frame's input, on
  /// the processor, and are uploaded: bits are those of StripeAnimator's frequencies.
  GpuAnimator(std::shared_ptr<const GpuKernels> kernels, const Surface& surface,
              const AnimatorOptions& options = {});
  ~GpuAnimator();
  GpuAnimator(GpuAnimator&&) noexcept;
  GpuAnimator& operator=(GpuAnimator&&) noexcept;

  /// Solves for the next frame; the first one from scratch. Returns whether the input has changed:
  /// if not, the phases stay as they are. `progress` hears of the first frame's topology, and of
  /// cycles. Throws Error if the input has not one entry per vertex, for waves that are not valid
  /// (`WaveSet`), and if the mesh does not fit the device; Cancelled if `progress` asks for it. The
  /// animator then is as it was before the call.
  bool frame(const FrameInput& input, const Progress& progress = {});

  /// The same from buffers; what they hold is not compared with the last frame's. The first frame
  /// reads them back, once, to build on and to check them. Later ones do not look at values: one
  /// that is no number makes the measured energy none. Throws Error with slack: frequencies are
  /// found on the processor.
  void frame(const WaveBuffers& input, const Progress& progress = {});

  /// With slack: the frequencies that the last frame's phases are of, one per vertex, until the
  /// next frame, and what they have become. Empty without, and after a frame from buffers.
  std::span<const float> frequencies() const;
  const FrequencyChange& frequency_change() const;

  /// Name of the buffer of phases: one exp(i Phi) per vertex, as 2 floats. The same as long as the
  /// animator lives; none before the first frame.
  unsigned phases() const;

  /// A copy of it. Waits for the device.
  std::vector<Complex> read_phases() const;

  /// Measures every frame from the next one on; costs two dispatches a frame.
  void measure_frames(bool measures);

  /// The last frame whose measure has come: the one before the last, so that nobody waits.
  const std::optional<FrameMeasure>& measured() const;

  /// That of the last frame itself. Waits for the device.
  std::optional<FrameMeasure> measure_now();

  /// Times of the last frame's stages on the device: "load" (uploads, and waves into the solver's
  /// order), "couple", "sums" (gauges and sums of large levels), "small levels" (theirs and their
  /// descent), "sweeps" (descent through large levels) or "relaxation", "nodes" (phases into vertex
  /// order), "measure". Waits for the device.
  std::vector<StageTime> stage_milliseconds() const;

  /// The bytes that these stages move at least, by `frame_traffic`.
  std::vector<StageBytes> stage_bytes() const;

  /// Dispatches of the last frame.
  std::size_t dispatches() const;

  /// As StripeAnimator's.
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
