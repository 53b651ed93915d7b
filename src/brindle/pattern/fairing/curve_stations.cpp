#include "brindle/pattern/fairing/curve_stations.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include <Eigen/Geometry>

#include "brindle/geometry/surface_walk.h"

namespace brindle {
namespace {

using Eigen::Vector3d;

/// By how much a curve turns within the surface between two places, at most pi.
double turn_within(const UnrolledCurve& curve, const Station& a, const Station& b) {
  const auto heading = [&](const Station& station) {
    return curve.in_plane(station.place.segment, station.along);
  };
  return std::abs(std::arg(heading(a) * std::conj(heading(b))));
}

/// A direction at a place, and the normal there.
struct Heading {
  Vector3d along, normal;
};

/// The angle between two of them, which need not be near to each other: along the way between them
/// directions turn as normals do.
double angle_between(const Heading& before, const Heading& after) {
  // Normals of unorientable surfaces may point either way.
  const double sign = before.normal.dot(after.normal) < 0 ? -1 : 1;
  const Vector3d straight =
      Eigen::Quaterniond::FromTwoVectors(sign * before.normal, after.normal) * before.along;
  return std::atan2(straight.cross(after.along).norm(), straight.dot(after.along));
}

}  // namespace

std::vector<Station> stations(const Mesh& mesh, const UnrolledCurve& curve, double from,
                              double to) {
  const double all = curve.periods();
  if (curve.closed() && (to - from > all || curve.changes_sides())) return {};
  std::vector<Station> result;
  UnrolledCurve::Walker walker(curve);
  const auto steps = static_cast<int>(std::round((to - from) / kStationStep));
  for (int i = 0; i <= steps; ++i) {
    const double periods = from + i * kStationStep;
    if (!curve.closed() && (periods < 0 || periods > all)) continue;
    const double round = curve.closed() ? std::floor(periods / all) : 0;
    const UnrolledPlace place = walker.at(periods - round * all, round);
    result.push_back({periods, place, position_in(mesh, place.place), curve.along(place.segment),
                      curve.leftward(place.segment)});
  }
  return result;
}

std::vector<Station> back_from_end(const Mesh& mesh, const UnrolledCurve& curve, std::size_t end,
                                   double farthest) {
  const double all = curve.periods();
  const double reach = std::min(farthest, all / 2 - kStationStep);
  if (reach < kStationStep) return {};
  std::vector<Station> back =
      end == 0 ? stations(mesh, curve, 0, reach) : stations(mesh, curve, all - reach, all);
  if (end == 1) std::reverse(back.begin(), back.end());
  return back;
}

bool has_turned(const UnrolledCurve& curve, const std::vector<Station>& own, std::size_t station,
                double most) {
  constexpr std::size_t kStride = 4;
  const auto end = std::min(own.size(), station + kStationsPerPeriod + 1);
  for (std::size_t i = station + kStride; i < end; i += kStride) {
    if (turn_within(curve, own[station], own[i]) > most) return true;
  }
  return false;
}

double turn_at_end(const Mesh& mesh, const std::vector<TrianglePoint>& places, std::size_t end,
                   const std::vector<Station>& own, std::size_t station) {
  const auto normal = [&](const TrianglePoint& at) {
    return normal_of(corners_of(mesh, at.triangle)).stableNormalized();
  };
  const auto heading = [&](std::size_t k) {
    return Heading{position_in(mesh, places[k]) - position_in(mesh, places[k - 1]),
                   normal(places[k])};
  };
  const std::size_t last = places.size() - 1;
  if (last == 0) return 0;
  if (last > kStationsPerPeriod)
    return angle_between(heading(last - kStationsPerPeriod), heading(last));
  const Station& behind = own[std::min(station + kStationsPerPeriod - last, own.size() - 1)];
  const double towards = end == 0 ? -1 : 1;
  return angle_between({towards * behind.along, normal(behind.place.place)}, heading(last));
}

}  // namespace brindle
