#include "device/device.h"

#include <optional>
#include <string_view>
#include <utility>

#include "brindle/gpu_animator.h"
#include "brindle/gpu_solver.h"
#include "brindle/headless_context.h"
#include "cli/option_values.h"

namespace brindle::tool {
namespace {

class OnProcessor : public Animator {
 public:
  explicit OnProcessor(StripeAnimator animator) : animator_(std::move(animator)) {}

  FrameResult frame(const FrameInput& input, const Progress& progress) override {
    return animator_.frame(input, progress);
  }
  double topology_milliseconds() const override { return animator_.topology_milliseconds(); }

 private:
  StripeAnimator animator_;
};

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

struct Device::Gpu {
  HeadlessContext context;
  GpuSolver solver;
};

bool has_solver(DeviceKind device, Solver solver) {
  return device == DeviceKind::cpu || is_available_on_gpu(solver);
}

void check_solver(DeviceKind device, const SolverOptions& options) {
  if (!has_solver(device, options.solver)) {
    throw CLI::ValidationError("--device", "the GPU solves by multilevel or relaxation, not by " +
                                               std::string(name_of(options.solver)));
  }
  if (device == DeviceKind::gpu && options.solver != Solver::multilevel && options.cycles > 0) {
    throw CLI::ValidationError("--cycles",
                               "the GPU has cycles for multilevel alone; solve on the processor");
  }
}

Device::Device(DeviceKind kind) {
  if (kind == DeviceKind::gpu) gpu_ = std::make_unique<Gpu>();
}

Device::~Device() = default;

SolvePhases Device::solver() const {
  if (!gpu_) return {};
  return [gpu = gpu_.get()](const PhaseGraph& graph, const SolverOptions& options,
                            const Progress& progress, const SolverData& /*data*/) {
    PhaseSolution solution = gpu->solver.solve(graph, options, progress);
    gpu->context.check_errors("solving on the GPU");
    return solution;
  };
}

std::unique_ptr<Animator> Device::animator(const Surface& surface,
                                           const AnimatorOptions& options) const {
  if (!gpu_) return std::make_unique<OnProcessor>(StripeAnimator(surface, options));
  return std::make_unique<OnGpu>(GpuAnimator(gpu_->solver.kernels(), surface, options));
}

void Device::check_errors(const std::string& job) const {
  if (gpu_) gpu_->context.check_errors(job);
}

nlohmann::ordered_json Device::description() const {
  if (!gpu_) return nlohmann::ordered_json{{"kind", "cpu"}};
  const GlDevice device = gl_device();
  nlohmann::ordered_json json = {{"kind", "gpu"},
                                 {"renderer", device.renderer},
                                 {"vendor", device.vendor},
                                 {"version", device.version}};
  for (const auto& [name, value] : device.limits) json["limits"][name] = value;
  return json;
}

}  // namespace brindle::tool
