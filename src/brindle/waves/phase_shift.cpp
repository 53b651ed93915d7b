#include "brindle/phase_shift.h"

#include <array>
#include <utility>

#include "brindle/base/elementary.h"
#include "brindle/waves/parsed_words.h"

namespace brindle {
namespace {

constexpr std::array<std::pair<std::string_view, PhaseShiftKind>, 3> kNames{
    {{"aligned", PhaseShiftKind::aligned},
     {"common_source", PhaseShiftKind::common_source},
     {"trapezoid", PhaseShiftKind::trapezoid}}};

struct Distance {
  float length;
  bool reflecting;
};

/// Eq. 2 and 7: both wave lines are projected into the plane through v_i, v_j and p = (v_i + d_i +
/// v_j + d_j) / 2. They meet there in C, the common source. Two readings: the factor <C - v_j, d_j>
/// of Eq. 2 can only be its sign, since d_ji is a length. And d_i is reversed to run like d_j
/// before p is computed, because p would otherwise depend on signs of directions.
Distance common_source_distance(const Wave& j, const Wave& i) {
  using Vec3d = Eigen::Vector3d;
  const Vec3d e = (i.position - j.position).cast<double>();
  const Vec3d d_i = i.direction.cast<double>(), d_j = j.direction.cast<double>();
  const double cosine = d_i.dot(d_j);
  const double length = e.norm();
  // For lines that never meet, the closed form of `aligned` is the plain projection.
  const Distance parallel{aligned_distance(j.position, j.direction, i.position, i.direction),
                          cosine < 0};
  if (!(length > 0)) return parallel;

  const Vec3d x = e / length;
  const Vec3d to_p = 0.5 * (e + (cosine < 0 ? -1.0 : 1.0) * d_i + d_j);
  const Vec3d off_edge = to_p - to_p.dot(x) * x;
  if (off_edge.norm() < 1e-9 * to_p.norm() || to_p.isZero(0)) return parallel;
  const Vec3d y = off_edge.normalized();

  // In the plane's axes (x, y) with v_j in the origin: C = a d_j = e + b d_i.
  const Eigen::Vector2d p_j(d_j.dot(x), d_j.dot(y)), p_i(d_i.dot(x), d_i.dot(y));
  const double cross = p_j.x() * p_i.y() - p_j.y() * p_i.x();
  if (std::abs(cross) < 1e-9 * p_j.norm() * p_i.norm() || cross == 0) return parallel;
  const Eigen::Vector2d edge(length, 0);
  const double a = (edge.x() * p_i.y() - edge.y() * p_i.x()) / cross;
  const Eigen::Vector2d from_j = a * p_j, from_i = from_j - edge;
  const double sign = from_j.dot(p_j) < 0 ? -1 : 1;
  return {static_cast<float>((from_j.norm() - from_i.norm()) * sign),
          cosine * from_i.dot(from_j) < 0};
}

Distance distance(PhaseShiftKind kind, const Wave& j, const Wave& i) {
  const float cosine = i.direction.dot(j.direction);
  switch (kind) {
    case PhaseShiftKind::common_source:
      return common_source_distance(j, i);
    case PhaseShiftKind::trapezoid: {
      const float s = cosine < 0 ? -1.0f : 1.0f;
      return {0.5f * (i.position - j.position).dot(j.direction + s * i.direction), cosine < 0};
    }
    case PhaseShiftKind::aligned:
      break;
  }
  return {aligned_distance(j.position, j.direction, i.position, i.direction), cosine < 0};
}

}  // namespace

std::optional<PhaseShiftKind> parse_phase_shift_kind(std::string_view name) {
  for (const auto& [known, kind] : kNames) {
    if (known == name) return kind;
  }
  return std::nullopt;
}

std::string_view name_of(PhaseShiftKind kind) {
  return kNames[static_cast<std::size_t>(kind)].first;
}

PhaseShift phase_shift(PhaseShiftKind kind, const Wave& j, const Wave& i) {
  const Distance d = distance(kind, j, i);
  return {kTwoPi * std::sqrt(i.frequency * j.frequency) * d.length, d.reflecting};
}

}  // namespace brindle
