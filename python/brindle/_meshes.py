"""Meshes of other packages, by what they look like. None of the packages is imported unless one of
its objects is there."""

from __future__ import annotations

from typing import Any, Mapping

import numpy as np

from . import _core
from ._arguments import Error
from ._surface import Surface

_CORNERS = {"triangle": 3, "quad": 4, "triangle6": 3, "triangle7": 3, "quad8": 4, "quad9": 4}


class Polygons:
    """Vertices, polygons, and named arrays with a row per vertex and per polygon."""

    def __init__(self, vertices: Any, offsets: Any, corners: Any, point_data: Mapping[str, Any],
                 cell_data: Mapping[str, Any], cell_rows: Any = None, cell_count: int = 0) -> None:
        self.vertices = _core.unmasked(vertices)
        if self.vertices.ndim == 2 and self.vertices.shape[1] == 2:
            self.vertices = np.pad(self.vertices, ((0, 0), (0, 1)))
        self.offsets = offsets
        self.corners = corners
        self.point_data = numbers_of(point_data)
        self.cell_data = numbers_of(cell_data)
        # The row of each polygon among all cells of the mesh, and their number.
        polygons = len(offsets) - 1
        self.cell_rows = np.arange(polygons) if cell_rows is None else cell_rows
        self.cell_count = cell_count or polygons


class Source:
    """The mesh cell of each triangle of the surface."""

    def __init__(self, cell_of_triangle: Any, cell_count: int) -> None:
        self.cell_of_triangle = cell_of_triangle
        self.cell_count = cell_count


def numbers_of(arrays: Mapping[str, Any]) -> dict[str, Any]:
    """The arrays of real numbers, reshaped to rows."""
    result = {}
    for name in arrays.keys():
        array = _core.unmasked(arrays[name])
        if array.ndim > 2:
            array = array.reshape(len(array), -1)
        if array.dtype.kind in "fiub" and array.ndim in (1, 2) and array.size > 0:
            result[str(name)] = array
    return result


def rows_alike(faces: Any) -> tuple[Any, Any]:
    """Offsets and corners of faces with equal numbers of corners."""
    faces = np.asarray(faces)
    if faces.ndim != 2 or faces.shape[1] < 3:
        raise Error(f"faces: expected rows of three corners or more, got the shape {faces.shape}")
    if faces.size and faces.dtype.kind not in "iu":
        raise TypeError(f"faces: expected whole numbers, got {faces.dtype}")
    return np.arange(0, faces.size + 1, faces.shape[1]), faces.ravel()


def padded(faces: Any) -> tuple[Any, Any]:
    """Offsets and corners of a sequence of faces, each after its number of corners: VTK's old
    layout."""
    faces = np.asarray(faces).ravel()
    kept = np.ones(len(faces), bool)
    offsets, at = [0], 0
    while at < len(faces):
        if faces[at] < 0 or at + 1 + faces[at] > len(faces):
            raise Error(f"faces: the number of corners at {at} leads beyond the end")
        kept[at] = False
        at += 1 + int(faces[at])
        offsets.append(at - len(offsets))
    return np.asarray(offsets), faces[kept]


def surface_of(mesh: Any) -> Surface:
    """As `as_surface`, for meshes of other packages."""
    polygons = polygons_of(mesh)
    if len(polygons.offsets) < 2:
        points = Surface._of(_core.surface_of_points(polygons.vertices, None, 8, polygons.point_data))
        return points
    triangles, polygon, crossed = _core.triangles_of_polygons(polygons.vertices, polygons.offsets,
                                                              polygons.corners)
    rows = polygons.cell_rows[polygon]
    surface = Surface(polygons.vertices, triangles, repair=True, point_data=polygons.point_data,
                      cell_data={name: array[rows] for name, array in polygons.cell_data.items()})
    surface._core.left_out = crossed
    kept = surface._core.kept_triangles
    surface._source = Source(rows[kept] if len(kept) else rows, polygons.cell_count)
    return surface


