#include "brindle/carried_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "brindle/base/parallel.h"
#include "brindle/base/standard.h"
#include "brindle/error.h"
#include "brindle/nearest.h"
#include "brindle/waves/direction_graph.h"

namespace brindle {
namespace {

/// One nearest-point query takes about a microsecond.
constexpr std::size_t kPlaceGrain = 256;

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

/// Maps vertices of a surface to those of the last one.
class Counterparts {
 public:
  Counterparts(const LastField& last, const Surface& surface, std::span<const Index> numbers)
      : numbers_(numbers) {
    const std::size_t count = surface.mesh.vertex_count(), last_count = last.mesh.vertex_count();
    const std::size_t matched = numbers.empty() ? last_count : numbers.size();
    if (count != matched) {
      throw Error("carried field: " + std::to_string(count) + " vertices cannot be matched with " +
                  std::to_string(matched) + " by number");
    }
    const auto bad = ranges::find_if(
        numbers, [&](Index from) { return from != kNoCounterpart && from >= last_count; });
    if (bad == numbers.end()) return;
    throw Error("carried field: vertex " + std::to_string(bad - numbers.begin()) +
                " is matched with vertex " + std::to_string(*bad) + " of " +
                std::to_string(last_count));
  }

  /// `kNoCounterpart` if there is none.
  Index of(Index vertex) const { return numbers_.empty() ? vertex : numbers_[vertex]; }

 private:
  std::span<const Index> numbers_;
};

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
Vec3 direction_in(const LastField& last, const PointOnMesh& place, int symmetry) {
  const Triangle& triangle = last.mesh.triangles[place.triangle];
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

/// Finds directions of the last field: in triangles, or at vertices of a point cloud.
class DirectionSources {
 public:
  explicit DirectionSources(const LastField& last, int symmetry)
      : last_(last), symmetry_(symmetry) {
    last.mesh.triangles.empty() ? static_cast<void>(vertices_.emplace(last.mesh))
                                : static_cast<void>(triangles_.emplace(last.mesh));
  }

  Vec3 near(const Eigen::Vector3d& point, double max_distance) const {
    if (triangles_) {
      const auto place = triangles_->nearest(point, max_distance);
      return place ? direction_in(last_, *place, symmetry_) : Vec3(Vec3::Zero());
    }
    const auto found = vertices_->nearest(point, max_distance);
    return found ? last_.directions[found->vertex] : Vec3(Vec3::Zero());
  }

 private:
  const LastField& last_;
  int symmetry_;
  std::optional<NearestOnMesh> triangles_;
  std::optional<NearestVertex> vertices_;
};

}  // namespace

DirectionField matched_directions(const LastField& last, const Surface& surface,
                                  std::span<const Index> counterparts) {
  check_field(last);
  const Counterparts matched(last, surface, counterparts);
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
  const DirectionSources sources(last, symmetry);
  const Eigen::Vector3d shift = surface.mesh.origin - last.mesh.origin;
  DirectionField directions(surface.mesh.vertex_count(), Vec3::Zero());
  parallel_for(
      directions.size(),
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const Eigen::Vector3d point = surface.mesh.positions[i].cast<double>() + shift;
          directions[i] = tangent_direction(sources.near(point, max_distance), surface.normals[i]);
        }
      },
      kPlaceGrain);
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
