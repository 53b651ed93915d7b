/// Arrays of a mesh moved to finer meshes, from triangles to vertices, to places, or to another
/// mesh.
#pragma once

#include <span>
#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/polylines.h"
#include "brindle/progress.h"

namespace BRINDLE_EXPORT brindle {

/// An array of triangles moved to the vertices: the mean of the rows of the adjacent triangles,
/// weighted by area, number by number, in double precision. Rows with a non-finite number and
/// triangles without area do not count; a vertex without any other has NaN. Throws Error, naming
/// the array, unless it has a row per triangle.
DataArray cells_to_points(const Mesh& mesh, const DataArray& cells);

/// As `subdivide` of mesh.h, with the mesh's arrays: a midpoint gets the mean of its edge's ends
/// (`blended`), the four parts of a triangle get its row. Throws Error as that does and, naming the
/// array, for one without a row per vertex or triangle; then nothing changes.
void subdivide(Mesh& mesh, DataArrays& arrays, int times = 1, const Progress& progress = {});
void subdivide(Mesh& mesh, DataArrays& arrays, int times, Midpoints midpoints,
               const Progress& progress = {});

/// Arrays at places on the mesh, such as points of curves or samples: first those with a row per
/// vertex, as means of the corners (`blended`), then those with a row per triangle, as the
/// triangle's row.
std::vector<DataArray> arrays_at(std::span<const TrianglePoint> places,
                                 std::span<const Triangle> triangles, const DataArrays& arrays);

/// The rows of another mesh's arrays for every point.
struct NearbyRows {
  std::vector<RowBlend> vertices;  ///< blends at the nearest place
  std::vector<Index> triangles;    ///< that have this place; empty for a mesh without triangles
  std::vector<char> found;         ///< 1, or 0 if no place is near enough; rows are then arbitrary
};

/// The places of `from` nearest to the vertices of `to`, up to `max_distance` away: on its
/// triangles, or vertices if it has none. Origins may differ. Throws Error as `NearestOnMesh` and
/// `NearestVertex` do, and for a mesh without vertices; Cancelled if `progress` cancels.
NearbyRows nearby_rows(const Mesh& from, const Mesh& to, double max_distance,
                       const Progress& progress = {});

/// An array with a row per vertex, carried to every point as a blend of three rows (`blended`), in
/// double precision; NaN where nothing was found. Throws Error, naming the array, if it has fewer
/// rows than `from` had vertices.
DataArray carried_from_points(const DataArray& points, const NearbyRows& rows);

/// As above for an array with a row per triangle: the row of the nearest one. Throws Error also if
/// there are no triangles.
DataArray carried_from_cells(const DataArray& cells, const NearbyRows& rows);

}  // namespace brindle
