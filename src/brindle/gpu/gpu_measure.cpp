#include "brindle/gpu/gpu_measure.h"

#include <array>

#include "brindle/error.h"
#include "brindle/gl/gl_buffer.h"
#include "brindle/gpu/gpu_kernels.h"
#include "brindle/waves/energy_sums.h"

namespace brindle {
namespace {

constexpr unsigned kResultBinding = 0;
constexpr unsigned kLastPhaseBinding = kGaugeBinding;
constexpr GLint kSumPartCount = 0;
constexpr GLint kResultNumber = 1;

using Sums = std::array<float, 4>;  // energy, weight, angle, count

}  // namespace

/// Results are in persistently mapped memory; a fence signals that one has been written.
struct GpuMeasure::State {
  std::size_t part_count;
  GlBuffer parts, results;
  const volatile Sums* mapped;
  std::array<GlFence, 2> fences;
  unsigned begun = 0, ended = 0;
};

GpuMeasure::GpuMeasure(const GpuHierarchy& hierarchy) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.part_count = GpuGroups::of(hierarchy.topology().level(0).slot_count).count();
  s.parts = make_buffer((s.part_count + 1) * sizeof(Sums), nullptr, "parts of sums");
  constexpr GLbitfield kAccess = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
  s.results = make_buffer(2 * sizeof(Sums), nullptr, "sums", kAccess);
  s.mapped =
      static_cast<const Sums*>(glMapNamedBufferRange(s.results, 0, 2 * sizeof(Sums), kAccess));
  check_gl("mapping a buffer");
}

GpuMeasure::~GpuMeasure() = default;
GpuMeasure::GpuMeasure(GpuMeasure&&) noexcept = default;

void GpuMeasure::begin(const GpuHierarchy& hierarchy, GLuint last_phases) {
  State& s = *state_;
  if (s.begun - s.ended == s.fences.size()) throw Error("two measurements are under way already");
  const GpuKernels& kernels = hierarchy.kernels();
  hierarchy.bind();
  bind_storage(kLastPhaseBinding, last_phases);
  bind_storage(kScratchBinding, s.parts);
  dispatch(kernels.measure, hierarchy.topology().level(0).slot_count);
  bind_storage(kResultBinding, s.results);
  glProgramUniform1ui(kernels.sum_parts.name(), kSumPartCount, static_cast<GLuint>(s.part_count));
  glProgramUniform1ui(kernels.sum_parts.name(), kResultNumber, s.begun % 2);
  dispatch_one_group(kernels.sum_parts);
  glMemoryBarrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
  s.fences[s.begun % 2].set();
  ++s.begun;
}

std::optional<PhaseMeasure> GpuMeasure::end() {
  State& s = *state_;
  if (s.begun == s.ended) return std::nullopt;
  s.fences[s.ended % 2].await();
  const volatile float* sums = reinterpret_cast<const volatile float*>(s.mapped + s.ended % 2);
  const EnergySums energies{sums[0], sums[1]};
  const double angle = sums[2], count = sums[3];
  ++s.ended;
  return PhaseMeasure{energies.relative(), energies.weight, count > 0 ? angle / count : 0};
}

}  // namespace brindle
