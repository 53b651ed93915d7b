/// The compute shaders of the solvers (shaders/).
#pragma once

#include <cstddef>

#include "brindle/gl/shader_program.h"
#include "brindle/gpu_solver.h"

namespace brindle {

/// Bindings of buffers (shaders/levels.glsl, couplings.glsl and so on). Shaders use at most eight,
/// which every device supports, so that some bindings are reused.
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

/// Compiled once per context. Each member runs the file of its name.
struct GpuKernels {
  /// Compiles in the current OpenGL 4.5 context; that or one that shares its objects must be
  /// current when the kernels are used or destroyed. Throws Error with shader file and line if the
  /// driver rejects one.
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

  /// Invocations per group, except in shaders with a single group.
  static constexpr std::size_t kGroupSize = 64;
};

/// The groups of a dispatch, in two dimensions if one is too small.
struct GpuGroups {
  unsigned x, y;

  static GpuGroups of(std::size_t invocations);
  std::size_t count() const { return std::size_t{x} * y; }
};

/// Run a kernel, with a barrier for its writes: `dispatch` with at least `invocations` invocations,
/// `dispatch_one_group` with one group, `dispatch_indirect` with the number of groups at a position
/// of `commands`.
void dispatch(const ShaderProgram& kernel, std::size_t invocations);
void dispatch_one_group(const ShaderProgram& kernel);
void dispatch_indirect(const ShaderProgram& kernel, unsigned commands, std::size_t place);

/// The number of dispatches so far, on this thread.
std::size_t dispatch_count();

/// Binds a buffer by its name.
void bind_storage(unsigned binding, unsigned buffer);

}  // namespace brindle
