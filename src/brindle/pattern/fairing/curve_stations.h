/// Places along curves, and how curves turn between them.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "brindle/mesh.h"
#include "brindle/pattern/fairing/unrolled_curve.h"
#include "brindle/polylines.h"

namespace brindle {

inline constexpr double kStationStep = 0.05;  // periods
inline constexpr std::size_t kStationsPerPeriod = 20;

/// A place on a curve, and where the curve runs there.
struct Station {
  double periods;
  UnrolledPlace place;
  Eigen::Vector3d position, along, left;
};

/// Places of a curve at equal steps between two lengths in periods; less where it ends, and nothing
/// of a closed curve that would be passed twice.
std::vector<Station> stations(const Mesh& mesh, const UnrolledCurve& curve, double from, double to);

/// Places going back from an end of an open curve, `farthest` periods or to its middle at most;
/// none if it is too short.
std::vector<Station> back_from_end(const Mesh& mesh, const UnrolledCurve& curve, std::size_t end,
                                   double farthest);

/// Whether a curve has turned by more than `most` radians within the last period before a station,
/// coming from those behind.
bool has_turned(const UnrolledCurve& curve, const std::vector<Station>& own, std::size_t station,
                double most);

/// By how much the last step of a way from an end is turned against the curve one period before,
/// radians; the way has a place for each step and begins at one of the stations going back from the
/// end.
double turn_at_end(const Mesh& mesh, const std::vector<TrianglePoint>& places, std::size_t end,
                   const std::vector<Station>& own, std::size_t station);

}  // namespace brindle
