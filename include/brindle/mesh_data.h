/// Arrays that belong to a mesh: on finer meshes, at vertices instead of triangles, and at the
/// vertices of another mesh.
#pragma once

#include <vector>

#include "brindle/data_arrays.h"
#include "brindle/export.h"
#include "brindle/mesh.h"
#include "brindle/progress.h"

namespace BRINDLE_EXPORT brindle {

/// An array of the mesh's triangles moved to its vertices: the mean of the rows of the triangles
/// around a vertex, weighted by their areas, number by number, in double precision. Rows with a
/// number that is not finite and triangles without area do not count; a vertex for which nothing
/// counts has NaN. Throws Error, naming the array, unless it has a row per triangle.
DataArray cells_to_points(const Mesh& mesh, const DataArray& cells);

/// As `subdivide` of mesh.h, with the mesh's arrays: a midpoint has the mean of its edge's ends
/// (`blended`), and the four triangles of a triangle have its row. Throws Error as that does, and,
/// naming the array, for one without a row per vertex or triangle; then nothing was changed.
void subdivide(Mesh& mesh, DataArrays& arrays, int times = 1, const Progress& progress = {});
void subdivide(Mesh& mesh, DataArrays& arrays, int times, Midpoints midpoints,
               const Progress& progress = {});

/// For every point the rows of another mesh's arrays to take.
struct NearbyRows {
  std::vector<RowBlend> vertices;  ///< those of the nearest place
  std::vector<Index> triangles;    ///< where that is; empty for a mesh without triangles
  std::vector<char> found;         ///< 1, or 0 if no place is near enough: the rows are any then
};

/// The places of `from` nearest to the vertices of `to`, up to `max_distance` away: on its
/// triangles, or vertices if it has none. Origins may differ. Throws Error as `NearestOnMesh` and
/// `NearestVertex` do, and for a mesh without vertices; Cancelled if `progress` asks for it.
NearbyRows nearby_rows(const Mesh& from, const Mesh& to, double max_distance,
                       const Progress& progress = {});

/// A row per point of an array with a row per vertex: between vertices the blend of three
/// (`blended`); in double precision, NaN where nothing was found. Throws Error, naming the array,
/// if it has fewer rows than `from` had vertices.
DataArray carried_from_points(const DataArray& points, const NearbyRows& rows);

/// The same of an array with a row per triangle: the row of the nearest one. Throws Error also if
/// there are no triangles.
DataArray carried_from_cells(const DataArray& cells, const NearbyRows& rows);

}  // namespace brindle
