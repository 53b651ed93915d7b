/// A curve on a mesh, unrolled into the plane: places along it and its turning angles.
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

/// A place on an unrolled curve.
struct UnrolledPlace {
  PlanePoint point;
  std::size_t segment;  ///< of the curve
  TrianglePoint place;
  double frequency;
};

/// The length of a line in periods.
double periods_of(const Polylines& lines, Index line, std::span<const float> frequencies);

/// A line whose segments lie within triangles, with its lengths and its turning angles within the
/// surface: triangles beside an edge are flattened. A closed line repeats endlessly.
class UnrolledCurve {
 public:
  /// `frequencies` has one entry per point of all lines.
  UnrolledCurve(const Mesh& mesh, const Polylines& lines, Index line,
                std::span<const float> frequencies);

  bool closed() const { return closed_; }
  double length() const { return length_; }
  double periods() const { return periods_.back(); }
  double periods_at(std::size_t segment, double share) const {
    return periods_[segment] + share * (periods_[segment + 1] - periods_[segment]);
  }

  /// Maps vectors at a segment (first round) from the plane into the segment's triangle, and back.
  Eigen::Vector3d in_space(std::size_t segment, const PlanePoint& way) const;
  PlanePoint in_plane(std::size_t segment, const Eigen::Vector3d& way) const;
  /// Unit vectors along a segment and to its left.
  const Eigen::Vector3d& along(std::size_t segment) const { return segments_[segment].along; }
  Eigen::Vector3d leftward(std::size_t segment) const {
    return segments_[segment].normal.cross(segments_[segment].along);
  }
  /// Whether a round of a closed curve swaps left and right.
  bool changes_sides() const { return second_.mirrored; }

  /// The placement of a round in the plane; rounds are mirrored on one-sided surfaces.
  struct Round {
    double number = 0;
    PlanePoint start = 0, turn = 1;
    bool mirrored = false;

    PlanePoint turned(const PlanePoint& way) const {
      return turn * (mirrored ? std::conj(way) : way);
    }
  };

  /// Walks along the curve.
  class Walker {
   public:
    explicit Walker(const UnrolledCurve& curve) : curve_(curve) {}

    /// The place at `periods` from the start of a round. Calls must not go backwards.
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
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit, on the side where the curve begins
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
  std::vector<double> periods_;      // at the start of every segment, and in total
  std::vector<double> frequencies_;  // at the same places
  Round second_;                     // the second round of a closed curve
};

inline constexpr double kStationStep = 0.05;  // periods
inline constexpr std::size_t kStationsPerPeriod = 20;

/// A place on a curve, with the curve's direction.
struct Station {
  double periods;
  UnrolledPlace place;
  Eigen::Vector3d position, along, left;
};

/// Stations at equal steps between two positions in periods, without those beyond an end. Empty for
/// a closed curve that would be passed twice or changes sides.
std::vector<Station> stations(const Mesh& mesh, const UnrolledCurve& curve, double from, double to);

/// Stations going back from an end of an open curve, at most `farthest` periods and to its middle;
/// none if it is too short.
std::vector<Station> back_from_end(const Mesh& mesh, const UnrolledCurve& curve, std::size_t end,
                                   double farthest);

/// Whether a curve turns by more than `most` radians within the period before a station. Stations
/// are ordered backwards along the curve.
bool has_turned(const UnrolledCurve& curve, const std::vector<Station>& own, std::size_t station,
                double most);

/// The angle in radians between the last step of a path and the curve one period before. The path
/// begins at a station and has one place per step.
double turn_at_end(const Mesh& mesh, const std::vector<TrianglePoint>& places, std::size_t end,
                   const std::vector<Station>& own, std::size_t station);

}  // namespace brindle
