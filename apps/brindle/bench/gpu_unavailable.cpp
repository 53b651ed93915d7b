#include "bench/draw_measurements.h"
#include "bench/gpu_measurements.h"
#include "brindle/error.h"
#include "input/gpu.h"

namespace brindle::tool {

struct Device::Gpu::State {};

Device::Gpu::Gpu() {
  throw Error(
      "this build solves on the processor alone; configure with -DBRINDLE_GL=ON to have --device "
      "gpu");
}

Device::Gpu::~Gpu() = default;

SolvePhases Device::Gpu::solver() const { return {}; }

std::unique_ptr<Animator> Device::Gpu::animator(const Surface& /*surface*/,
                                                const AnimatorOptions& /*options*/) const {
  return nullptr;
}

std::shared_ptr<const GpuKernels> Device::Gpu::kernels() const { return nullptr; }

void Device::Gpu::check_errors(const std::string& /*job*/) const {}

nlohmann::ordered_json Device::Gpu::description() const { return {}; }

GpuFrameFigures measure_gpu_frames(const Device& /*device*/, const Subject& /*subject*/,
                                   const Repetitions& /*repetitions*/,
                                   const Progress& /*progress*/) {
  return {};
}

DrawFigures measure_draw(const Subject& /*subject*/, int /*width*/, int /*height*/,
                         const Repetitions& /*repetitions*/, const Progress& /*progress*/) {
  throw Error("this build draws no pictures; configure with -DBRINDLE_GL=ON to have them");
}

double copy_bandwidth() { return 0; }

}  // namespace brindle::tool
