#include "brindle/gpu/gpu_kernels.h"

#include <epoxy/gl.h>

namespace brindle {
namespace {

/// Every device takes so many groups in one dimension.
constexpr std::size_t kMostGroups = 65535;

thread_local std::size_t dispatches = 0;

void run(const ShaderProgram& kernel, GpuGroups groups) {
  glUseProgram(kernel.name());
  glDispatchCompute(groups.x, groups.y, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
  ++dispatches;
}

}  // namespace

GpuKernels::GpuKernels()
    : load_waves(ShaderProgram::compute(
          {"invocation.glsl", "complex.glsl", "levels.glsl", "wave.glsl", "load_waves.comp"})),
      couple(ShaderProgram::compute({"invocation.glsl", "levels.glsl", "couplings.glsl",
                                     "wave.glsl", "smooth_shift.glsl", "couple.comp"})),
      couple_common_source(
          ShaderProgram::compute({"invocation.glsl", "levels.glsl", "couplings.glsl", "wave.glsl",
                                  "common_source_shift.glsl", "couple.comp"})),
      gauges(ShaderProgram::compute({"invocation.glsl", "complex.glsl", "levels.glsl",
                                     "couplings.glsl", "gauge_buffers.glsl", "gauge.glsl",
                                     "level_work.glsl", "gauges.comp"})),
      gauge_rows(ShaderProgram::compute({"invocation.glsl", "complex.glsl", "levels.glsl",
                                         "couplings.glsl", "gauge_buffers.glsl", "gauge.glsl",
                                         "level_work.glsl", "gauge_rows.comp"})),
      sums(ShaderProgram::compute({"invocation.glsl", "complex.glsl", "levels.glsl",
                                   "couplings.glsl", "gauge_buffers.glsl", "gauge.glsl",
                                   "level_work.glsl", "sums.comp"})),
      keep_phases(ShaderProgram::compute({"invocation.glsl", "complex.glsl", "levels.glsl",
                                          "gauge_buffers.glsl", "phase_buffer.glsl",
                                          "level_work.glsl", "keep_phases.comp"})),
      renew_small(ShaderProgram::compute({"one_group.glsl", "await_group.glsl", "coherent.glsl",
                                          "complex.glsl", "levels.glsl", "couplings.glsl",
                                          "gauge_buffers.glsl", "gauge.glsl", "renew_small.comp"})),
      descend_small(ShaderProgram::compute({"one_group.glsl", "await_group.glsl", "complex.glsl",
                                            "levels.glsl", "couplings.glsl", "gauge_buffers.glsl",
                                            "phase_buffer.glsl", "phases_in_group.glsl",
                                            "sweep.glsl", "prolong.glsl", "descend_small.comp"})),
      prolong(ShaderProgram::compute({"invocation.glsl", "complex.glsl", "levels.glsl",
                                      "gauge_buffers.glsl", "phase_buffer.glsl", "prolong.glsl",
                                      "level_work.glsl", "prolong.comp"})),
      sweep(ShaderProgram::compute({"invocation.glsl", "complex.glsl", "levels.glsl",
                                    "couplings.glsl", "phase_buffer.glsl", "phases_in_buffer.glsl",
                                    "sweep.glsl", "level_work.glsl", "color_work.glsl",
                                    "sweep.comp"})),
      follow_phases(
          ShaderProgram::compute({"invocation.glsl", "complex.glsl", "levels.glsl", "wave.glsl",
                                  "phase_buffer.glsl", "follow_phases.comp"})),
      relax(ShaderProgram::compute({"invocation.glsl", "complex.glsl", "levels.glsl",
                                    "couplings.glsl", "phase_buffer.glsl", "phases_in_buffer.glsl",
                                    "sweep.glsl", "color_work.glsl", "parts.glsl", "group_sum.glsl",
                                    "relax.comp"})),
      judge_iteration(ShaderProgram::compute(
          {"one_group.glsl", "parts.glsl", "group_sum.glsl", "judge_iteration.comp"})),
      to_nodes(ShaderProgram::compute(
          {"invocation.glsl", "levels.glsl", "phase_buffer.glsl", "to_nodes.comp"})),
      measure(ShaderProgram::compute(
          {"invocation.glsl", "complex.glsl", "levels.glsl", "couplings.glsl", "phase_buffer.glsl",
           "phases_in_buffer.glsl", "sweep.glsl", "parts.glsl", "group_sum.glsl", "measure.comp"})),
      sum_parts(ShaderProgram::compute(
          {"one_group.glsl", "parts.glsl", "group_sum.glsl", "sum_parts.comp"})) {}

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
