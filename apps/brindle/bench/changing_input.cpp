#include "bench/changing_input.h"

#include <numbers>

#include "brindle/direction_field.h"

namespace brindle::tool {
namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180;
constexpr float kZoom = 1.01f;

}  // namespace

ChangingInput changing_input(const Surface& surface, const WaveSet& waves) {
  ChangingInput input{waves.positions,
                      {waves.directions, rotated(waves.directions, surface.normals, kDegree)},
                      {waves.frequencies, waves.frequencies}};
  for (float& frequency : input.frequencies[1]) frequency *= kZoom;
  return input;
}

std::vector<ChangingInput> changing_inputs(const Subject& subject) {
  std::vector<ChangingInput> inputs;
  for (const WaveSet& field : subject.fields) {
    inputs.push_back(changing_input(subject.surface, field));
  }
  return inputs;
}

void add(Quality& sum, double energy, const PatternQuality& quality, std::size_t fields) {
  const double share = 1 / static_cast<double>(fields);
  sum.energy += share * energy;
  sum.branches += quality.branches;
  sum.angle_error_mean_deg += share * quality.angle_error_mean_deg;
}

Quality quality_of(const Subject& subject, const std::vector<ChangingInput>& inputs, int number,
                   std::span<const std::vector<Complex>> z) {
  Quality quality;
  for (std::size_t field = 0; field < inputs.size(); ++field) {
    const WaveSet waves = inputs[field].waves(number);
    const PhaseGraph graph = build_phase_graph(subject.surface.neighborhood, waves);
    const auto corners =
        corner_phases(subject.surface.mesh.triangles, waves, z[field], PhaseShiftKind::aligned);
    add(quality, energy(graph, z[field]), measure_quality(subject.surface.mesh, waves, corners),
        inputs.size());
  }
  return quality;
}

}  // namespace brindle::tool
