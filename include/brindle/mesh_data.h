/// Arrays that belong to a mesh: what becomes of them where the mesh or the place changes.
#pragma once

#include "brindle/data_arrays.h"
#include "brindle/export.h"
#include "brindle/mesh.h"

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

}  // namespace brindle
