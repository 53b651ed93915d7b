/// Lines of straight segments on a surface.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// A point of a triangle.
struct TrianglePoint {
  Index triangle = 0;
  std::array<double, 3> barycentric{};  ///< not negative, sums to 1
};

/// Line i runs through the points offsets[i] to offsets[i + 1] - 1, and back to the first of them
/// if it is closed (the first point is not repeated).
struct Polylines {
  std::vector<Vec3> points;          ///< relative to `origin`
  std::vector<Vec3> normals;         ///< of the surface, unit vectors, one per point
  std::vector<Index> offsets{0};     ///< lines + 1 entries
  std::vector<std::uint8_t> closed;  ///< one per line: 1 or 0
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< that of the mesh, see `Mesh`
  /// The place of each point on the mesh, in the triangle of the next segment; for the last point
  /// of an open line, of the segment before. Empty if unknown.
  std::vector<TrianglePoint> places = {};
  /// Barycentric coordinates of the next point in the same triangle, one per place. Empty if
  /// segments do not run within triangles.
  std::vector<std::array<double, 3>> arrivals = {};

  /// Appends a point to the line that `end_line` will end.
  void add(const Vec3& point, const Vec3& normal) {
    points.push_back(point);
    normals.push_back(normal);
  }
  void add(const Vec3& point, const Vec3& normal, const TrianglePoint& place,
           const std::array<double, 3>& arrival) {
    add(point, normal);
    places.push_back(place);
    arrivals.push_back(arrival);
  }
  /// Appends points `first` to `end` - 1 of other lines, with their places.
  void add(const Polylines& lines, std::size_t first, std::size_t end);
  void end_line(bool is_closed) {
    offsets.push_back(static_cast<Index>(points.size()));
    closed.push_back(is_closed);
  }

  /// The place at a share, from 0 to 1, of the segment that starts at a point. Needs arrivals.
  TrianglePoint place_on(std::size_t point, double share) const;

  std::size_t count() const { return closed.size(); }
  std::span<const Vec3> points_of(std::size_t line) const {
    return std::span(points).subspan(offsets[line], offsets[line + 1] - offsets[line]);
  }
  std::span<const Vec3> normals_of(std::size_t line) const {
    return std::span(normals).subspan(offsets[line], offsets[line + 1] - offsets[line]);
  }
};

/// The distance of `p` from the segment between `a` and `b`.
float distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b);

/// The length of a line, with the closing segment of a closed one.
double length_of(const Polylines& lines, std::size_t line);

/// Removes points as long as no removed point is farther than `tolerance` from the line (Douglas
/// and Peucker 1973), and the data of their segments. Ends stay; a closed line keeps at least two
/// points, its first and the one farthest from it.
Polylines simplified(const Polylines& lines, float tolerance, const Progress& progress = {});

/// Points at equal distances along every line, as near to `spacing` as a whole number of steps
/// allows. Ends stay. Points lie on the segments, so corners between them are cut. They have places
/// if those of the segments are known. Throws Error if the spacing is not above zero, and for more
/// points than an Index can count.
Polylines resampled(const Polylines& lines, float spacing, const Progress& progress = {});

/// Options of `tubes`.
struct TubeOptions {
  float radius = 0.01f;  ///< in units of length, above zero
  int sides = 8;         ///< 3 to 64
};

/// A tube around every line: rings of `sides` vertices in the planes that halve the angles between
/// segments; flat caps close the ends of open lines. Points nearer to the previous one than a tenth
/// of the radius are skipped; lines without length have no tube. Throws Error for options out of
/// range and for more vertices than an Index can count.
Mesh tubes(const Polylines& lines, const TubeOptions& options, const Progress& progress = {});

}  // namespace brindle
