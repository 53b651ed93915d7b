/// A curve on a mesh, rolled out into the plane; places along it, and how it turns between them.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "brindle/mesh.h"
#include "brindle/polylines.h"

namespace brindle {

using PlanePoint = std::complex<double>;

/// A place on a curve that was rolled out.
struct UnrolledPlace {
  PlanePoint point;
  std::size_t segment;  ///< of the curve
  TrianglePoint place;
  double frequency;
};

/// The length of a line in periods.
double periods_of(const Polylines& lines, Index line, std::span<const float> frequencies);

/// A line whose segments run within triangles, with its lengths and the angles by which it turns
/// within the surface: triangles beside an edge are laid flat. A closed line goes on and on.
class UnrolledCurve {
 public:
  /// `frequencies` has one entry per point of all lines.
  UnrolledCurve(const Mesh& mesh, const Polylines& lines, Index line,
                std::span<const float> frequencies);

  bool closed() const { return closed_; }
  std::size_t segment_count() const { return segments_.size(); }
  double length() const { return length_; }
  double periods() const { return periods_.back(); }
  double periods_at(std::size_t segment, double share) const {
    return periods_[segment] + share * (periods_[segment + 1] - periods_[segment]);
  }

  /// A way from a segment, the first time round: from the plane into the segment's triangle, and
  /// back.
  Eigen::Vector3d in_space(std::size_t segment, const PlanePoint& way) const;
  PlanePoint in_plane(std::size_t segment, const Eigen::Vector3d& way) const;
  /// Unit vectors of a segment: where it runs, and to its left.
  const Eigen::Vector3d& along(std::size_t segment) const { return segments_[segment].along; }
  Eigen::Vector3d leftward(std::size_t segment) const {
    return segments_[segment].normal.cross(segments_[segment].along);
  }
  /// Whether left is right after a round of a closed curve.
  bool changes_sides() const { return second_.mirrored; }

  /// Where a round begins: the rounds before it are turned, and mirrored on a surface that has but
  /// one side.
  struct Round {
    double number = 0;
    PlanePoint start = 0, turn = 1;
    bool mirrored = false;

    PlanePoint turned(const PlanePoint& way) const {
      return turn * (mirrored ? std::conj(way) : way);
    }
  };

  /// Goes along the curve.
  class Walker {
   public:
    explicit Walker(const UnrolledCurve& curve) : curve_(curve) {}

    /// The place so many periods from the start of a round; neither is less than in the call
    /// before.
    UnrolledPlace at(double periods, double round);

   private:
    const UnrolledCurve& curve_;
    Round round_;
    std::size_t segment_ = 0;
  };

 private:
  struct Segment {
    TrianglePoint from;
    std::array<double, 3> to;
    Eigen::Vector3d along = Eigen::Vector3d::Zero();   // unit
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit, on the side that the curve began on
    double length = 0;
    PlanePoint start = 0, heading = 1;  // in the plane
  };

  struct Joint;

  Segment segment_at(const Mesh& mesh, const Polylines& lines, Index point) const;
  static Joint joint(const Mesh& mesh, const Segment& before, const Segment& after);
  void unroll(const Mesh& mesh);
  void measure(const Polylines& lines, Index line, std::span<const float> frequencies);
  Round next(const Round& round) const;
  Round previous(const Round& round) const;

  bool closed_;
  double length_ = 0;
  std::vector<Segment> segments_;
  std::vector<double> periods_;      // before every segment, and of all
  std::vector<double> frequencies_;  // at the same places
  Round second_;                     // of a closed curve
};

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
