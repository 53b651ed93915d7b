#include "brindle/carried_phases.h"

#include <cmath>
#include <optional>
#include <string>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/error.h"
#include "brindle/fragment_phase.h"
#include "brindle/nearest.h"
#include "brindle/phase_shift.h"

namespace brindle {
namespace {

/// One nearest-point query takes about a microsecond.
constexpr std::size_t kLookupGrain = 256;

std::size_t checked_size(const WaveSet& waves) {
  const std::size_t count = waves.directions.size();
  if (waves.positions.size() != count || waves.frequencies.size() != count) {
    throw Error("carried phases: there must be one position, direction and frequency per vertex");
  }
  return count;
}

void check_sizes(const LastPattern& last) {
  const std::size_t count = checked_size(last.waves);
  if (last.z.size() == count && last.mesh.vertex_count() == count) return;
  throw Error("carried phases: the last pattern has " + std::to_string(last.mesh.vertex_count()) +
              " vertices, " + std::to_string(count) + " waves and " +
              std::to_string(last.z.size()) + " phases; there must be one of each per vertex");
}

bool is_phase(const Complex& z) {
  return std::isfinite(z.real()) && std::isfinite(z.imag()) && z != Complex(0);
}

CornerWave wave_at(const LastPattern& last, Index vertex) {
  if (is_phase(last.z[vertex])) return {last.waves.wave(vertex), last.z[vertex]};
  return {{last.waves.positions[vertex], Vec3::Zero(), 0}, 0};
}

bool has_wave(const CornerWave& corner) { return corner.wave.direction != Vec3::Zero(); }

/// The same wave, reversed if it points against `direction`.
CornerWave alike(const CornerWave& corner, const Vec3& direction) {
  return direction.dot(corner.wave.direction) < 0 ? flipped(corner) : corner;
}

/// Position and wave of a nearest-point query.
struct Source {
  CornerWave corner;  ///< zero direction: nothing was found
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
};

/// The wave interpolated at a point of a triangle. If a corner has no wave, the wave of the corner
/// with the largest barycentric weight among those with one.
Source source_in(const LastPattern& last, const PointOnMesh& place) {
  const Triangle& triangle = last.mesh.triangles[place.triangle];
  std::array<CornerWave, 3> corners;
  std::optional<std::size_t> best;
  bool all = true;
  for (std::size_t m = 0; m < 3; ++m) {
    corners[m] = wave_at(last, triangle[m]);
    if (!has_wave(corners[m])) {
      all = false;
    } else if (!best || place.barycentric[m] > place.barycentric[*best]) {
      best = m;
    }
  }
  if (!best) return {{{Vec3::Zero(), Vec3::Zero(), 0}, 0}};
  const auto& b = place.barycentric;
  const FragmentWave wave =
      all ? fragment_phase(corners, Eigen::Vector3d(b[0], b[1], b[2]).cast<float>())
          : FragmentWave();
  if (wave.z == Complex(0)) {
    return {corners[*best], corners[*best].wave.position.cast<double>()};
  }
  return {{{place.position.cast<float>(), wave.direction, wave.frequency}, wave.z}, place.position};
}

/// Finds waves of the last pattern: in triangles, or at vertices of a point cloud.
class Sources {
 public:
  Sources(const LastPattern& last, const Progress& progress) : last_(last) {
    last.mesh.triangles.empty() ? static_cast<void>(vertices_.emplace(last.mesh, progress))
                                : static_cast<void>(triangles_.emplace(last.mesh, progress));
  }

  std::optional<Source> near(const Eigen::Vector3d& point) const {
    if (triangles_) {
      const auto place = triangles_->nearest(point);
      if (!place) return std::nullopt;
      return source_in(last_, *place);
    }
    const auto found = vertices_->nearest(point);
    if (!found) return std::nullopt;
    const CornerWave corner = wave_at(last_, found->vertex);
    return Source{corner, corner.wave.position.cast<double>()};
  }