def polygons_of(mesh: Any) -> Polygons:
    if hasattr(mesh, "GetPolys") and hasattr(mesh, "GetPointData"):
        return of_vtk(mesh)
    if hasattr(mesh, "points") and hasattr(mesh, "cells") and not hasattr(mesh, "faces"):
        return of_meshio(mesh)
    if hasattr(mesh, "points") and (hasattr(mesh, "regular_faces") or hasattr(mesh, "faces")):
        return of_pyvista(mesh)
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return of_trimesh(mesh)
    raise TypeError(f"{type(mesh).__name__} is no surface: give a brindle.Surface, arrays (V, F), or "
                    "a mesh of pyvista, trimesh, meshio or VTK (vtkPolyData; of other data sets "
                    "extract the surface first)")


def of_pyvista(mesh: Any) -> Polygons:
    try:
        offsets, corners = rows_alike(mesh.regular_faces)
    except (AttributeError, ValueError):
        offsets, corners = padded(mesh.faces)
    return Polygons(mesh.points, offsets, corners, getattr(mesh, "point_data", {}),
                    getattr(mesh, "cell_data", {}))


def of_trimesh(mesh: Any) -> Polygons:
    return Polygons(mesh.vertices, *rows_alike(mesh.faces),
                    getattr(mesh, "vertex_attributes", None) or {},
                    getattr(mesh, "face_attributes", None) or {})


def of_meshio(mesh: Any) -> Polygons:
    offsets, corners, rows, row = [np.zeros(1, np.int64)], [], [], 0
    blocks = [(cells.type, cells.data) if hasattr(cells, "type") else tuple(cells)
              for cells in mesh.cells]
    for kind, data in blocks:
        size = _CORNERS.get(kind)
        if size is not None or kind == "polygon":
            data = np.asarray(data)
            begin, ends = rows_alike(data[:, :size] if size else data)
            offsets.append(begin[1:] + offsets[-1][-1])
            corners.append(ends)
            rows.append(np.arange(row, row + len(data)))
        row += len(data)
    if not corners and any(kind not in ("vertex", "line") for kind, _ in blocks):
        raise Error(f"the mesh has no faces, but {', '.join(kind for kind, _ in blocks)}: extract "
                    "its surface first")
    cells = {name: np.concatenate([np.asarray(block) for block in arrays])
             for name, arrays in (getattr(mesh, "cell_data", None) or {}).items()}
    nothing = np.zeros(0, np.int64)
    return Polygons(mesh.points, np.concatenate(offsets), np.concatenate(corners or [nothing]),
                    getattr(mesh, "point_data", None) or {}, cells,
                    np.concatenate(rows or [nothing]), row)


def of_vtk(mesh: Any) -> Polygons:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    points = mesh.GetPoints()
    if points is None:
        raise Error("the vtkPolyData has no points")
    if mesh.GetNumberOfStrips() > 0:
        raise Error("the vtkPolyData has triangle strips: let vtkTriangleFilter make triangles")
    polys = mesh.GetPolys()
    offsets = vtk_to_numpy(polys.GetOffsetsArray())
    corners = vtk_to_numpy(polys.GetConnectivityArray())
    if len(offsets) == 0:
        offsets = np.zeros(1, np.int64)
    first = mesh.GetNumberOfVerts() + mesh.GetNumberOfLines()
    rows = first + np.arange(len(offsets) - 1)
    return Polygons(vtk_to_numpy(points.GetData()), offsets, corners,
                    vtk_arrays(mesh.GetPointData()), vtk_arrays(mesh.GetCellData()), rows,
                    mesh.GetNumberOfCells())


def vtk_arrays(data: Any) -> dict[str, Any]:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    arrays = {}
    for number in range(data.GetNumberOfArrays()):
        array = data.GetArray(number)
        if array is not None and array.GetName():
            arrays[array.GetName()] = vtk_to_numpy(array)
    return arrays


# --- arrays of results --------------------------------------------------------------------------


def put_arrays(mesh: Any, surface: Surface, points: Mapping[str, Any],
               cells: Mapping[str, Any]) -> Any:
    """Puts named arrays on a mesh."""
    vertices, cell_count = counts_of(mesh)
    if vertices != surface.vertex_count:
        raise Error(f"the mesh has {vertices} vertices, the pattern {surface.vertex_count}: it was "
                    "made for another one")
    cells = {name: spread(array, surface, cell_count) for name, array in cells.items()}
    cells = {name: array for name, array in cells.items() if array is not None}
    put = put_on_vtk if hasattr(mesh, "GetPointData") and not hasattr(mesh, "point_data") else put_on_dicts
    put(mesh, points, cells)
    return mesh


