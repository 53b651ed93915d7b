/// The segments of curves: to find those near a place, and as pieces within the triangles of a
/// mesh.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "brindle/geometry/box_tree.h"
#include "brindle/geometry/surface_walk.h"
#include "brindle/pattern/lifted_waves.h"
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

/// Appends the pieces of a way between two places near to each other, upright on the surface; where
/// that does not lead there, one piece with the place beside its triangle moved onto it. Pieces no
/// longer than `least` are left out.
void add_way(const WavePattern& pattern, const SurfaceWays& ways, const TrianglePoint& from,
             const TrianglePoint& to, double least, std::vector<SurfaceWays::Piece>& pieces);

/// Appends the points of a line to others, with their places; no line ends there yet.
void add_points_of(const WavePattern& pattern, const std::vector<SurfaceWays::Piece>& pieces,
                   bool closed, Polylines& to);

/// The pieces of one of the lines.
std::vector<SurfaceWays::Piece> pieces_of(const Polylines& lines, Index line);

}  // namespace brindle
