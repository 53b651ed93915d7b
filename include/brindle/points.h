/// Points without triangles.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/export.h"
#include "brindle/progress.h"
#include "brindle/surface.h"
#include "brindle/types.h"

namespace BRINDLE_EXPORT brindle {

/// Points keep their numbers, so that data per point match; `used` says which of them take part.
struct PointCloud {
  std::vector<Vec3> positions;  ///< finite, relative to `origin`
  std::vector<Vec3> normals;    ///< one unit vector per point, or empty if they are not known
  std::vector<Index> used;      ///< in ascending order: finite, and the first at their place
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< see `Mesh`
};

/// Defects of a list of points.
struct PointRepair {
  std::size_t not_finite = 0;      ///< a coordinate was NaN, infinite or beyond 1e18: set aside
  std::size_t repeated = 0;        ///< stood exactly where an earlier point stands: set aside
  std::size_t without_normal = 0;  ///< of a cloud with normals: zero or not finite, so that the
                                   ///< normals of all points are dropped

  bool operator==(const PointRepair&) const = default;
};

/// One line per finding, as for a report to the user; empty if there are none.
std::string describe(const PointRepair& repair);

struct LoadedPoints {
  PointCloud cloud;
  PointRepair repair;
  /// For every point the first at its place; empty if no two stand at one place.
  std::vector<Index> first_at_place;
  std::vector<DataArray> arrays = {};  ///< what a file says of the points, a row each
  std::string left_out = {};           ///< a line per thing in the file that is not here
};

/// Makes a valid cloud of any positions and normals (one per position, of any length above zero;
/// or none). Positions that are not finite are moved to the centroid of the others. Throws
/// Cancelled if `progress` asks for it.
LoadedPoints make_point_cloud(std::vector<Vec3> positions, std::vector<Vec3> normals = {},
                              const Progress& progress = {});

/// The same of coordinates as a file has them, relative to `origin_near` (local_positions.h).
LoadedPoints make_placed_point_cloud(std::span<const Eigen::Vector3d> positions,
                                     std::vector<Vec3> normals = {}, const Progress& progress = {});

/// Whether this build has nanoflann, which every search for nearby points needs.
bool has_point_trees();

/// Joins each of the `used` points to the `count` nearest others of them; j is a neighbour of i if
/// either is among the nearest of the other. `used` is in ascending order; all other points have no
/// neighbours. Positions are finite and different from each other where used. Of points equally far
/// away any may be taken, the same ones in every run. Throws Error for a count below 1, and in a
/// build without nanoflann; TooLarge, an Error, for neighbours that memory does not hold.
Adjacency point_neighborhood(std::span<const Vec3> positions, std::span<const Index> used,
                             int count, const Progress& progress = {});

/// Joins every point to its `neighbors` nearest and, if the cloud has no normals, fits and orients
/// them. Points that are not used, and those whose neighbours lie on a line, have a zero normal and
/// so carry no wave. Everything that works on a Surface works on the result, from direction fields
/// to `stripe_pattern`; what needs triangles finds none. Throws Error if no point has a normal, for
/// points without normals that fill a volume, and what `point_neighborhood` throws; Cancelled if
/// `progress` asks for it.
Surface make_point_surface(PointCloud cloud, int neighbors = 8, const Progress& progress = {});

}  // namespace brindle
