/// Segments of curves: a search tree, and pieces within the triangles of a mesh.
#pragma once

#include <array>
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

/// Finds segments near a point. The curves must outlive this.
class CurveSegments {
 public:
  /// Throws Cancelled if `progress` cancels.
  CurveSegments(const Polylines& lines, const Progress& progress);

  std::array<Vec3, 2> ends_of(const CurveSegment& segment) const;

  /// Calls `take(segment)` for all segments that may be within the squared distance `limit()`.
  template <class Limit, class Take>
  void visit(const Eigen::Vector3d& point, const Limit& limit, const Take& take) const {
    tree_.visit(
        point, [&](const BoundingBox&, double square) { return square < limit(); },
        [&](Index number) { take(segments_[number]); });
  }

  /// The crossing of a short straight path with a curve.
  struct Crossing {
    double share;  ///< share of the segment
    double along;  ///< share of the path
  };

  /// The crossing of a path with a segment, seen along `upward`; nullopt if there is none or they
  /// are farther apart than the path is long.
  std::optional<Crossing> crossing(const CurveSegment& segment, const Eigen::Vector3d& from,
                                   const Eigen::Vector3d& to, const Eigen::Vector3d& upward) const;

 private:
  const Polylines& lines_;
  std::vector<CurveSegment> segments_;
  BoxTree tree_;
};

/// Appends the pieces of the path between two nearby places, perpendicular to the surface. If that
/// path does not arrive, appends one piece and moves the place beside its triangle onto it. Pieces
/// no longer than `least` are omitted.
void add_way(const WavePattern& pattern, const SurfaceWays& ways, const TrianglePoint& from,
             const TrianglePoint& to, double least, std::vector<SurfaceWays::Piece>& pieces);

/// Appends the points of a line, with their places, but does not end the line.
void add_points_of(const WavePattern& pattern, const std::vector<SurfaceWays::Piece>& pieces,
                   bool closed, Polylines& to);

/// The pieces of a line.
std::vector<SurfaceWays::Piece> pieces_of(const Polylines& lines, Index line);

}  // namespace brindle
