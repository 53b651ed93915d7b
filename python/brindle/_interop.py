"""Meshes of other packages, by what they look like, and meshes for these packages. A package is
imported only where one of its objects is there or asked for."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from typing import Any, Mapping, Optional

import numpy as np

from . import _core
from ._arguments import Error

# VTK's numbers of the types of cells that meshio names.
_VTK_TYPES = {"vertex": 1, "line": 3, "triangle": 5, "polygon": 7, "pixel": 8, "quad": 9, "tetra": 10,
              "hexahedron": 12, "wedge": 13, "pyramid": 14, "penta_prism": 15, "hexa_prism": 16,
              "line3": 21, "triangle6": 22, "quad8": 23, "tetra10": 24, "hexahedron20": 25,
              "wedge15": 26, "pyramid13": 27, "quad9": 28, "hexahedron27": 29, "quad6": 30,
              "wedge12": 31, "wedge18": 32, "hexahedron24": 33, "triangle7": 34, "line4": 35}
_POINT_TYPES = (0, 1, 2)
_POLYGON, _UNKNOWN = 7, 255


def package(name: str) -> Any:
    """A package that may be missing. Raises ImportError with the remedy."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        name = name.partition(".")[0]
        raise ImportError(f"{name} is not installed here; install it, such as by 'pip install {name}'",
                          name=name) from error


class Cells:
    """Points, cells of VTK's types over them, and named arrays of a row per point and per cell."""

    def __init__(self, points: Any, types: Any, ends: Any, corners: Any,
                 point_data: Mapping[str, Any], cell_data: Mapping[str, Any]) -> None:
        self.points = _core.unmasked(points)
        if self.points.ndim == 2 and self.points.shape[1] == 2:
            self.points = np.pad(self.points, ((0, 0), (0, 1)))
        self.types = types
        self.ends = ends
        self.corners = corners
        self.point_data = numbers_of(point_data)
        self.cell_data = numbers_of(cell_data)


@dataclass
class Source:
    """The mesh cell of each triangle of the surface."""

    cell_of_triangle: Any
    vertex_count: int
    cell_count: int


def split_source(surface: Any, face_origins: Any) -> Source:
    """Of a surface whose triangles are those of another one, or parts of them."""
    source = surface._source or Source(np.arange(surface.face_count), surface.vertex_count,
                                       surface.face_count)
    return Source(source.cell_of_triangle[face_origins], source.vertex_count, source.cell_count)


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
    """Ends and corners of cells that all have as many corners."""
    faces = np.asarray(faces)
    if faces.ndim != 2 or faces.shape[1] < 1:
        raise Error(f"faces: expected rows of corners, got the shape {faces.shape}")
    if faces.size and faces.dtype.kind not in "iu":
        raise TypeError(f"faces: expected whole numbers, got {faces.dtype}")
    return np.arange(1, len(faces) + 1) * faces.shape[1], faces.ravel()


def padded(faces: Any) -> tuple[Any, Any]:
    """Ends and corners of faces that stand one after the other, each after its number of corners:
    VTK's old layout."""
    faces = np.asarray(faces).ravel()
    kept = np.ones(len(faces), bool)
    ends: list[int] = []
    at = 0
    while at < len(faces):
        if faces[at] < 0 or at + 1 + faces[at] > len(faces):
            raise Error(f"faces: the number of corners at {at} leads beyond the end")
        kept[at] = False
        at += 1 + int(faces[at])
        ends.append(at - len(ends) - 1)
    return np.asarray(ends, np.int64), faces[kept]


def surface_of(mesh: Any) -> "tuple[_core.Surface, Optional[Source]]":
    """The surface of another package's mesh, and which cells its triangles are of."""
    cells = cells_of(mesh)
    if np.isin(cells.types, _POINT_TYPES).all():
        return _core.surface_of_points(cells.points, None, 8, cells.point_data), None
    core, rows = _core.surface_of_cells(cells.points, cells.corners, cells.ends, cells.types,
                                        cells.point_data, cells.cell_data)
    return core, Source(rows, len(cells.points), len(cells.types))


def cells_of(mesh: Any) -> Cells:
    if hasattr(mesh, "GetPointData") and (hasattr(mesh, "GetPolys") or hasattr(mesh, "GetCellTypesArray")):
        return of_vtk(mesh)
    if hasattr(mesh, "points") and hasattr(mesh, "cells") and not hasattr(mesh, "faces"):
        return of_meshio(mesh)
    if hasattr(mesh, "points") and (hasattr(mesh, "regular_faces") or hasattr(mesh, "faces")):
        return of_pyvista(mesh)
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return of_trimesh(mesh)
    raise TypeError(f"{type(mesh).__name__} is no surface: give a brindle.Surface, arrays (V, F), or "
                    "a mesh of pyvista, trimesh, meshio or VTK (vtkPolyData or vtkUnstructuredGrid; of "
                    "other data sets extract the surface first)")