def put_pattern(mesh: Any, surface: Surface, points: Mapping[str, Any], cells: Mapping[str, Any],
                prefix: str) -> Any:
    """Puts a pattern's arrays on a mesh, with prefixed names. Replaces only those of an earlier
    pattern, which has "sin_phase"."""
    points = {prefix + name: array for name, array in points.items() if name != "original_id"}
    cells = {prefix + name: array for name, array in cells.items()}
    of_points, of_cells = array_names(mesh)
    taken = sorted((of_points & set(points)) | (of_cells & set(cells)))
    if taken and prefix + "sin_phase" not in of_points:
        raise Error(f"the mesh has arrays {', '.join(taken)} already, which would be replaced; keep them "
                    "with prefix=\"stripes_\"")
    return put_arrays(mesh, surface, points, cells)


def array_names(mesh: Any) -> tuple[set[str], set[str]]:
    """Names of a mesh's point and cell arrays."""
    if hasattr(mesh, "point_data"):
        return set(mesh.point_data), set(mesh.cell_data)
    if hasattr(mesh, "vertex_attributes"):
        return set(mesh.vertex_attributes), set(mesh.face_attributes)
    points, cells = ({data.GetArrayName(i) for i in range(data.GetNumberOfArrays())}
                     for data in (mesh.GetPointData(), mesh.GetCellData()))
    return points, cells


def counts_of(mesh: Any) -> tuple[int, int]:
    if hasattr(mesh, "GetNumberOfPoints"):
        return mesh.GetNumberOfPoints(), mesh.GetNumberOfCells()
    polygons = polygons_of(mesh)
    return len(polygons.vertices), polygons.cell_count


def spread(array: Any, surface: Surface, cell_count: int) -> Any:
    """Expands rows of triangles to rows of the mesh's cells: the maximum over a polygon's
    triangles; NaN or 0 for other cells. None if the cells are unknown."""
    source = surface._source
    if not isinstance(source, Source):
        return array if len(array) == cell_count else None
    if source.cell_count != cell_count:
        return None
    empty = np.nan if array.dtype.kind == "f" else 0
    rows = np.full((cell_count, *array.shape[1:]), empty, array.dtype)
    if array.ndim > 1:  # corners of triangles are not those of the polygon
        whole = np.bincount(source.cell_of_triangle, minlength=cell_count) == 1
        kept = whole[source.cell_of_triangle]
        rows[source.cell_of_triangle[kept]] = array[kept]
    else:
        np.maximum.at(rows, source.cell_of_triangle, array)
    return rows


def put_on_dicts(mesh: Any, points: Mapping[str, Any], cells: Mapping[str, Any]) -> None:
    if hasattr(mesh, "point_data"):
        point_data, cell_data = mesh.point_data, mesh.cell_data
    else:
        point_data, cell_data = mesh.vertex_attributes, mesh.face_attributes
    for name, array in points.items():
        point_data[name] = np.array(array)
    in_blocks = hasattr(mesh, "cells") and not hasattr(mesh, "faces")
    for name, array in cells.items():
        cell_data[name] = blocks_of(mesh, array) if in_blocks else np.array(array)


def blocks_of(mesh: Any, array: Any) -> list[Any]:
    """Splits an array over all cells of a meshio mesh into blocks."""
    sizes = [len(cells.data) if hasattr(cells, "data") else len(cells[1]) for cells in mesh.cells]
    return [np.array(part) for part in np.split(array, np.cumsum(sizes)[:-1])]


def put_on_vtk(mesh: Any, points: Mapping[str, Any], cells: Mapping[str, Any]) -> None:
    from vtkmodules.util.numpy_support import numpy_to_vtk
    for data, arrays in ((mesh.GetPointData(), points), (mesh.GetCellData(), cells)):
        for name, array in arrays.items():
            made = numpy_to_vtk(np.ascontiguousarray(array), deep=1)
            made.SetName(name)
            data.AddArray(made)
    mesh.Modified()
