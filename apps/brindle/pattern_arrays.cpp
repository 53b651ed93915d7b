#include "pattern_arrays.h"

#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>

namespace brindle::tool {
void add_waves(std::vector<DataArray>& arrays, const WrittenWaves& written, float missing,
               const std::vector<float>& branches) {
  std::vector<float> phases, sines;
  std::vector<std::uint8_t> valid;
  for (std::size_t v = 0; v < written.z.size(); ++v) {
    const bool wave = written.has_wave(v);
    phases.push_back(wave ? std::arg(written.z[v]) : missing);
    sines.push_back(wave ? std::sin(phases.back()) : missing);
    valid.push_back(wave ? 1 : 0);
  }
  arrays.push_back(make_data_array(written.named("phase"), 1, phases));
  arrays.push_back(make_data_array(written.named("direction"), written.waves.directions));
  arrays.push_back(make_data_array(written.named("frequency"), 1, written.waves.frequencies));
  if (!written.frequencies_wanted.empty()) {
    arrays.push_back(
        make_data_array(written.named("frequency_wanted"), 1, written.frequencies_wanted));
  }
  if (!branches.empty()) {
    arrays.push_back(make_data_array(written.named("branch"), 1, branches));
  }
  arrays.push_back(make_data_array(written.named("sin_phase"), 1, sines));
  arrays.push_back(make_data_array(written.named("valid"), 1, valid));
}

void add_carried_waves(std::vector<DataArray>& arrays, const TexturedMesh& textured,
                       const Mesh& mesh, const StripePattern& pattern, const std::string& suffix,
                       float missing) {
  const auto [waves, z] = carried_waves(textured, pattern.waves, pattern.solution.z);
  std::vector<float> flags =
      carried_values(textured, branches_at_vertices(mesh, pattern.corners), 1);
  // A barycentre is at a branch if all corners are.
  for (float& flag : flags) flag = std::floor(flag);
  std::vector<float> wanted;
  if (!pattern.frequencies_wanted.empty()) {
    wanted = carried_values(textured, pattern.frequencies_wanted, 1);
  }
  add_waves(arrays, {waves, wanted, z, suffix}, missing, flags);
}

std::vector<float> branches_at_vertices(const Mesh& mesh, std::span<const CornerPhases> corners) {
  std::vector<float> flags(mesh.vertex_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (!is_branch(corners[t].kind)) continue;
    for (const Index vertex : mesh.triangles[t]) flags[vertex] = 1;
  }
  return flags;
}

DataArray branches_in_triangles(const StripePattern& pattern, const std::string& name) {
  std::vector<std::uint8_t> flags;
  for (const CornerPhases& corners : pattern.corners)
    flags.push_back(is_branch(corners.kind) ? 1 : 0);
  return make_data_array(name, 1, flags);
}

DataArray corner_phases_of(const StripePattern& pattern, const std::string& name) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  std::vector<float> phases;
  for (const CornerPhases& corners : pattern.corners) {
    const bool lifted =
        corners.kind == TriangleKind::regular || corners.kind == TriangleKind::branch;
    for (const float phase : corners.phase) phases.push_back(lifted ? phase : kNan);
  }
  return make_data_array(name, 3, phases);
}

}  // namespace brindle::tool
