/// The multilevel solver on the device (twin of phases/hierarchy.h and phases/multilevel.h).
#pragma once

#include <memory>
#include <span>

#include "brindle/gl/gl_name.h"
#include "brindle/gpu/gpu_kernels.h"
#include "brindle/gpu/gpu_topology.h"
#include "brindle/gpu/stage_trace.h"
#include "brindle/progress.h"

namespace brindle {

/// Buffers of couplings, gauges and phases of all levels.
class GpuHierarchy {
 public:
  /// Throws Error if a buffer exceeds the driver's limit or OpenGL is out of memory.
  GpuHierarchy(std::shared_ptr<const GpuKernels> kernels,
               std::shared_ptr<const GpuTopology> topology);

  /// Uploads couplings and anchors of the finest level; `layout` is that of the topology.
  void upload(const SlicedLayout& layout, const SlicedCouplings& couplings);

  /// Uploads phases of the finest level, one per slot.
  void upload_phases(std::span<const Complex> z);

  /// Recomputes all gauges and sums from the couplings of the finest level and descends to it
  /// (`renew`, then `descend`). Stages: "sums", "small levels", "sweeps".
  void solve(StageTimer* timer = nullptr) const;

  /// Further descents, each from the phases of the finest level (twin of `run_cycles` of
  /// phases/multilevel.h). Throws Cancelled.
  void run_cycles(int cycles, const Progress& progress) const;

  /// Binds all buffers of the levels.
  void bind() const;

  /// The present phases of the finest level, by slot. Waits for the device.
  std::vector<Complex> read_phases() const;

  const GpuKernels& kernels() const { return *kernels_; }
  const GpuTopology& topology() const { return *topology_; }

  /// Buffer names, for kernels with other bindings.
  GLuint phases() const { return z_; }

 private:
  void correct() const;
  void reset_gauges() const;
  void renew_large(bool renews_gauges) const;
  void renew_small(bool renews_gauges) const;
  void descend_small(Complex start) const;
  void descend_large(Complex start) const;
  void sweep(std::size_t level, float over_relaxation) const;
  void dispatch_on_level(const ShaderProgram& kernel, std::size_t level,
                         std::size_t invocations) const;

  std::shared_ptr<const GpuKernels> kernels_;
  std::shared_ptr<const GpuTopology> topology_;
  GlBuffer direct_, reflecting_, rows_, gauges_, gauged_, z_;
};

/// Sets the colour of `sweep` and `relax`.
void set_color(const ShaderProgram& kernel, const GpuTopology::Color& color);

}  // namespace brindle
