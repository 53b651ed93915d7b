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
  /// Where the points are on the mesh, one per point: in the triangle of the segment after it, of
  /// the last point of an open line in that of the segment before. Empty if that is not known.
  std::vector<TrianglePoint> places = {};
  /// Barycentric coordinates of the next point in the same triangle, one per place. Empty if
  /// segments do not run within triangles.
  std::vector<std::array<double, 3>> arrivals = {};

  std::size_t count() const { return closed.size(); }
  std::span<const Vec3> points_of(std::size_t line) const {
    return std::span(points).subspan(offsets[line], offsets[line + 1] - offsets[line]);
  }
  std::span<const Vec3> normals_of(std::size_t line) const {
    return std::span(normals).subspan(offsets[line], offsets[line + 1] - offsets[line]);
  }
};

/// How far `p` is from the segment between `a` and `b`.
float distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b);

/// The length of a line, with the way back if it is closed.
double length_of(const Polylines& lines, std::size_t line);

/// Leaves out points as long as no point left out is farther than `tolerance` from the line
/// (Douglas and Peucker 1973), and with them what is known of their segments. Ends stay; of a
/// closed line two points at least, its first and the one farthest from it.
Polylines simplified(const Polylines& lines, float tolerance, const Progress& progress = {});

/// Points at equal distances along every line, as near to `spacing` as a whole number of steps
/// allows. Ends stay. They lie on the segments, so corners between them are cut; they have places
/// if it is known where the segments run.
/// Throws Error if the spacing is not above zero, or if there would be more points than an Index
/// can count.
Polylines resampled(const Polylines& lines, float spacing, const Progress& progress = {});

struct TubeOptions {
  float radius = 0.01f;  ///< in units of length, above zero
  int sides = 8;         ///< 3 to 64
};

/// A tube around every line: rings of `sides` vertices in the planes that halve the angles between
/// segments, the ends of open lines closed by flat caps. Points nearer to the one before than a
/// tenth of the radius are passed over; lines without length have no tube. Throws Error for options
/// out of range and for more vertices than an Index can count.
Mesh tubes(const Polylines& lines, const TubeOptions& options, const Progress& progress = {});

}  // namespace brindle
