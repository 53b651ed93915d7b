#include "brindle/quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

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