def of_polygons(points: Any, ends_and_corners: tuple[Any, Any], point_data: Any, cell_data: Any) -> Cells:
    ends, corners = ends_and_corners
    return Cells(points, np.full(len(ends), _POLYGON, np.uint8), ends, corners, point_data, cell_data)


def of_pyvista(mesh: Any) -> Cells:
    try:
        faces = rows_alike(mesh.regular_faces)
    except (AttributeError, ValueError):
        faces = padded(mesh.faces)
    return of_polygons(mesh.points, faces, getattr(mesh, "point_data", {}),
                       getattr(mesh, "cell_data", {}))


def of_trimesh(mesh: Any) -> Cells:
    return of_polygons(mesh.vertices, rows_alike(mesh.faces),
                       getattr(mesh, "vertex_attributes", None) or {},
                       getattr(mesh, "face_attributes", None) or {})


def of_meshio(mesh: Any) -> Cells:
    types, ends, corners, end = [], [], [], 0
    for cells in mesh.cells:
        kind, data = (cells.type, cells.data) if hasattr(cells, "type") else tuple(cells)
        known = kind in _VTK_TYPES
        if kind == "wedge":  # whose triangles VTK winds the other way round
            data = np.asarray(data)[:, [0, 2, 1, 3, 5, 4]]
        # Cells of other types have no corners here, and are counted.
        begin, rows = rows_alike(data) if known and len(data) else (np.zeros(len(data), np.int64),
                                                                    np.zeros(0, np.int64))
        types.append(np.full(len(data), _VTK_TYPES.get(kind, _UNKNOWN), np.uint8))
        ends.append(end + begin)
        corners.append(rows)
        end += len(rows)
    cell_data = {name: np.concatenate([np.asarray(block) for block in arrays])
                 for name, arrays in (getattr(mesh, "cell_data", None) or {}).items()}
    return Cells(mesh.points, joined(types, np.uint8), joined(ends, np.int64), joined(corners, np.int64),
                 getattr(mesh, "point_data", None) or {}, cell_data)


def joined(parts: list[Any], kind: Any) -> Any:
    return np.concatenate(parts) if parts else np.zeros(0, kind)


def of_vtk(mesh: Any) -> Cells:
    vtk_to_numpy = package("vtkmodules.util.numpy_support").vtk_to_numpy
    if mesh.GetPoints() is None:
        raise Error(f"the {mesh.GetClassName()} has no points")
    if hasattr(mesh, "GetPolys"):
        groups = [(mesh.GetVerts(), 2), (mesh.GetLines(), 4), (mesh.GetPolys(), 7), (mesh.GetStrips(), 6)]
        types = np.repeat(np.asarray([kind for _, kind in groups], np.uint8),
                          [cells.GetNumberOfCells() for cells, _ in groups])
    else:
        groups = [(mesh.GetCells(), 0)] if mesh.GetNumberOfCells() else []
        types = vtk_to_numpy(mesh.GetCellTypesArray()) if groups else np.zeros(0, np.uint8)
    ends, corners, end = [], [], 0
    for cells, _ in groups:
        if cells.GetNumberOfCells() == 0:
            continue
        ends.append(end + vtk_to_numpy(cells.GetOffsetsArray())[1:])
        corners.append(vtk_to_numpy(cells.GetConnectivityArray()))
        end += len(corners[-1])
    return Cells(vtk_to_numpy(mesh.GetPoints().GetData()), types, joined(ends, np.int64),
                 joined(corners, np.int64), vtk_arrays(mesh.GetPointData()), vtk_arrays(mesh.GetCellData()))


def vtk_arrays(data: Any) -> dict[str, Any]:
    vtk_to_numpy = package("vtkmodules.util.numpy_support").vtk_to_numpy
    arrays = {}
    for number in range(data.GetNumberOfArrays()):
        array = data.GetArray(number)
        if array is not None and array.GetName():
            arrays[array.GetName()] = vtk_to_numpy(array)
    return arrays


# --- arrays of results --------------------------------------------------------------------------


