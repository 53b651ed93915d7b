#include "brindle/carried_phases.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "brindle/base/elementary.h"
#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/fragment_phase.h"
#include "brindle/geometry/nearest_place.h"
#include "brindle/phase_shift.h"
#include "brindle/waves/direction_graph.h"

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
Source source_in(const LastPattern& last, const NearbyPlace& place) {
  std::array<CornerWave, 3> corners;
  std::optional<std::size_t> best;
  bool all = true;
  for (std::size_t m = 0; m < 3; ++m) {
    corners[m] = wave_at(last, place.corners[m]);
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

/// The wave of the last pattern at a place.
Source source_at(const LastPattern& last, const NearbyPlace& place) {
  if (place.triangle) return source_in(last, place);
  return {wave_at(last, place.corners[0]), place.position};
}

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

/// Maps vertices of a surface to those of the last one.
class Counterparts {
 public:
  Counterparts(const std::string& what, std::size_t count, std::size_t last_count,
               std::span<const Index> numbers)
      : numbers_(numbers) {
    const std::size_t matched = numbers.empty() ? last_count : numbers.size();
    if (count != matched) {
      throw Error(what + ": " + std::to_string(count) + " vertices cannot be matched with " +
                  std::to_string(matched) + " by number");
    }
    const auto bad = ranges::find_if(
        numbers, [&](Index from) { return from != kNoCounterpart && from >= last_count; });
    if (bad == numbers.end()) return;
    throw Error(what + ": vertex " + std::to_string(bad - numbers.begin()) +
                " is matched with vertex " + std::to_string(*bad) + " of " +
                std::to_string(last_count));
  }

  /// `kNoCounterpart` if there is none.
  Index of(Index vertex) const { return numbers_.empty() ? vertex : numbers_[vertex]; }

 private:
  std::span<const Index> numbers_;
};

}  // namespace

std::vector<Complex> matched_phases(const LastPattern& last, const WaveSet& waves,
                                    std::span<const Index> counterparts) {
  check_sizes(last);
  const std::size_t count = checked_size(waves);
  const Counterparts matched("carried phases", count, last.z.size(), counterparts);
  std::vector<Complex> z(count);
  for (Index i = 0; i < count; ++i) {
    const Index from = matched.of(i);
    if (from == kNoCounterpart) continue;
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
  const NearestPlace places(last.mesh, stages.begin("nearest places"));
  const Eigen::Vector3d shift = mesh.origin - last.mesh.origin;
  std::vector<Complex> z(count);
  parallel_for(
      count, stages.begin("look up"),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const Vec3& direction = waves.directions[i];
          if (direction == Vec3::Zero()) continue;
          const Eigen::Vector3d point = waves.positions[i].cast<double>() + shift;
          const auto place = places.nearest(point);
          if (!place) continue;
          const Source source = source_at(last, *place);
          if (!has_wave(source.corner)) continue;
          z[i] = led_phase(source, point, direction, waves.frequencies[i], max_periods);
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

namespace {

/// Relative magnitude below which the neighbours do not determine a rotation.
constexpr float kLeastAgreement = 1e-3f;

void check_field(const LastField& last) {
  const std::size_t count = last.mesh.vertex_count();
  if (last.normals.size() == count && last.directions.size() == count) return;
  throw Error("carried field: the last field has " + std::to_string(count) + " vertices, " +
              std::to_string(last.normals.size()) + " normals and " +
              std::to_string(last.directions.size()) +
              " directions; there must be one of each per vertex");
}

void check_symmetry(int symmetry) {
  if (symmetry < 1) throw Error("carried field: the symmetry N must be 1 or above");
}

Complex in_basis(const Vec3& vector, const TangentBasis& basis) {
  return {vector.dot(basis.x), vector.dot(basis.y)};
}

/// Rotation of a vertex's neighbours about it, from the old tangent basis to the new one.
struct Turn {
  Complex direct = 0;     ///< sum of conj(a) b over edges a that became b
  Complex reflected = 0;  ///< sum of a b: the same for a flipped normal
  float scale = 0;        ///< product of the sums of |a|^2 and |b|^2
};

Turn turn_of(const LastField& last, const Surface& surface, const Counterparts& counterparts,
             Index vertex, Index from) {
  const TangentBasis before = tangent_basis(last.normals[from]);
  const TangentBasis now = tangent_basis(surface.normals[vertex]);
  Turn turn;
  float squares_before = 0, squares_now = 0;
  for (const Index neighbor : surface.neighborhood->of(vertex)) {
    const Index was = counterparts.of(neighbor);
    if (was == kNoCounterpart) continue;
    const auto& positions = last.mesh.positions;
    const Complex a = in_basis(positions[was] - positions[from], before);
    const Complex b =
        in_basis(surface.mesh.positions[neighbor] - surface.mesh.positions[vertex], now);
    turn.direct += std::conj(a) * b;
    turn.reflected += a * b;
    squares_before += std::norm(a);
    squares_now += std::norm(b);
  }
  turn.scale = squares_before * squares_now;
  return turn;
}

/// The direction rotated with the neighbours; projected if they determine no rotation.
Vec3 turned_along(const Turn& turn, const Vec3& direction, const Vec3& last_normal,
                  const Vec3& normal) {
  const bool reflects = std::norm(turn.reflected) > std::norm(turn.direct);
  const Complex by = reflects ? turn.reflected : turn.direct;
  // Also false for NaN.
  if (!(std::norm(by) > kLeastAgreement * kLeastAgreement * turn.scale) || last_normal.isZero(0)) {
    return tangent_direction(direction, normal);
  }
  const Complex was = in_basis(direction, tangent_basis(last_normal));
  const Complex is = (reflects ? std::conj(was) : was) * by;
  const TangentBasis basis = tangent_basis(normal);
  return tangent_direction(is.real() * basis.x + is.imag() * basis.y, normal);
}

/// The field inside a triangle, interpolated with symmetry N. Returns the direction nearest to that
/// of the corner with the largest barycentric weight (among those with a direction).
Vec3 direction_in(const LastField& last, const NearbyPlace& place, int symmetry) {
  const Triangle& triangle = place.corners;
  std::optional<std::size_t> best;
  for (std::size_t m = 0; m < 3; ++m) {
    if (last.directions[triangle[m]].isZero(0)) continue;
    if (!best || place.barycentric[m] > place.barycentric[*best]) best = m;
  }
  if (!best) return Vec3::Zero();
  const Vec3& normal = last.normals[triangle[*best]];
  const Vec3& reference = last.directions[triangle[*best]];
  const Complex start = representation(reference, normal, symmetry);
  Complex sum = 0;
  for (std::size_t m = 0; m < 3; ++m) {
    const Vec3 direction = tangent_direction(last.directions[triangle[m]], normal);
    sum += static_cast<float>(place.barycentric[m]) * representation(direction, normal, symmetry);
  }
  const float radians = std::arg(sum * std::conj(start)) / static_cast<float>(symmetry);
  return std::cos(radians) * reference + std::sin(radians) * normal.cross(reference);
}

}  // namespace

DirectionField matched_directions(const LastField& last, const Surface& surface,
                                  std::span<const Index> counterparts) {
  check_field(last);
  const Counterparts matched("carried field", surface.mesh.vertex_count(), last.mesh.vertex_count(),
                             counterparts);
  DirectionField directions(surface.mesh.vertex_count(), Vec3::Zero());
  parallel_for(directions.size(), [&](std::size_t begin, std::size_t end) {
    for (Index i = static_cast<Index>(begin); i < end; ++i) {
      const Index from = matched.of(i);
      if (from == kNoCounterpart || last.directions[from].isZero(0)) continue;
      const Turn turn = turn_of(last, surface, matched, i, from);
      directions[i] =
          turned_along(turn, last.directions[from], last.normals[from], surface.normals[i]);
    }
  });
  return directions;
}

DirectionField carried_directions(const LastField& last, const Surface& surface, int symmetry,
                                  double max_distance) {
  check_field(last);
  check_symmetry(symmetry);
  if (!(max_distance > 0)) throw Error("carried field: the largest distance must be above 0");
  const NearestPlace places(last.mesh);
  const auto direction_near = [&](const Eigen::Vector3d& point) -> Vec3 {
    const auto place = places.nearest(point, max_distance);
    if (!place) return Vec3::Zero();
    return place->triangle ? direction_in(last, *place, symmetry)
                           : last.directions[place->corners[0]];
  };
  const Eigen::Vector3d shift = surface.mesh.origin - last.mesh.origin;
  DirectionField directions(surface.mesh.vertex_count(), Vec3::Zero());
  parallel_for(
      directions.size(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const Eigen::Vector3d point = surface.mesh.positions[i].cast<double>() + shift;
          directions[i] = tangent_direction(direction_near(point), surface.normals[i]);
        }
      },
      kLookupGrain);
  return directions;
}

double mean_period(const WaveSet& waves) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < waves.directions.size(); ++i) {
    if (waves.directions[i].isZero(0)) continue;
    sum += static_cast<double>(waves.frequencies[i]);
    ++count;
  }
  return sum > 0 ? static_cast<double>(count) / sum : std::numeric_limits<double>::infinity();
}

FieldStep field_step(std::span<const Vec3> directions, std::span<const Vec3> last, int symmetry) {
  check_symmetry(symmetry);
  if (directions.size() != last.size()) {
    throw Error("field step: there must be one direction and one last direction per vertex");
  }
  const double period = 2 * std::numbers::pi / symmetry;
  FieldStep step;
  double sum = 0;
  std::size_t matched = 0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    if (directions[i].isZero(0)) continue;
    if (last[i].isZero(0)) {
      ++step.unmatched;
      continue;
    }
    const Eigen::Vector3d a = directions[i].cast<double>(), b = last[i].cast<double>();
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    sum += std::abs(std::remainder(angle, period));
    ++matched;
  }
  if (matched > 0) step.mean_deg = sum / static_cast<double>(matched) * 180 / std::numbers::pi;
  return step;
}

}  // namespace brindle
