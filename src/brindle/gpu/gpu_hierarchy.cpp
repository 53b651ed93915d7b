#include "brindle/gpu/gpu_hierarchy.h"

#include <cmath>
#include <utility>

#include "brindle/base/parallel.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/gpu/gpu_kernels.h"
#include "brindle/phases/sliced_kernels.h"

namespace brindle {
namespace {

/// Uniform locations of the shaders.
enum Location : GLint { kLevel = 0, kSlices = 1, kWorkCount = 2, kOverRelaxation = 3 };
enum SmallLocation : GLint { kFirstLevel = 0, kRenewsGauges = 1, kStart = 1 };

/// Invocations per row (kParts of shaders/gauge.glsl).
constexpr std::size_t kPartsOfRow = 8;

/// `Row` of shaders/couplings.glsl.
struct Row {
  Complex anchor = 0;
  float degree = 0;
  std::uint32_t reflects = 0;
};

template <class Item>
void overwrite(const GlBuffer& buffer, const std::vector<Item>& items) {
  glNamedBufferSubData(buffer, 0, static_cast<GLsizeiptr>(items.size() * sizeof(Item)),
                       items.data());
}

/// A buffer filled with a complex number.
GlBuffer buffer_filled_with(Complex value, std::size_t count, const char* what) {
  const std::vector<Complex> values(count, value);
  return make_buffer(count * sizeof(Complex), values.data(), what, GL_DYNAMIC_STORAGE_BIT);
}

/// The rows of a level, with its matrix B if it has one.
struct UploadedRows {
  std::vector<Row> rows;
  std::vector<Complex> reflecting;
};

UploadedRows rows_of(const SlicedLayout& layout, const SlicedCouplings& couplings) {
  UploadedRows result;
  result.rows.resize(layout.slot_count());
  for (Index slice = 0; slice < layout.slice_count(); ++slice) {
    const auto list = couplings.reflecting_of(layout, slice);
    if (!list.empty()) result.reflecting.resize(layout.entry_count());
    for (const auto& [entry, b] : list) {
      result.reflecting[entry] = b;
      result.rows[slice * kLanes + entry % kLanes].reflects = 1;
    }
  }
  parallel_for(result.rows.size(), [&](std::size_t begin, std::size_t end) {
    for (Index slot = static_cast<Index>(begin); slot < end; ++slot) {
      Row& row = result.rows[slot];
      if (!couplings.anchor.empty()) row.anchor = couplings.anchor[slot];
      std::size_t entry = layout.first_entry(slot);
      for (Index k = 0; k < layout.width(slot); ++k, entry += kLanes) {
        row.degree += std::sqrt(std::norm(couplings.direct_at(entry)));
        if (row.reflects) row.degree += std::sqrt(std::norm(result.reflecting[entry]));
      }
    }
  });
  return result;
}

}  // namespace

GpuHierarchy::GpuHierarchy(std::shared_ptr<const GpuKernels> kernels,
                           std::shared_ptr<const GpuTopology> topology)
    : kernels_(std::move(kernels)), topology_(std::move(topology)) {
  const std::size_t entries = topology_->entry_count(), slots = topology_->slot_count();
  direct_ = make_buffer(entries * sizeof(Complex), nullptr, "couplings", GL_DYNAMIC_STORAGE_BIT);
  reflecting_ =
      make_buffer(entries * sizeof(Complex), nullptr, "couplings", GL_DYNAMIC_STORAGE_BIT);
  rows_ = make_buffer(slots * sizeof(Row), nullptr, "rows", GL_DYNAMIC_STORAGE_BIT);
  z_ = buffer_filled_with(kPeak, slots + 1, "phases");
  if (topology_->level_count() == 1) return;
  gauges_ = buffer_filled_with(with_conjugate_bit(1, false), slots, "gauges");
  gauged_ = make_buffer(2 * topology_->finest_entries() * sizeof(Complex), nullptr, "scratch");
}

void GpuHierarchy::upload(const SlicedLayout& layout, const SlicedCouplings& couplings) {
  std::vector<Complex> direct(layout.entry_count());
  parallel_for(direct.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t entry = begin; entry < end; ++entry)
      direct[entry] = couplings.direct_at(entry);
  });
  const UploadedRows uploaded = rows_of(layout, couplings);
  if (!direct.empty()) overwrite(direct_, direct);
  if (!uploaded.reflecting.empty()) overwrite(reflecting_, uploaded.reflecting);
  if (!uploaded.rows.empty()) overwrite(rows_, uploaded.rows);
}

void GpuHierarchy::upload_phases(std::span<const Complex> z) {
  glNamedBufferSubData(z_, 0, static_cast<GLsizeiptr>(z.size_bytes()), z.data());
}

void GpuHierarchy::solve(StageTimer* timer) const {
  bind();
  renew_large(true);
  renew_small(true);
  if (timer) timer->stage("sums");
  descend_small(kPeak);
  if (timer) timer->stage("small levels");
  descend_large(kPeak);
  if (timer) timer->stage("sweeps");
}

