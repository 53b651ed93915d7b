#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/base/two_pi.h"
#include "brindle/corner_phases.h"
#include "brindle/quality.h"
#include "brindle/texture_waves.h"

namespace brindle {
namespace {

/// A square that is squeezed to nothing has no finite distortion.
constexpr float kLargestAreaRatio = 100;

struct Distortion {
  float angle_deg;
  float area;
};

float mean_frequency(const CornerWaves& corners) {
  return (corners[0].wave.frequency + corners[1].wave.frequency + corners[2].wave.frequency) / 3;
}

/// The angle of a parallelogram whose coordinates have these gradients is 180 degrees less that
/// between the gradients; its area is 1 over that of the gradients' parallelogram.
Distortion distortion(const Vec3& gradient_u, const Vec3& gradient_v, float wanted_density) {
  const float density = gradient_u.cross(gradient_v).norm();
  const float angle = std::atan2(density, gradient_u.dot(gradient_v));
  const float ratio = density / wanted_density;
  const float factor = std::max(ratio, ratio > 0 ? 1 / ratio : kLargestAreaRatio);
  return {std::abs(angle * 180 / std::numbers::pi_v<float> - 90),
          std::min(factor, kLargestAreaRatio) - 1};
}

/// The linear phases of a triangle whose corners run alike.
struct LinearPhases {
  CornerPhases u;
  CornerPhases v;
  bool regular() const {
    return u.kind == TriangleKind::regular && v.kind == TriangleKind::regular;
  }
};

std::vector<LinearPhases> linear_phases(const TextureWaves& waves, PhaseShiftKind kind) {
  std::vector<LinearPhases> phases(waves.triangle_count());
  parallel_for(phases.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      phases[t] = {corner_phases(waves.u[t], kind), corner_phases(waves.v[t], kind)};
    }
  });
  return phases;
}

/// 1 for the vertices of every triangle that is not regular.
std::vector<std::uint8_t> vertices_at_branches(const Mesh& mesh,
                                               const std::vector<LinearPhases>& phases) {
  std::vector<std::uint8_t> at_branch(mesh.vertex_count());
  for (std::size_t t = 0; t < phases.size(); ++t) {
    if (phases[t].regular()) continue;
    for (const Index vertex : mesh.triangles[t]) at_branch[vertex] = 1;
  }
  return at_branch;
}

double mean(const std::vector<float>& values) {
  const double sum = parallel_sum<double>(values.size(), [&](std::size_t begin, std::size_t end) {
    double part = 0;
    for (std::size_t i = begin; i < end; ++i) part += values[i];
    return part;
  });
  return sum / std::max<double>(1, static_cast<double>(values.size()));
}

/// The value that 95 in 100 stay below. Reorders the values.
double percentile_95(std::vector<float>& values) {
  if (values.empty()) return 0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 95 / 100);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

TextureQuality measure_texture(const Mesh& mesh, const TextureWaves& waves, PhaseShiftKind kind) {
  const std::vector<LinearPhases> phases = linear_phases(waves, kind);
  const std::vector<std::uint8_t> at_branch = vertices_at_branches(mesh, phases);
  std::vector<float> angles, areas;
  for (std::size_t t = 0; t < phases.size(); ++t) {
    const Triangle& triangle = mesh.triangles[t];
    if (at_branch[triangle[0]] || at_branch[triangle[1]] || at_branch[triangle[2]]) continue;
    const std::array<Vec3, 3> position{mesh.positions[triangle[0]], mesh.positions[triangle[1]],
                                       mesh.positions[triangle[2]]};
    const Distortion d = distortion(linear_gradient(position, phases[t].u.phase) / kTwoPi,
                                    linear_gradient(position, phases[t].v.phase) / kTwoPi,
                                    mean_frequency(waves.u[t]) * mean_frequency(waves.v[t]));
    angles.push_back(d.angle_deg);
    areas.push_back(d.area);
  }
  TextureQuality quality;
  quality.measured_triangles = angles.size();
  quality.angle_mean_deg = mean(angles);
  quality.area_mean = mean(areas);
  quality.angle_95th_deg = percentile_95(angles);
  quality.area_95th = percentile_95(areas);
  return quality;
}

}  // namespace brindle
