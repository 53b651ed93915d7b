#include "brindle/base/error.h"
#include "gpu.h"

namespace brindle::tool {

struct Device::Gpu::State {};

Device::Gpu::Gpu() {
  throw Error(
      "this build solves on the processor alone; configure with -DBRINDLE_GL=ON to have --device "
      "gpu");
}

Device::Gpu::~Gpu() = default;

SolvePhases Device::Gpu::solver() const { return {}; }

std::unique_ptr<FrameSolverDevice> Device::Gpu::animator(
    std::shared_ptr<const Adjacency> /*neighborhood*/, const AnimatorOptions& /*options*/) const {
  return nullptr;
}

void Device::Gpu::check_errors(const std::string& /*job*/) const {}

nlohmann::ordered_json Device::Gpu::description() const { return {}; }

}  // namespace brindle::tool