 private:
  const LastPattern& last_;
  std::optional<NearestOnMesh> triangles_;
  std::optional<NearestVertex> vertices_;
};

/// The source's phase moved to `point`, for a wave along `direction`; 0 beyond `max_periods`.
Complex led_phase(const Source& source, const Eigen::Vector3d& point, const Vec3& direction,
                  float frequency, double max_periods) {
  const Eigen::Vector3d offset = point - source.position;
  const CornerWave corner = alike(source.corner, direction);
  if (offset.norm() * static_cast<double>(corner.wave.frequency) > max_periods) return 0;
  const Wave from{Vec3::Zero(), corner.wave.direction, corner.wave.frequency};
  const Wave to{offset.cast<float>(), direction, frequency};
  return corner.z * elementary::polar(1.0f, phase_shift(PhaseShiftKind::aligned, from, to).radians);
}

}  // namespace

std::vector<Complex> matched_phases(const LastPattern& last, const WaveSet& waves,
                                    std::span<const Index> counterparts) {
  check_sizes(last);
  const std::size_t count = checked_size(waves);
  const std::size_t last_count = last.z.size();
  if (counterparts.empty() ? count != last_count : counterparts.size() != count) {
    throw Error("carried phases: " + std::to_string(count) + " vertices cannot be matched with " +
                std::to_string(counterparts.empty() ? last_count : counterparts.size()) +
                " by number");
  }
  std::vector<Complex> z(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Index from = counterparts.empty() ? static_cast<Index>(i) : counterparts[i];
    if (from == kNoCounterpart) continue;
    if (from >= last_count) {
      throw Error("carried phases: vertex " + std::to_string(i) + " is matched with vertex " +
                  std::to_string(from) + " of " + std::to_string(last_count));
    }
    const CornerWave corner = wave_at(last, from);
    const Vec3& direction = waves.directions[i];
    if (has_wave(corner) && direction != Vec3::Zero()) z[i] = alike(corner, direction).z;
  }
  return z;
}

std::vector<Complex> carried_phases(const LastPattern& last, const Mesh& mesh, const WaveSet& waves,
                                    double max_periods, const Progress& progress) {
  check_sizes(last);
  const std::size_t count = checked_size(waves);
  if (mesh.vertex_count() != count) {
    throw Error("carried phases: the mesh has " + std::to_string(mesh.vertex_count()) +
                " vertices, but there are " + std::to_string(count) + " waves");
  }
  JobStages stages(progress, {{"nearest places", 1}, {"look up", 1}});
  const Sources sources(last, stages.begin("nearest places"));
  const Eigen::Vector3d shift = mesh.origin - last.mesh.origin;
  std::vector<Complex> z(count);
  parallel_for(
      count, stages.begin("look up"),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const Vec3& direction = waves.directions[i];
          if (direction == Vec3::Zero()) continue;
          const Eigen::Vector3d point = waves.positions[i].cast<double>() + shift;
          const auto source = sources.near(point);
          if (!source || !has_wave(source->corner)) continue;
          z[i] = led_phase(*source, point, direction, waves.frequencies[i], max_periods);
        }
      },
      kLookupGrain);
  stages.finish();
  return z;
}

PhaseStep phase_step(const WaveSet& waves, std::span<const Complex> z,
                     std::span<const Complex> last_z) {
  const std::size_t count = checked_size(waves);
  if (z.size() != count || last_z.size() != count) {
    throw Error("phase step: there must be one phase and one last phase per vertex");
  }
  PhaseStep step;
  double sum = 0;
  std::size_t matched = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (waves.directions[i] == Vec3::Zero()) continue;
    if (last_z[i] == Complex(0)) {
      ++step.unmatched;
      continue;
    }
    sum += std::abs(elementary::arg(z[i] * std::conj(last_z[i])));
    ++matched;
  }
  if (matched > 0) step.mean = sum / static_cast<double>(matched);
  return step;
}

}  // namespace brindle
