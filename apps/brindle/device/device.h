/// The device that solves: the processor, or the GPU by OpenGL. Builds without OpenGL reject the
/// latter.
#pragma once

#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "brindle/stripe_animator.h"
#include "brindle/stripe_pattern.h"

namespace brindle::tool {

enum class DeviceKind { cpu, gpu };  // the choices of --device

/// Whether the device has the solver.
bool has_solver(DeviceKind device, Solver solver);

/// Throws CLI::ValidationError if it does not, or not with these options.
void check_solver(DeviceKind device, const SolverOptions& options);

/// An animator on either device.
class Animator {
 public:
  virtual ~Animator() = default;

  /// As StripeAnimator::frame.
  virtual FrameResult frame(const FrameInput& input, const Progress& progress) = 0;
  virtual double topology_milliseconds() const = 0;

  /// Name of the OpenGL buffer with a copy of the last frame's phases; 0 for none.
  virtual unsigned phase_buffer() const { return 0; }
};

/// The device of a running command.
class Device {
 public:
  /// No work for the processor. Throws Error with what was found if there is no OpenGL 4.5 context,
  /// or if the build has no OpenGL.
  explicit Device(DeviceKind kind);
  ~Device();

  /// Empty on the processor, which then solves as usual.
  SolvePhases solver() const;
  std::unique_ptr<Animator> animator(const Surface& surface, const AnimatorOptions& options) const;

  /// Whether its own OpenGL context is current.
  bool has_context() const { return gpu_ != nullptr; }

  /// Throws Error with all of OpenGL's error messages.
  void check_errors(const std::string& job) const;

  /// `{"kind": "cpu"}`, or the GPU's kind, renderer, vendor, version and limits.
  nlohmann::ordered_json description() const;

 private:
  struct Gpu;
  std::unique_ptr<Gpu> gpu_;  ///< null on the processor
};

}  // namespace brindle::tool
