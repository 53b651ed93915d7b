#include "brindle/gpu/gpu_kernels.h"

#include <epoxy/gl.h>

namespace brindle {
namespace {

/// The limit of groups per dimension that every device supports.
constexpr std::size_t kMostGroups = 65535;

/// For shaders whose invocations read couplings and gauges written by others.
constexpr const char* kCoherent = "#define BETWEEN_INVOCATIONS coherent restrict\n";
constexpr const char* kPhasesInGroup = "#define PHASES_IN_GROUP\n";

thread_local std::size_t dispatches = 0;

/// A kernel with one or several invocations per slot of a level.
ShaderProgram kernel(const ShaderSources& sources) {
  ShaderSources all{"invocation.glsl", "complex.glsl", "levels.glsl"};
  all.insert(all.end(), sources.begin(), sources.end());
  return ShaderProgram::compute(all);
}

void run(const ShaderProgram& kernel, GpuGroups groups) {
  glUseProgram(kernel.name());
  glDispatchCompute(groups.x, groups.y, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  ++dispatches;
}

}  // namespace

GpuKernels::GpuKernels()
    : load_waves(kernel({"wave.glsl", "load_waves.comp"})),
      couple(kernel({"couplings.glsl", "wave.glsl", "smooth_shift.glsl", "couple.comp"})),
      couple_common_source(
          kernel({"couplings.glsl", "wave.glsl", "common_source_shift.glsl", "couple.comp"})),
      gauges(kernel(
          {"couplings.glsl", "gauge_buffers.glsl", "gauge.glsl", "work.glsl", "gauges.comp"})),
      gauge_rows(kernel(
          {"couplings.glsl", "gauge_buffers.glsl", "gauge.glsl", "work.glsl", "gauge_rows.comp"})),
      sums(
          kernel({"couplings.glsl", "gauge_buffers.glsl", "gauge.glsl", "work.glsl", "sums.comp"})),
      keep_phases(
          kernel({"gauge_buffers.glsl", "phase_buffer.glsl", "work.glsl", "keep_phases.comp"})),
      renew_small(ShaderProgram::compute({"one_group.glsl",
                                          {"coherent", kCoherent},
                                          "complex.glsl",
                                          "levels.glsl",
                                          "couplings.glsl",
                                          "gauge_buffers.glsl",
                                          "gauge.glsl",
                                          "renew_small.comp"})),
      descend_small(ShaderProgram::compute({"one_group.glsl",
                                            "complex.glsl",
                                            "levels.glsl",
                                            "couplings.glsl",
                                            "gauge_buffers.glsl",
                                            {"phases", kPhasesInGroup},
                                            "phase_buffer.glsl",
                                            "sweep.glsl",
                                            "descend_small.comp"})),
      prolong(kernel({"gauge_buffers.glsl", "phase_buffer.glsl", "work.glsl", "prolong.comp"})),
      sweep(
          kernel({"couplings.glsl", "phase_buffer.glsl", "sweep.glsl", "work.glsl", "sweep.comp"})),
      follow_phases(kernel({"wave.glsl", "phase_buffer.glsl", "follow_phases.comp"})),
      relax(kernel({"couplings.glsl", "phase_buffer.glsl", "sweep.glsl", "work.glsl",
                    "group_sum.glsl", "relax.comp"})),
      judge_iteration(
          ShaderProgram::compute({"one_group.glsl", "group_sum.glsl", "judge_iteration.comp"})),
      to_nodes(kernel({"phase_buffer.glsl", "to_nodes.comp"})),
      measure(kernel(
          {"couplings.glsl", "phase_buffer.glsl", "sweep.glsl", "group_sum.glsl", "measure.comp"})),
      sum_parts(ShaderProgram::compute({"one_group.glsl", "group_sum.glsl", "sum_parts.comp"})) {}

GpuGroups GpuGroups::of(std::size_t invocations) {
  const std::size_t wanted = (invocations + GpuKernels::kGroupSize - 1) / GpuKernels::kGroupSize;
  const std::size_t rows = (wanted + kMostGroups - 1) / kMostGroups;
  const std::size_t row = rows > 0 ? (wanted + rows - 1) / rows : 0;
  return {static_cast<unsigned>(row), static_cast<unsigned>(rows)};
}

void dispatch(const ShaderProgram& kernel, std::size_t invocations) {
  const GpuGroups groups = GpuGroups::of(invocations);
  if (groups.count() > 0) run(kernel, groups);
}

void dispatch_one_group(const ShaderProgram& kernel) { run(kernel, {1, 1}); }

void dispatch_indirect(const ShaderProgram& kernel, unsigned commands, std::size_t place) {
  glUseProgram(kernel.name());
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, commands);
  glDispatchComputeIndirect(static_cast<GLintptr>(place));
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  ++dispatches;
}

std::size_t dispatch_count() { return dispatches; }

void bind_storage(unsigned binding, unsigned buffer) {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer);
}

std::shared_ptr<const GpuKernels> make_gpu_kernels() {
  return std::make_shared<const GpuKernels>();
}

}  // namespace brindle
