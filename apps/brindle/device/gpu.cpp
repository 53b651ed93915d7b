#include "device/gpu.h"

#include <utility>

#include "brindle/gpu_animator.h"
#include "brindle/gpu_solver.h"
#include "brindle/headless_context.h"

namespace brindle::tool {
namespace {

/// Reads phases back after every frame, to be measured like those of the processor.
class OnGpu : public Animator {
 public:
  explicit OnGpu(GpuAnimator animator) : animator_(std::move(animator)) {
    animator_.measure_frames(true);
  }

  FrameResult frame(const FrameInput& input, const Progress& progress) override {
    FrameResult result;
    result.unchanged = !animator_.frame(input, progress);
    if (!result.unchanged) {
      z_ = animator_.read_phases();
      result.phase_step = animator_.measure_now()->phase_step;
      result.milliseconds = milliseconds();
    }
    result.z = z_;
    result.frequencies = animator_.frequencies();
    result.frequency_change = animator_.frequency_change();
    return result;
  }

  double topology_milliseconds() const override { return animator_.topology_milliseconds(); }
  unsigned phase_buffer() const override { return animator_.phases(); }

 private:
  FrameMilliseconds milliseconds() const {
    FrameMilliseconds sum;
    for (const auto& [stage, time] : animator_.stage_milliseconds()) {
      if (stage == "measure") continue;
      (stage == "load" || stage == "couple" ? sum.couple
       : stage == "sums"                    ? sum.sum
                                            : sum.solve) += time;
    }
    return sum;
  }

  GpuAnimator animator_;
  std::vector<Complex> z_;
};

}  // namespace

struct Device::Gpu::State {
  HeadlessContext context;
  GpuSolver solver;
};

Device::Gpu::Gpu() : state_(std::make_unique<State>()) {}
Device::Gpu::~Gpu() = default;

SolvePhases Device::Gpu::solver() const {
  return [this](const PhaseGraph& graph, const SolverOptions& options, const Progress& progress,
                const SolverData& /*data*/) {
    PhaseSolution solution = state_->solver.solve(graph, options, progress);
    check_errors("solving on the GPU");
    return solution;
  };
}

std::unique_ptr<Animator> Device::Gpu::animator(const Surface& surface,
                                                const AnimatorOptions& options) const {
  return std::make_unique<OnGpu>(GpuAnimator(state_->solver.kernels(), surface, options));
}

std::shared_ptr<const GpuKernels> Device::Gpu::kernels() const { return state_->solver.kernels(); }

void Device::Gpu::check_errors(const std::string& job) const { state_->context.check_errors(job); }

nlohmann::ordered_json Device::Gpu::description() const {
  const GlDevice device = gl_device();
  nlohmann::ordered_json json = {{"kind", "gpu"},
                                 {"renderer", device.renderer},
                                 {"vendor", device.vendor},
                                 {"version", device.version}};
  for (const auto& [name, value] : device.limits) json["limits"][name] = value;
  return json;
}

}  // namespace brindle::tool
