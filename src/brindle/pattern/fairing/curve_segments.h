/// The segments of many curves, to find those near a place.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "brindle/geometry/box_tree.h"
#include "brindle/polylines.h"
#include "brindle/progress.h"

namespace brindle {

/// A segment of one of the curves.
struct CurveSegment {
  Index line;
  Index number;
};

/// The curves must outlive this.
class CurveSegments {
 public:
  /// Throws Cancelled if `progress` asks for it.
  CurveSegments(const Polylines& lines, const Progress& progress);

  std::array<Vec3, 2> ends_of(const CurveSegment& segment) const;

  /// Calls `take(segment)` for all that may be within the squared distance `limit()` of a point.
  template <class Limit, class Take>
  void visit(const Eigen::Vector3d& point, const Limit& limit, const Take& take) const {
    tree_.visit(
        point, [&](const BoundingBox&, double square) { return square < limit(); },
        [&](Index number) { take(segments_[number]); });
  }

  /// Where a short straight way crosses a curve.
  struct Crossing {
    double share;  ///< of the segment
    double along;  ///< share of the way
  };

  /// Whether a way crosses a segment, seen along `upward`, and within its own length of it.
  std::optional<Crossing> crossing(const CurveSegment& segment, const Eigen::Vector3d& from,
                                   const Eigen::Vector3d& to, const Eigen::Vector3d& upward) const;

 private:
  const Polylines& lines_;
  std::vector<CurveSegment> segments_;
  BoxTree tree_;
};

}  // namespace brindle
