/// Where phases are solved: on the processor, or on what OpenGL works on. A build without OpenGL
/// refuses the latter.
#pragma once

#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"

namespace brindle::tool {

enum class DeviceKind { cpu, gpu };  // the words of --device

/// Whether the device has the solver.
bool has_solver(DeviceKind device, Solver solver);

/// Throws CLI::ValidationError if it does not, or not with these options.
void check_solver(DeviceKind device, const SolverOptions& options);

/// Follows changing input, wherever that is done.
class Animator {
 public:
  virtual ~Animator() = default;

  /// As StripeAnimator's.
  virtual FrameResult frame(const FrameInput& input, const Progress& progress) = 0;
  virtual double topology_milliseconds() const = 0;

  /// Name of the OpenGL buffer that the last frame's phases lie in, too; 0 for none.
  virtual unsigned phase_buffer() const { return 0; }
};

/// A device while a command runs.
class Device {
 public:
  /// On the processor there is nothing to it. Throws Error, naming what was found, if no OpenGL 4.5
  /// context is to be had.
  explicit Device(DeviceKind kind);
  ~Device();

  SolvePhases solver() const;
  std::unique_ptr<Animator> animator(const Surface& surface, const AnimatorOptions& options) const;

  /// Whether an OpenGL context of its own is current.
  bool has_context() const { return gpu_ != nullptr; }

  /// Throws Error with everything that OpenGL has complained of.
  void check_errors(const std::string& job) const;

  /// `{"kind": "cpu"}`, or kind, renderer, vendor, version and limits of the GPU.
  nlohmann::ordered_json description() const;

  struct Gpu;

  /// Nothing on the processor.
  const Gpu* gpu() const { return gpu_.get(); }

 private:
  std::unique_ptr<Gpu> gpu_;
};

}  // namespace brindle::tool