void GpuHierarchy::run_cycles(int cycles, const Progress& progress) const {
  if (cycles == 0) return;
  // Gauges of references are not recomputed by the next solve, so they are reset to 1 even if
  // cycles end early.
  struct Reset {
    const GpuHierarchy& hierarchy;
    ~Reset() { hierarchy.reset_gauges(); }
  };
  const Reset reset{*this};
  for (int cycle = 0; cycle < cycles; ++cycle) {
    progress.report("cycles", static_cast<double>(cycle) / cycles);
    correct();
  }
}

void GpuHierarchy::reset_gauges() const {
  if (topology_->level_count() == 1) return;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  const Complex one = with_conjugate_bit(1, false);
  glClearNamedBufferSubData(gauges_, GL_RG32F, 0, topology_->level(0).slot_count * sizeof(Complex),
                            GL_RG, GL_FLOAT, &one);
}

/// One cycle.
void GpuHierarchy::correct() const {
  bind();
  for (std::size_t l = 0; l + 1 < topology_->level_count(); ++l) {
    dispatch_on_level(kernels_->keep_phases, l, topology_->level(l).slot_count);
  }
  renew_large(false);
  renew_small(false);
  descend_small(Complex(1));
  descend_large(Complex(1));
}

void GpuHierarchy::bind() const {
  topology_->bind();
  bind_storage(kDirectBinding, direct_);
  bind_storage(kReflectingBinding, reflecting_);
  bind_storage(kRowBinding, rows_);
  bind_storage(kGaugeBinding, gauges_);
  bind_storage(kPhaseBinding, z_);
  bind_storage(kScratchBinding, gauged_);
}

void GpuHierarchy::dispatch_on_level(const ShaderProgram& kernel, std::size_t level,
                                     std::size_t invocations) const {
  glProgramUniform1ui(kernel.name(), kLevel, static_cast<GLuint>(level));
  dispatch(kernel, invocations);
}

void GpuHierarchy::renew_large(bool renews_gauges) const {
  for (std::size_t l = 0; l < topology_->first_small_sums(); ++l) {
    if (l + 1 == topology_->level_count()) return;
    const std::size_t slots = topology_->level(l).slot_count;
    const std::size_t aggregates = topology_->level(l + 1).slot_count;
    if (renews_gauges) dispatch_on_level(kernels_->gauges, l, aggregates);
    dispatch_on_level(kernels_->gauge_rows, l, kPartsOfRow * slots);
    dispatch_on_level(kernels_->sums, l, kPartsOfRow * aggregates);
  }
}

void GpuHierarchy::renew_small(bool renews_gauges) const {
  const std::size_t first = topology_->first_small_sums();
  if (first + 1 >= topology_->level_count()) return;
  const GLuint kernel = kernels_->renew_small.name();
  glProgramUniform1ui(kernel, kFirstLevel, static_cast<GLuint>(first));
  glProgramUniform1i(kernel, kRenewsGauges, renews_gauges ? 1 : 0);
  dispatch_one_group(kernels_->renew_small);
}

void GpuHierarchy::descend_small(Complex start) const {
  if (topology_->first_small_level() == topology_->level_count()) return;
  const GLuint kernel = kernels_->descend_small.name();
  glProgramUniform1ui(kernel, kFirstLevel, static_cast<GLuint>(topology_->first_small_level()));
  glProgramUniform2f(kernel, kStart, start.real(), start.imag());
  dispatch_one_group(kernels_->descend_small);
}

void GpuHierarchy::descend_large(Complex start) const {
  for (std::size_t l = topology_->first_small_level(); l-- > 0;) {
    const FlatLevel& level = topology_->level(l);
    if (l + 1 == topology_->level_count()) {
      glClearNamedBufferSubData(z_, GL_RG32F, level.first_slot * sizeof(Complex),
                                level.slot_count * sizeof(Complex), GL_RG, GL_FLOAT, &start);
    } else {
      dispatch_on_level(kernels_->prolong, l, level.slot_count);
    }
    const LevelSweeps planned = level.planned_sweeps();
    for (int number = 0; number < planned.count; ++number) {
      sweep(l, planned.over_relaxation_of(number));
    }
  }
}

void GpuHierarchy::sweep(std::size_t l, float over_relaxation) const {
  glProgramUniform1f(kernels_->sweep.name(), kOverRelaxation, over_relaxation);
  for (const GpuTopology::Color& color : topology_->colors(l)) {
    set_color(kernels_->sweep, color);
    dispatch_on_level(kernels_->sweep, l, color.slot_count);
  }
}

std::vector<Complex> GpuHierarchy::read_phases() const {
  std::vector<Complex> z(topology_->level(0).slot_count);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(z_, 0, static_cast<GLsizeiptr>(z.size() * sizeof(Complex)), z.data());
  return z;
}

void set_color(const ShaderProgram& kernel, const GpuTopology::Color& color) {
  glProgramUniform1ui(kernel.name(), kSlices, color.slices);
  glProgramUniform1ui(kernel.name(), kWorkCount, color.slot_count);
}

}  // namespace brindle
