#include "brindle/quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/corner_phases.h"
#include "brindle/geometry/crease_edges.h"
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

namespace {

struct PointSums {
  std::size_t count = 0, over_5deg = 0;
  double angle = 0, spacing = 0;

  PointSums operator+(const PointSums& o) const {
    return {count + o.count, over_5deg + o.over_5deg, angle + o.angle, spacing + o.spacing};
  }
};

CornerWave wave_at(const WaveSet& waves, std::span<const Complex> z, Index i) {
  return {waves.wave(i), z[i]};
}

/// The gradient along the wave's direction and across it, in radians per unit length.
std::optional<Eigen::Vector2d> gradient(const CornerWave& wave, const Vec3& normal,
                                        std::span<const CornerWave> neighbors,
                                        PhaseShiftKind kind) {
  const Vec3 along = wave.wave.direction, across = normal.cross(along);
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (CornerWave neighbor : neighbors) {
    if (neighbor.wave.direction.dot(along) < 0) neighbor = flipped(neighbor);
    const Vec3 edge = neighbor.wave.position - wave.wave.position;
    const Eigen::Vector2d e(edge.dot(along), edge.dot(across));
    if (e.isZero(0)) continue;
    const double weight = 1 / e.squaredNorm();
    matrix += weight * e * e.transpose();
    right += weight * e * static_cast<double>(lifted_step(wave, neighbor, kind));
  }
  const double trace = matrix.trace();
  if (!(matrix.determinant() > 1e-6 * trace * trace)) return std::nullopt;
  return matrix.ldlt().solve(right);
}

}  // namespace

PatternQuality measure_point_quality(const Adjacency& neighborhood, std::span<const Vec3> normals,
                                     const WaveSet& waves, std::span<const Complex> z,
                                     PhaseShiftKind kind, const Progress& progress) {
  const auto sums_of = [&](std::size_t begin, std::size_t end) {
    PointSums sums;
    std::vector<CornerWave> neighbors;
    for (auto i = static_cast<Index>(begin); i < end; ++i) {
      if (waves.directions[i].isZero(0)) continue;
      neighbors.clear();
      for (const Index j : neighborhood.of(i)) {
        if (!waves.directions[j].isZero(0)) neighbors.push_back(wave_at(waves, z, j));
      }
      const auto slope = gradient(wave_at(waves, z, i), normals[i], neighbors, kind);
      if (!slope) continue;
      const double angle =
          std::abs(elementary::atan2(slope->y(), std::abs(slope->x()))) * 180 / std::numbers::pi;
      const double expected = 2 * std::numbers::pi * static_cast<double>(waves.frequencies[i]);
      ++sums.count;
      sums.over_5deg += angle > 5;
      sums.angle += angle;
      sums.spacing += std::abs(slope->norm() / expected - 1);
    }
    return sums;
  };
  const PointSums sums = parallel_sum<PointSums>(neighborhood.node_count(), progress, sums_of);
  const double count = std::max<double>(1, static_cast<double>(sums.count));
  PatternQuality quality;
  quality.angle_error_mean_deg = sums.angle / count;
  quality.angle_error_share_over_5deg = static_cast<double>(sums.over_5deg) / count;
  quality.spacing_error_mean = sums.spacing / count;
  quality.vertices_without_wave = count_without_wave(waves.directions);
  return quality;
}

namespace {

/// The slip between two waves at one vertex in degrees, 0 to 180; nullopt if either is missing.
std::optional<double> slip_between(const Surface& surface, const WaveSet& waves,
                                   std::span<const Complex> z, Index i, Index j) {
  const Vec3 &d_i = waves.directions[i], &d_j = waves.directions[j];
  if (d_i.isZero(0) || d_j.isZero(0)) return std::nullopt;
  const float cosine = cosine_across(d_j, surface.normals[j], d_i, surface.normals[i]);
  const Complex seen = cosine < 0 ? -std::conj(z[j]) : z[j];
  return std::abs(elementary::arg(z[i] * std::conj(seen))) * 180 / std::numbers::pi;
}

}  // namespace

std::optional<CreaseSlip> crease_slip(const Surface& surface, const WaveSet& waves,
                                      std::span<const Complex> z) {
  if (surface.creases.empty()) return std::nullopt;
  CreaseSlip slip;
  for (const CreaseEdge& edge : surface.creases.edges) {
    const auto [from, to] = edge.first;
    const double half = (surface.mesh.positions[to] - surface.mesh.positions[from]).norm() / 2;
    for (int end = 0; end < 2; ++end) {
      const auto degrees = slip_between(surface, waves, z, edge.first[end], edge.second[end]);
      if (!degrees) continue;
      slip.length += half;
      slip.mean_deg += half * *degrees;
      slip.share += *degrees > kSlipDegrees ? half : 0;
    }
  }
  if (slip.length > 0) {
    slip.mean_deg /= slip.length;
    slip.share /= slip.length;
  }
  return slip;
}

}  // namespace brindle
