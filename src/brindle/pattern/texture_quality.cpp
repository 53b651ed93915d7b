#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "brindle/base/parallel.h"
#include "brindle/corner_phases.h"
#include "brindle/pattern/quality_sums.h"
#include "brindle/pattern/triangle_kernels.h"

namespace brindle {
namespace {

/// The upper bound: a square of no area has infinite distortion.
constexpr float kLargestAreaRatio = 100;

bool is_regular(const LinearPattern& u, const LinearPattern& v, std::size_t triangle) {
  return u.corners[triangle].kind == TriangleKind::regular &&
         v.corners[triangle].kind == TriangleKind::regular;
}

/// 1 for the vertices of every triangle that is not regular.
std::vector<std::uint8_t> vertices_at_branches(const Mesh& mesh, const LinearPattern& u,
                                               const LinearPattern& v) {
  std::vector<std::uint8_t> at_branch(mesh.vertex_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    if (is_regular(u, v, t)) continue;
    for (const Index vertex : mesh.triangles[t]) at_branch[vertex] = 1;
  }
  return at_branch;
}

/// Distortions of up to kTriangleLanes triangles from `first` on.
void measure_texture_lanes(const Mesh& mesh, const LinearPattern& u, const LinearPattern& v,
                           std::size_t first, DistortionLanes& distortions) {
  CornerLanes corners;
  LiftedLanes lifted_u, lifted_v;
  DensityLanes density;
  for (std::size_t lane = 0; lane < kTriangleLanes; ++lane) {
    const std::size_t t = std::min(first + lane, mesh.triangle_count() - 1);
    for (std::size_t m = 0; m < 3; ++m) {
      const Index vertex = mesh.triangles[t][m];
      corners.set_position(lane, m, mesh.positions[vertex]);
      density.u[m][lane] = u.frequencies[vertex];
      density.v[m][lane] = v.frequencies[vertex];
    }
    lifted_u.set(lane, u.corners[t]);
    lifted_v.set(lane, v.corners[t]);
  }
  triangle_kernels::measure_distortions(corners, lifted_u, lifted_v, density, distortions);
}

struct Distortions {
  std::vector<float> angles;  ///< degrees
  std::vector<float> areas;
};

/// The distortions of all triangles that share no vertex with an irregular one.
Distortions distortions_of(const Mesh& mesh, const LinearPattern& u, const LinearPattern& v,
                           const Progress& progress) {
  const std::vector<std::uint8_t> at_branch = vertices_at_branches(mesh, u, v);
  Distortions result{std::vector<float>(mesh.triangle_count(), -1),
                     std::vector<float>(mesh.triangle_count(), -1)};
  parallel_for(mesh.triangle_count(), progress, [&](std::size_t begin, std::size_t end) {
    DistortionLanes lanes;
    for (std::size_t t = begin; t < end; ++t) {
      const std::size_t lane = (t - begin) % kTriangleLanes;
      if (lane == 0) measure_texture_lanes(mesh, u, v, t, lanes);
      const Triangle& triangle = mesh.triangles[t];
      if (at_branch[triangle[0]] || at_branch[triangle[1]] || at_branch[triangle[2]]) continue;
      const float ratio = lanes.area_ratio[lane];
      const float factor = std::max(ratio, ratio > 0 ? 1 / ratio : kLargestAreaRatio);
      result.angles[t] = std::abs(lanes.angle[lane] * 180 / std::numbers::pi_v<float> - 90);
      result.areas[t] = std::min(factor, kLargestAreaRatio) - 1;
    }
  });
  std::erase_if(result.angles, [](float angle) { return angle < 0; });
  std::erase_if(result.areas, [](float area) { return area < 0; });
  return result;
}

double mean(const std::vector<float>& values) {
  const double sum = parallel_sum<double>(values.size(), [&](std::size_t begin, std::size_t end) {
    double part = 0;
    for (std::size_t i = begin; i < end; ++i) part += values[i];
    return part;
  });
  return sum / std::max<double>(1, static_cast<double>(values.size()));
}

/// The 95th percentile; reorders the values.
double percentile_95(std::vector<float>& values) {
  if (values.empty()) return 0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 95 / 100);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

}  // namespace

TextureQuality measure_texture(const Mesh& mesh, const LinearPattern& u, const LinearPattern& v,
                               const Progress& progress) {
  auto [angles, areas] = distortions_of(mesh, u, v, progress.part(0, 0.7));
  progress.report(0.7);
  TextureQuality quality;
  quality.measured_triangles = angles.size();
  quality.angle_mean_deg = mean(angles);
  quality.area_mean = mean(areas);
  quality.angle_95th_deg = percentile_95(angles);
  quality.area_95th = percentile_95(areas);
  return quality;
}

TextureQuality measure_texture(const Mesh& mesh, const TextureWaves& waves, PhaseShiftKind kind,
                               std::size_t parts) {
  auto u = corner_phases(waves.u, kind), v = corner_phases(waves.v, kind);
  for (std::size_t t = u.size() - std::min(parts, u.size()); t < u.size(); ++t) {
    u[t].kind = v[t].kind = TriangleKind::field_singularity;
  }
  std::vector<float> frequencies_u(mesh.vertex_count()), frequencies_v(mesh.vertex_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    for (int m = 0; m < 3; ++m) {
      frequencies_u[mesh.triangles[t][m]] = waves.u[t][m].wave.frequency;
      frequencies_v[mesh.triangles[t][m]] = waves.v[t][m].wave.frequency;
    }
  }
  return measure_texture(mesh, {u, frequencies_u}, {v, frequencies_v});
}

}  // namespace brindle
