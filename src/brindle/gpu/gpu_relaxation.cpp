#include "brindle/gpu/gpu_relaxation.h"

#include <array>
#include <cstddef>
#include <cstring>

#include "brindle/gl/gl_buffer.h"
#include "brindle/gpu/gpu_kernels.h"

namespace brindle {
namespace {

constexpr unsigned kRelaxationBinding = 0;
constexpr unsigned kCommandBinding = 1;
constexpr unsigned kMomentumBinding = kGaugeBinding;
constexpr unsigned kPartBinding = kScratchBinding;

/// Bindings of follow_phases.comp in addition to those of the levels.
enum FollowBinding : unsigned { kFollowedWaves = 1, kFollowedLastWaves = 2, kFollowedPhases = 3 };

/// Uniform locations of relax.comp and judge_iteration.comp.
enum RelaxLocation : GLint { kStrength = 3, kFirstPart = 4 };
enum JudgeLocation : GLint { kPartCount = 0, kCommandCount = 1, kEpsilon = 2 };

using Command = std::array<GLuint, 3>;

}  // namespace

GpuRelaxation::GpuRelaxation(const GpuHierarchy& hierarchy, float strength) : strength_(strength) {
  std::vector<Command> commands;
  first_part_.push_back(0);
  for (const GpuTopology::Color& color : hierarchy.topology().colors(0)) {
    const GpuGroups groups = GpuGroups::of(color.slot_count);
    commands.push_back({groups.x, groups.y, 1});
    first_part_.push_back(first_part_.back() + static_cast<std::uint32_t>(groups.count()));
  }
  commands_ = buffer_of(commands, "dispatches");
  parts_ = make_buffer((first_part_.back() + 1) * sizeof(std::array<float, 4>), nullptr, "sums");
  momenta_ =
      make_buffer(hierarchy.topology().level(0).slot_count * sizeof(Complex), nullptr, "momenta");
}

void GpuRelaxation::clear() const {
  if (momenta_ == 0) return;
  glClearNamedBufferData(momenta_, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

void GpuRelaxation::follow(const GpuHierarchy& hierarchy, unsigned phases, unsigned last_waves,
                           unsigned waves) const {
  hierarchy.bind();
  bind_storage(kFollowedWaves, waves);
  bind_storage(kFollowedLastWaves, last_waves);
  bind_storage(kFollowedPhases, phases);
  bind_storage(kMomentumBinding, momenta_);
  dispatch(hierarchy.kernels().follow_phases, hierarchy.topology().level(0).slot_count);
}

void GpuRelaxation::iterate(const GpuHierarchy& hierarchy, std::size_t colors) const {
  hierarchy.bind();
  bind_storage(kMomentumBinding, momenta_);
  bind_storage(kPartBinding, parts_);
  const ShaderProgram& kernel = hierarchy.kernels().relax;
  glProgramUniform1f(kernel.name(), kStrength, strength_);
  for (std::size_t c = 0; c < colors; ++c) {
    set_color(kernel, hierarchy.topology().colors(0)[c]);
    glProgramUniform1ui(kernel.name(), kFirstPart, first_part_[c]);
    dispatch_indirect(kernel, commands_, c * sizeof(Command));
  }
}

void GpuRelaxation::begin(double energy, double weight, int max_iterations) {
  std::vector<std::byte> start(sizeof(Standing) +
                               (max_iterations + std::size_t{1}) * sizeof(float));
  const Standing standing{0, 0, static_cast<float>(weight)};
  const auto first = static_cast<float>(energy);
  std::memcpy(start.data(), &standing, sizeof standing);
  std::memcpy(start.data() + sizeof standing, &first, sizeof first);
  relaxation_ = buffer_of(start, "energies");
}

void GpuRelaxation::judge(const GpuHierarchy& hierarchy, std::size_t colors, float epsilon) const {
  const ShaderProgram& kernel = hierarchy.kernels().judge_iteration;
  bind_storage(kRelaxationBinding, relaxation_);
  bind_storage(kCommandBinding, commands_);
  bind_storage(kPartBinding, parts_);
  glProgramUniform1ui(kernel.name(), kPartCount, first_part_[colors]);
  glProgramUniform1ui(kernel.name(), kCommandCount, static_cast<GLuint>(first_part_.size() - 1));
  glProgramUniform1f(kernel.name(), kEpsilon, epsilon);
  dispatch_one_group(kernel);
}

GpuRelaxation::Standing GpuRelaxation::standing() const {
  Standing standing;
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glGetNamedBufferSubData(relaxation_, 0, sizeof standing, &standing);
  return standing;
}

std::vector<float> GpuRelaxation::energies() const {
  std::vector<float> energies(standing().iterations + std::size_t{1});
  glGetNamedBufferSubData(relaxation_, sizeof(Standing),
                          static_cast<GLsizeiptr>(energies.size() * sizeof(float)),
                          energies.data());
  return energies;
}

}  // namespace brindle
