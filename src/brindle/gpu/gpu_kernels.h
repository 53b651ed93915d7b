/// The compute shaders of the solvers (shaders/).
#pragma once

#include <cstddef>

#include "brindle/gl/shader_program.h"
#include "brindle/gpu_solver.h"

namespace brindle {

/// Where buffers are bound (shaders/levels.glsl, couplings.glsl and so on). A shader sees no more
/// than eight, as many as every device has: some places have several uses.
enum GpuBinding : unsigned {
  kTopologyBinding,
  kNeighborBinding,
  kDirectBinding,
  kReflectingBinding,
  kRowBinding,
  kGaugeBinding,
  kPhaseBinding,
  kScratchBinding
};

/// Compiled once for all that is solved in a context. Each member runs the file of its name.
struct GpuKernels {
  /// Compiles in the OpenGL 4.5 context that is current; that or one that shares its objects must
  /// be current whenever the kernels are used or destroyed. Throws Error, naming shader file and
  /// line, if the driver does not take one.
  GpuKernels();

  ShaderProgram load_waves;
  ShaderProgram couple;
  ShaderProgram couple_common_source;
  ShaderProgram gauges;
  ShaderProgram gauge_rows;
  ShaderProgram sums;
  ShaderProgram keep_phases;
  ShaderProgram renew_small;
  ShaderProgram descend_small;
  ShaderProgram prolong;
  ShaderProgram sweep;
  ShaderProgram follow_phases;
  ShaderProgram relax;
  ShaderProgram judge_iteration;
  ShaderProgram to_nodes;
  ShaderProgram measure;
  ShaderProgram sum_parts;

  /// Invocations of a group, except in shaders that run as one group.
  static constexpr std::size_t kGroupSize = 64;
};

/// The groups of a dispatch: as many as one dimension takes, then a second one.
struct GpuGroups {
  unsigned x, y;

  static GpuGroups of(std::size_t invocations);
  std::size_t count() const { return std::size_t{x} * y; }
};

/// Runs a kernel with at least so many invocations; what it writes is seen by all that follows.
/// `dispatch_one_group` runs a kernel that is one group, `dispatch_indirect` as many groups as
/// `commands` holds at a place.
void dispatch(const ShaderProgram& kernel, std::size_t invocations);
void dispatch_one_group(const ShaderProgram& kernel);
void dispatch_indirect(const ShaderProgram& kernel, unsigned commands, std::size_t place);

/// How often these were called so far, on this thread.
std::size_t dispatch_count();

/// Binds a buffer by its name.
void bind_storage(unsigned binding, unsigned buffer);

}  // namespace brindle
