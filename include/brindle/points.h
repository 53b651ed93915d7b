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

/// A point cloud. Points keep their numbers, so that data per point match; `used` lists those that
/// take part.
struct PointCloud {
  std::vector<Vec3> positions;  ///< finite, relative to `origin`
  std::vector<Vec3> normals;    ///< one unit vector per point, or empty if unknown
  std::vector<Index> used;      ///< in ascending order: finite, and the first at their position
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< see `Mesh`
};

/// Defects of a list of points.
struct PointRepair {
  std::size_t not_finite = 0;      ///< a coordinate was NaN, infinite or beyond 1e18: set aside
  std::size_t repeated = 0;        ///< at exactly the position of an earlier point: set aside
  std::size_t without_normal = 0;  ///< in a cloud with normals: zero or not finite; the normals of
                                   ///< all points are then dropped

  bool operator==(const PointRepair&) const = default;
};

/// One line per finding, for reports to the user; empty if there are none.
std::string describe(const PointRepair& repair);

/// A cloud with its repairs and the data of its file.
struct LoadedPoints {
  PointCloud cloud;
  PointRepair repair;
  /// For every point, the first at its position; empty if all positions differ.
  std::vector<Index> first_at_place;
  std::vector<DataArray> arrays = {};  ///< of the file, a row per point
  std::string left_out = {};           ///< a line for each part of the file that was not read
};

/// A valid cloud from any positions and normals (one per position, of any length above zero; or
/// none). Positions that are not finite move to the centroid of the others. Throws Cancelled if
/// `progress` cancels.
LoadedPoints make_point_cloud(std::vector<Vec3> positions, std::vector<Vec3> normals = {},
                              const Progress& progress = {});

/// As above from file coordinates, made relative to `origin_near` (local_positions.h).
LoadedPoints make_placed_point_cloud(std::span<const Eigen::Vector3d> positions,
                                     std::vector<Vec3> normals = {}, const Progress& progress = {});

/// Whether this build has nanoflann, which every search for nearby points needs.
bool has_point_trees();

/// Joins each of the `used` points to its `count` nearest others; j is a neighbour of i if either
/// is among the nearest of the other. `used` is in ascending order; all other points have no
/// neighbours. Used positions are finite and differ. Ties are resolved arbitrarily, but equally in
/// every run. Throws Error for a count below 1, and in a build without nanoflann; TooLarge, an
/// Error, for more neighbours than fit in memory.
Adjacency point_neighborhood(std::span<const Vec3> positions, std::span<const Index> used,
                             int count, const Progress& progress = {});

/// Joins every point to its `neighbors` nearest and, if the cloud has no normals, fits and orients
/// them. Unused points, and those whose neighbours lie on a line, have a zero normal and so carry
/// no wave. All functions for a Surface that need no triangles work on the result, from direction
/// fields to `stripe_pattern`. Throws Error if no point has a normal, for points without normals
/// that fill a volume, and what `point_neighborhood` throws; Cancelled if `progress` cancels.
Surface make_point_surface(PointCloud cloud, int neighbors = 8, const Progress& progress = {});

}  // namespace brindle