def put_arrays(mesh: Any, surface: Any, points: Mapping[str, Any],
               cells: Mapping[str, Any]) -> Any:
    """Puts arrays on a mesh, by their names. Those of triangles are left out where it is not known
    which cells these are; Error if that leaves nothing."""
    vertices, cell_count = counts_of(mesh)
    own = (surface._source or surface).vertex_count
    if vertices != own:
        raise Error(f"the mesh has {vertices} vertices, the surface of the pattern {own}: it was made "
                    "for another one")
    spread_out = {name: spread(array, surface, cell_count) for name, array in cells.items()}
    cells = {name: array for name, array in spread_out.items() if array is not None}
    if not points and not cells:
        raise Error(f"the mesh has {cell_count} cells, the surface of the pattern "
                    f"{surface.face_count} triangles: it was made for another one")
    put = put_on_vtk if hasattr(mesh, "GetPointData") and not hasattr(mesh, "point_data") else put_on_dicts
    put(mesh, points, cells)
    return mesh


def put_pattern(mesh: Any, surface: Any, points: Mapping[str, Any], cells: Mapping[str, Any],
                prefix: str) -> Any:
    """Puts a pattern's arrays on a mesh, with prefixed names. Replaces only those of an earlier
    pattern, which has "sin_phase"."""
    points = {prefix + name: array for name, array in points.items() if name != "original_id"}
    cells = {prefix + name: array for name, array in cells.items()}
    of_points, of_cells = array_names(mesh)
    taken = sorted((of_points & set(points)) | (of_cells & set(cells)))
    if taken and prefix + "sin_phase" not in of_points & set(points):
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
    cells = cells_of(mesh)
    return len(cells.points), len(cells.types)


def spread(array: Any, surface: Any, cell_count: int) -> Any:
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
    numpy_to_vtk = package("vtkmodules.util.numpy_support").numpy_to_vtk
    for data, arrays in ((mesh.GetPointData(), points), (mesh.GetCellData(), cells)):
        for name, array in arrays.items():
            made = numpy_to_vtk(np.ascontiguousarray(array), deep=1)
            made.SetName(name)
            data.AddArray(made)
    mesh.Modified()


# --- results as meshes of other packages ---------------------------------------------------------


def to_meshio(thing: Any) -> Any:
    """A ``meshio.Mesh`` of a Surface, Stripes, Texture, TexturedMesh, Curves or Samples, with its
    ``point_data`` and ``cell_data``. Raises ImportError without meshio."""
    meshio = package("meshio")
    points, kind, cells, point_data, cell_data = _parts_of(thing)
    return meshio.Mesh(points, [(kind, cells)], point_data=point_data,
                       cell_data={name: [array] for name, array in cell_data.items()})


def to_pyvista(thing: Any) -> Any:
    """A ``pyvista.PolyData`` of what ``to_meshio`` takes; texture coordinates are active. Raises
    ImportError without pyvista."""
    pyvista = package("pyvista")
    points, kind, cells, point_data, cell_data = _parts_of(thing)
    padded_cells = np.insert(cells, 0, cells.shape[1], axis=1).ravel()
    mesh = pyvista.PolyData(points, **{{"triangle": "faces", "line": "lines", "vertex": "verts"}[kind]:
                                       padded_cells})
    for arrays, data in ((mesh.point_data, point_data), (mesh.cell_data, cell_data)):
        for name, array in data.items():
            arrays[name] = array
    if "uv" in point_data:
        mesh.active_texture_coordinates = point_data["uv"]
    return mesh


def to_trimesh(thing: Any) -> Any:
    """A ``trimesh.Trimesh`` of what ``to_meshio`` takes, if that has triangles; vertices keep their
    numbers. Raises ImportError without trimesh."""
    trimesh = package("trimesh")
    points, kind, cells, point_data, cell_data = _parts_of(thing)
    if kind != "triangle":
        raise Error(f"to_trimesh: {type(thing).__name__} has no triangles; take to_pyvista or to_meshio")
    mesh = trimesh.Trimesh(points, cells, process=False, vertex_attributes=point_data,
                           face_attributes=cell_data)
    if "uv" in point_data:
        mesh.visual = trimesh.visual.TextureVisuals(uv=point_data["uv"])
    return mesh


def _parts_of(thing: Any) -> tuple[Any, str, Any, dict[str, Any], dict[str, Any]]:
    """Points, the kind of cells, cells, and arrays of both; copies that can be written to."""
    if not hasattr(thing, "_mesh_parts"):
        raise TypeError(f"{type(thing).__name__}: expected a Surface, Stripes, Texture, TexturedMesh, "
                        "Curves or Samples")
    points, kind, cells, point_data, cell_data = thing._mesh_parts()
    if kind == "triangle" and len(cells) == 0:
        kind, cells = "vertex", np.arange(len(points))[:, None]
    copies = [{name: np.array(array) for name, array in data.items()} for data in (point_data, cell_data)]
    return np.array(points), kind, np.array(cells), copies[0], copies[1]
