/// An OpenGL context and its solvers. The constructor throws in builds without OpenGL.
#pragma once

#include <memory>
#include <string>

#include "device/device.h"

namespace brindle {
struct GpuKernels;
}

namespace brindle::tool {

struct Device::Gpu {
  Gpu();
  ~Gpu();

  SolvePhases solver() const;
  std::unique_ptr<Animator> animator(const Surface& surface, const AnimatorOptions& options) const;
  std::shared_ptr<const GpuKernels> kernels() const;
  void check_errors(const std::string& job) const;
  nlohmann::ordered_json description() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace brindle::tool
