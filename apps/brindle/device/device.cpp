#include "device/device.h"

#include <optional>
#include <string_view>
#include <utility>

#include "brindle/gpu_solver.h"
#include "cli/option_values.h"
#include "device/gpu.h"

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

}  // namespace

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

SolvePhases Device::solver() const { return gpu_ ? gpu_->solver() : SolvePhases(); }

std::unique_ptr<Animator> Device::animator(const Surface& surface,
                                           const AnimatorOptions& options) const {
  if (gpu_) return gpu_->animator(surface, options);
  return std::make_unique<OnProcessor>(StripeAnimator(surface, options));
}

void Device::check_errors(const std::string& job) const {
  if (gpu_) gpu_->check_errors(job);
}

nlohmann::ordered_json Device::description() const {
  return gpu_ ? gpu_->description() : nlohmann::ordered_json{{"kind", "cpu"}};
}

}  // namespace brindle::tool
