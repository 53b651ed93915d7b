#include "brindle/quality.h"

#include <algorithm>
#include <numbers>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/pattern/quality_sums.h"
#include "brindle/pattern/triangle_kernels.h"

namespace brindle {
namespace {

/// Measures up to kTriangleLanes triangles from `first` on.
void measure(const Mesh& mesh, const WaveSet& waves, std::span<const CornerPhases> corners,
             std::size_t first, ErrorLanes& errors) {
  CornerLanes lanes;
  LiftedLanes lifted;
  for (std::size_t lane = 0; lane < kTriangleLanes; ++lane) {
    const std::size_t t = std::min(first + lane, mesh.triangle_count() - 1);
    for (std::size_t m = 0; m < 3; ++m) {
      const Index vertex = mesh.triangles[t][m];
      lanes.set(lane, m, mesh.positions[vertex], waves.directions[vertex],
                waves.frequencies[vertex]);
    }
    lifted.set(lane, corners[t]);
  }
  triangle_kernels::measure_errors(lanes, lifted, errors);
}

float degrees(float radians) { return radians * 180 / std::numbers::pi_v<float>; }

/// Whether the phases of two corners differ by half a period or more.
bool is_coarse(const CornerPhases& corners) {
  const auto [least, most] = std::minmax_element(corners.phase.begin(), corners.phase.end());
  return *most - *least >= std::numbers::pi_v<float>;
}

void add_triangle(QualitySums& sums, const CornerPhases& corners, const ErrorLanes& errors,
                  std::size_t lane) {
  const TriangleKind kind = corners.kind;
  sums.branches += is_branch(kind);
  sums.field_singularities += kind == TriangleKind::field_singularity;
  const double triangle_area = errors.area[lane];
  if (is_branch(kind)) sums.branch_area += triangle_area;
  if (kind != TriangleKind::regular || triangle_area == 0) return;
  const float angle_deg = degrees(errors.angle[lane]);
  sums.area += triangle_area;
  if (angle_deg > 5) {
    sums.over_5deg += triangle_area;
    if (is_coarse(corners)) sums.coarse += triangle_area;
  }
  sums.angle += triangle_area * static_cast<double>(angle_deg);
  sums.spacing += triangle_area * static_cast<double>(errors.spacing[lane]);
}

}  // namespace

std::vector<float> angle_errors_deg(const Mesh& mesh, const WaveSet& waves,
                                    std::span<const CornerPhases> corners) {
  std::vector<float> errors(mesh.triangle_count());
  parallel_for(errors.size(), [&](std::size_t begin, std::size_t end) {
    ErrorLanes lanes;
    for (std::size_t t = begin; t < end; ++t) {
      const std::size_t lane = (t - begin) % kTriangleLanes;
      if (lane == 0) measure(mesh, waves, corners, t, lanes);
      errors[t] = corners[t].kind == TriangleKind::regular ? degrees(lanes.angle[lane]) : -1;
    }
  });
  return errors;
}

std::size_t count_without_wave(std::span<const Vec3> directions) {
  return parallel_sum<std::size_t>(directions.size(), [&](std::size_t begin, std::size_t end) {
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i) count += directions[i].isZero(0);
    return count;
  });
}

QualitySums quality_sums(const Mesh& mesh, const WaveSet& waves,
                         std::span<const CornerPhases> corners, const Progress& progress) {
  QualitySums sums = parallel_sum<QualitySums>(
      mesh.triangle_count(), progress, [&](std::size_t begin, std::size_t end) {
        QualitySums sum;
        ErrorLanes errors;
        for (std::size_t t = begin; t < end; ++t) {
          const std::size_t lane = (t - begin) % kTriangleLanes;
          if (lane == 0) measure(mesh, waves, corners, t, errors);
          add_triangle(sum, corners[t], errors, lane);
        }
        return sum;
      });
  sums.without_wave = count_without_wave(waves.directions);
  return sums;
}

PatternQuality quality_of(const QualitySums& sums) {
  const auto mean = [&](double sum) { return sums.area == 0 ? 0 : sum / sums.area; };
  PatternQuality quality;
  quality.branches = sums.branches;
  quality.field_singularities = sums.field_singularities;
  if (sums.branch_area > 0) {
    quality.branch_area_share = sums.branch_area / (sums.branch_area + sums.area);
  }
  quality.angle_error_mean_deg = mean(sums.angle);
  quality.angle_error_share_over_5deg = mean(sums.over_5deg);
  quality.coarse_share_over_5deg = mean(sums.coarse);
  quality.spacing_error_mean = mean(sums.spacing);
  quality.vertices_without_wave = sums.without_wave;
  return quality;
}

PatternQuality measure_quality(const Mesh& mesh, const WaveSet& waves,
                               std::span<const CornerPhases> corners, const Progress& progress) {
  return quality_of(quality_sums(mesh, waves, corners, progress));
}

}  // namespace brindle
