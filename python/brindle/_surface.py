"""Surfaces: meshes and points, with fields and arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import (Arrays, Curvature, Error, Floats, Indices, Progress, TensorAxis, TensorOrder,
                         distance, flag, number, numbers_of, path_of, warn, whole_number, word)
from ._interop import surface_of
from ._look import Drawn
from ._options import Look, one_frequency, previous_of


@dataclass
class Stroke:
    """A line near a surface that guides a smooth field: ``points`` (k, 3), at least two,
    ``radius`` of its influence, in units of length, and ``strength``."""

    points: Any
    radius: float
    strength: float = 1.0

    def _parts(self) -> tuple[Any, float, float]:
        return self.points, number(self.radius, "radius"), number(self.strength, "strength")


def _parts_of(strokes: Any) -> list[tuple[Any, float, float]]:
    strokes = [strokes] if isinstance(strokes, Stroke) else list(strokes)
    for stroke in strokes:
        if not isinstance(stroke, Stroke):
            raise TypeError(f"strokes: expected brindle.Stroke, got {type(stroke).__name__}")
    return [stroke._parts() for stroke in strokes]


def last_field(previous: Any, directions: Any = None) -> Any:
    """The parts of a field before; None if there is none. ``directions``: those of the field of a
    pattern, if not those of its waves."""
    previous = previous_of(previous)
    if previous is None:
        return None
    pattern, max_distance = previous.pattern, previous.max_distance
    if pattern is None:
        raise Error(f"{'match' if previous.match else 'max_distance'} has no effect here: no field is "
                    "followed; give its directions or Stripes")
    if isinstance(getattr(pattern, "_core", None), _core.Stripes):
        surface, max_distance = pattern.surface, pattern._spacing() if max_distance is None else max_distance
        directions = pattern.directions if directions is None else directions
    elif isinstance(pattern, tuple) and len(pattern) == 2 and isinstance(pattern[0], Surface):
        surface, directions = pattern
    else:
        raise TypeError("previous: expected a pair of a brindle.Surface and its directions, or "
                        "brindle.Stripes")
    return (surface._core, directions, float("inf") if max_distance is None else max_distance,
            previous.match or "")


def read_strokes(path: Any) -> list[Stroke]:
    """Reads the strokes of a JSON file, as for the tool's ``--strokes``."""
    return [Stroke(*parts) for parts in _core.read_strokes(path_of(path))]


def write_strokes(path: Any, strokes: Sequence[Stroke]) -> None:
    """Writes strokes as JSON, atomically."""
    _core.write_strokes(path_of(path), _parts_of(strokes))


class Loop(NamedTuple):
    """A closed path along the edges of a surface."""

    name: str  #: "boundary-1" and so on, "loop-1" and so on for loops around handles
    boundary: bool
    vertices: Any  #: (k,) in order, the first not repeated
    length: float
    component: int  #: number of its connected component, from 0


class Surface(Drawn):
    """A surface of triangles, or of points without triangles.

    ``Surface(V, F)`` takes n vertices and m triangles: numeric arrays of shape (n, 3) and (m, 3)
    in any memory order; faces are triangles, vertex numbers from 0. Vertices and faces keep their
    numbers. The arrays are copied once, as packed floats.

    ``repair=True`` repairs as reading a file does: invalid triangles are dropped (corners out of
    range or not finite, repeated corners, no area, duplicates), and vertices at one position are
    joined (``s.joined``); ``s.repair`` counts the changes. Without it, these are errors, except
    for triangles without area and vertices at one position. A mesh that is split along edges,
    where stripes would end, gives a PatternWarning.

    ``crease_angle``, in degrees: 40 gives vertices on sharp edges one wave per face, as ``read``
    does; the copies follow the n vertices (``s.crease_vertices``). 180, the default here: none.

    ``point_data`` and ``cell_data`` are named arrays with a row per vertex and per triangle.

    Raises brindle.Error for coordinates that are not finite, corners out of range and arrays of
    another shape, TypeError for other than real numbers.

    Surfaces are immutable; their arrays share memory and are read-only.
    """

    __slots__ = ("_core", "_source", "__weakref__")

    def __init__(self, vertices: ArrayLike, faces: ArrayLike, *, repair: bool = False,
                 crease_angle: float = 180, point_data: Optional[Mapping[str, ArrayLike]] = None,
                 cell_data: Optional[Mapping[str, ArrayLike]] = None) -> None:
        self._core = _core.surface_of_arrays(vertices, faces, dict(point_data or {}),
                                             dict(cell_data or {}), flag(repair, "repair"),
                                             number(crease_angle, "crease_angle"))
        self._source: Any = None
        if not repair:
            warn(self._core.split_warning)

    @classmethod
    def _of(cls, core: "_core.Surface", source: Any = None) -> Surface:
        surface = cls.__new__(cls)
        surface._core = core
        surface._source = source
        return surface

    def __repr__(self) -> str:
        kind = "points" if self.is_points else f"vertices, {self.face_count} triangles"
        return f"<brindle.Surface {self.name}: {self.vertex_count} {kind}, diagonal {self.diagonal:.4g}>"

    def _drawn(self, surface: Surface, picture: _core.Picture, look: Look, tile: Any) -> Any:
        return _core.render(surface._core, None, picture)

    def _mesh_parts(self) -> tuple[Any, ...]:
        return self.vertices, "triangle", self.faces, self.point_data, self.cell_data

    # --- properties ---------------------------------------------------------------------------

    @property
    def name(self) -> str:
        """The file, "shape:..." or "arrays"."""
        return self._core.name

    @property
    def is_points(self) -> bool:
        """Whether there are no triangles."""
        return self._core.is_points

    @property
    def vertex_count(self) -> int:
        """n, the number of vertices."""
        return self._core.vertex_count

    @property
    def face_count(self) -> int:
        """m, the number of triangles."""
        return self._core.face_count

    @property
    def edge_count(self) -> int:
        """The number of pairs of neighbours."""
        return self._core.edge_count

    @property
    def diagonal(self) -> float:
        """The diagonal of the bounding box, in the units of the vertices."""
        return self._core.diagonal

    @property
    def vertices(self) -> NDArray[np.floating]:
        """(n, 3) positions: float32 in shared memory or, for coordinates that are large compared
        to the size, float64."""
        return self._core.vertices

    @property
    def faces(self) -> Indices:
        """(m, 3) vertex numbers; shares memory."""
        return self._core.faces

    @property
    def normals(self) -> Floats:
        """(n, 3) unit normals, zero if undefined; shares memory."""
        return self._core.normals

    @property
    def origin(self) -> tuple[float, float, float]:
        """The origin of the library's floats: 0, 0, 0 unless coordinates are large."""
        return self._core.origin

    @property
    def neighbors(self) -> tuple[Indices, Indices]:
        """Offsets (n + 1,) and vertex numbers: the neighbours of vertex i are at offsets[i] up to
        offsets[i + 1]."""
        return self._core.neighbor_offsets, self._core.neighbors

    @property
    def point_data(self) -> Arrays:
        """Named arrays with a row per vertex, in the type of the file or object; share memory."""
        return self._core.point_data

    @property
    def cell_data(self) -> Arrays:
        """Named arrays with a row per triangle."""
        return self._core.cell_data

    @property
    def repair(self) -> dict[str, int]:
        """Counts of repairs by kind. Vertices without triangles are kept."""
        return self._core.repair

    @property
    def joined(self) -> Indices:
        """(n,) the vertex that replaces each one: itself, or the first at the same position.
        Empty if no vertices were joined."""
        return self._core.joined

    @property
    def crease_vertices(self) -> Indices:
        """(k,) the sources of the last k vertices, which ``crease_angle`` copied, one per face at
        a sharp edge."""
        return self._core.crease_vertices

    @property
    def notes(self) -> str:
        """Lines about repairs and parts of the file that were left out."""
        return self._core.left_out + self._core.repair_text

    def curvature(self) -> tuple[NDArray, NDArray, NDArray, NDArray]:
        """Principal curvatures, of larger absolute value (n,) and smaller (n,), in 1 / length,
        and their unit directions (n, 3) and (n, 3)."""
        return self._core.curvature()

    # --- derived surfaces --------------------------------------------------------------------

    def subdivide(self, times: int = 1, *, rounded: bool = False) -> Surface:
        """The surface with every triangle split in four, ``times`` times; arrays are
        interpolated. ``rounded``: triangles bend with the normals at their corners, which rounds
        coarse meshes; edges that bend by more than 40 degrees stay."""
        return Surface._of(self._core.subdivide(whole_number(times, "times"),
                                                 _rounded(rounded, times)))

    def with_vertices(self, vertices: ArrayLike) -> Surface:
        """The same triangles with vertices at other positions (n, 3)."""
        return Surface._of(self._core.with_vertices(vertices), self._source)

    # --- fields -------------------------------------------------------------------------------

    def smooth_field(self, *, symmetry: int = 2, curvature_anchor: float = 0,
                     curvature: Curvature = "max", feature_anchor: float = 0, feature_angle: float = 40,
                     feature_radius: float = 0, normal_radius: float = 0,
                     strokes: Union[Stroke, Sequence[Stroke]] = (), previous: Any = None) -> Floats:
        """(n, 3) unit tangent vectors of the smoothest field.

        ``symmetry``: 1 vectors, 2 lines, 4 crosses. ``curvature_anchor``: attraction to principal
        curvature (``curvature``: "max" or "min"); ``feature_anchor``: attraction to edges that
        bend by more than ``feature_angle`` degrees, within ``feature_radius`` of them (0: only at
        their vertices). ``normal_radius``: ignores surface detail below this size, by averaged
        normals (0: none). ``strokes``: lines that the field follows (``brindle.Stroke``), for
        even symmetries.

        ``previous``: the last field, which this one starts from and stays near to: a pair of the
        Surface before it moved and its (n, 3) directions, or Stripes, for the directions of its
        waves; in a ``brindle.Previous`` with ways to match vertices.
        """
        if getattr(previous, "stiffness", None) is not None:
            raise Error("stiffness has no effect here: it is for phases of stripes")
        return self._smooth_field(symmetry, curvature_anchor, curvature, feature_anchor,
                                  feature_angle, feature_radius, normal_radius, strokes,
                                  last_field(previous))[0]

    def _smooth_field(self, symmetry: Any = 2, curvature_anchor: Any = 0, curvature: Any = "max",
                      feature_anchor: Any = 0, feature_angle: Any = 40, feature_radius: Any = 0,
                      normal_radius: Any = 0, strokes: Any = (), last: Any = None) -> Any:
        """The field, and its mean rotation since ``last`` in degrees, or None."""
        return _core.smooth_field(self._core, whole_number(symmetry, "symmetry"),
                                  number(curvature_anchor, "curvature_anchor"),
                                  word(curvature, "curvature"),
                                  number(feature_anchor, "feature_anchor"),
                                  number(feature_angle, "feature_angle"),
                                  number(feature_radius, "feature_radius"),
                                  number(normal_radius, "normal_radius"), _parts_of(strokes), last)

    def stroke_anchors(self, strokes: Sequence[Stroke]
                       ) -> tuple[Indices, Floats, Floats]:
        """Constraints by strokes: vertices (k,), directions (k, 3) and weights (k,), for
        ``FieldAnimator.frame``."""
        return _core.stroke_anchors(self._core, _parts_of(strokes))

    def projected_field(self, axis: Sequence[float]) -> Floats:
        """(n, 3): one non-zero vector, projected into every tangent plane."""
        if not hasattr(axis, "__iter__"):
            raise TypeError(f"axis: expected three numbers, got {type(axis).__name__}")
        x, y, z = numbers_of(axis, "axis", "three numbers", 3)
        return _core.projected_field(self._core, x, y, z)

    def curvature_field(self, which: Curvature = "max", *, anchor: float = 0.1, raw: bool = False,
                        symmetry: int = 2, feature_anchor: float = 0, feature_angle: float = 40,
                        feature_radius: float = 0,
                        normal_radius: float = 0) -> Floats:
        """(n, 3): directions of larger ("max") or smaller ("min") absolute principal curvature.

        This is the smooth field with the curvature anchor ``anchor``, as ``--field curvature`` of
        the tool; ``symmetry``, the feature arguments and ``normal_radius`` are those of
        ``smooth_field``. ``raw=True`` gives the unsmoothed directions.
        """
        if flag(raw, "raw"):
            if (symmetry, feature_anchor, feature_angle, feature_radius, normal_radius) != (2, 0, 40, 0, 0):
                raise Error("raw: directions as they are measured are drawn to nothing, and are lines; "
                            "leave symmetry, normal_radius and what draws to features out")
            return _core.raw_curvature_field(self._core, word(which, "which"))
        if not number(anchor, "anchor") > 0:
            raise Error("anchor: 0 leaves nothing of curvature; take smooth_field")
        return self.smooth_field(symmetry=symmetry, curvature_anchor=anchor, curvature=which,
                                 feature_anchor=feature_anchor, feature_angle=feature_angle,
                                 feature_radius=feature_radius, normal_radius=normal_radius)

    def array_field(self, vectors: Union[str, ArrayLike]) -> Floats:
        """(n, 3): vectors of any length projected into the tangent planes.

        ``vectors`` are (n, 3) or, in the x-y plane, (n, 2); or the name of such an array:
        "velocity", "points/velocity", "cells/velocity" (transferred to the vertices, see
        ``axes``). Zero, NaN and normal vectors give zero: no wave.
        """
        name, array = ((vectors, self.axes(vectors)) if isinstance(vectors, str)
                       else ("directions", vectors))
        return _core.array_field(self._core, name, array)[0]

    def tensor_field(self, tensors: Union[str, ArrayLike],
                     axis: TensorAxis = "major", order: TensorOrder = "vtk") -> Floats:
        """(n, 3): along an eigenvector of symmetric tensors: (n, 6) in VTK's order XX, YY, ZZ, XY,
        YZ, XZ, (n, 9) or (n, 3, 3), or the name of an array. ``axis``: "major", "minor",
        "max-abs", or "tangent-major" or "tangent-minor" of the part within the surface.
        ``order``: "vtk", "voigt" (XX, YY, ZZ, YZ, XZ, XY) or "plane": XX, YY, XY, or (n, 4)."""
        name, array = self._array(tensors, "tensors")
        return _core.tensor_field(self._core, name, flat_tensors(array), word(axis, "axis"),
                                  word(order, "order"))[0]

    def rotate_field(self, directions: ArrayLike, degrees: float = 90) -> Floats:
        """(n, 3): directions rotated about the normals, counter-clockwise seen from outside."""
        return _core.rotate_field(self._core, directions, number(degrees, "degrees"))

    def frequencies_by(self, array: Union[str, ArrayLike], *, stripes: Any = None,
                       frequency: Any = None, spacing: Optional[float] = None,
                       range: tuple[float, float] = (0.4, 2.5),
                       inverse: bool = False) -> Floats:
        """(n,) frequencies, in stripes per unit length, denser where ``array`` (n,) is larger (of
        vectors: longer): ``frequency``, or that of ``stripes`` or ``spacing``, times
        the factors of ``range`` at its smallest and largest number. NaN where the array is."""
        stripes, frequency = one_frequency(stripes, frequency, spacing)
        if frequency is None:
            frequency = self.frequency_of(stripes)
        name, values = self._array(array, "array")
        lowest, highest = numbers_of(range, "range", "two factors, the smaller one first, such as "
                                     "(0.4, 2.5)", 2)
        return _core.frequencies_by(self._core, name, values, number(frequency, "frequency"),
                                    (lowest, highest), flag(inverse, "inverse"))

    def globe_vectors(self, east_north: ArrayLike) -> Floats:
        """(n, 3) vectors from east and north components ``east_north`` (n, 2) on a globe, or a
        part of one, around the origin with axis z. NaN at the poles."""
        return _core.globe_vectors(self._core, east_north)

    def frequency_of(self, stripes: float) -> float:
        """The frequency, in stripes per unit length, of ``stripes`` along the bounding box's
        diagonal."""
        return _core.frequency_of_stripes(self._core, number(stripes, "stripes"))

    # --- loops ---------------------------------------------------------------------------

    def loops(self) -> list[Loop]:
        """All boundaries, then two loops per handle."""
        return [Loop(*parts) for parts in _core.loops(self._core)]

    def waves_around(self, reference: ArrayLike, periods: int,
                    loop: str = "") -> tuple[Floats, Floats]:
        """Directions (n, 3) and frequencies (n,) of waves without branches that have exactly
        ``periods`` periods around a loop, such as the wales of a sleeve. ``reference``: (n, 3)
        directions along the loop; ``loop``: its name, if there are several."""
        return _core.waves_around(self._core, reference, word(loop, "loop"),
                                 whole_number(periods, "periods"))

    # --- arrays -------------------------------------------------------------------------------

    def array(self, name: str) -> NDArray[Any]:
        """The array of that name with a row per vertex: "speed", "points/speed", or
        "cells/speed", which is transferred to the vertices. Raises Error with all names if there
        is none."""
        found, array, is_of_cells = self._core.array_named(word(name, "name"))
        return self.cells_to_points(array, found) if is_of_cells else array

    def axes(self, name: str) -> NDArray[Any]:
        """As ``array`` for vectors up to sign, such as fibres: rows that are means, after
        ``subdivide`` or of cells, are means of axes. Patterns along a named array use this."""
        return self._core.axes_named(word(name, "name"))

    def cells_to_points(self, cells: ArrayLike, name: str = "array", *,
                        axes: bool = False) -> NDArray[Any]:
        """Transfers an array with a row per triangle to the vertices, by means weighted by area;
        ``axes``: for vectors up to sign."""
        return self._core.cells_to_points(name, cells, flag(axes, "axes"))

    def interpolate_to(self, target: Any, array: Union[str, ArrayLike],
                       max_distance: float = float("inf"), *, axes: bool = False) -> NDArray[Any]:
        """An array of this surface, or its name, at the vertices of another one: from the nearest
        place, or NaN where that is farther than ``max_distance``. With ``axes``, signs of vectors
        do not count."""
        return self._core.interpolate_to(*self._own_array(array), as_surface(target)._core,
                                         distance(max_distance, "max_distance"), flag(axes, "axes"))

    def nearest(self, points: ArrayLike, max_distance: float = float("inf")
                ) -> tuple[Indices, NDArray[np.float64], NDArray[np.float64]]:
        """The nearest points on the surface to k points (k, 3): triangles (k,), -1 beyond
        ``max_distance``, barycentric coordinates (k, 3) and distances (k,)."""
        return self._core.nearest(points, distance(max_distance, "max_distance"))

    def write(self, path: Any, *, point_data: Optional[Mapping[str, ArrayLike]] = None,
              cell_data: Optional[Mapping[str, ArrayLike]] = None) -> None:
        """Writes .vtp, .ply, .obj, .gltf or .glb, atomically, with the surface's arrays and the
        given ones. Warns of arrays that the format cannot hold."""
        points: dict[str, ArrayLike] = {**self.point_data, **(point_data or {})}
        cells: dict[str, ArrayLike] = {**self.cell_data, **(cell_data or {})}
        for line in _core.write_surface(path_of(path), self._core, points, cells, {}, {}):
            warn(line)

    def _own_array(self, given: Any) -> tuple[str, Any]:
        """The same of vertices or triangles, as it is."""
        return self._core.array_named(given)[:2] if isinstance(given, str) else ("array", given)

    def _array(self, given: Any, what: str) -> tuple[str, Any]:
        """A name for messages, and the array."""
        if isinstance(given, str):
            return given, self.array(given)
        return what, given


def flat_tensors(array: Any) -> Any:
    """Reshapes (n, 3, 3) to (n, 9)."""
    if not hasattr(array, "shape"):
        array = _core.unmasked(array)
    shape = array.shape
    return array.reshape(-1, 9) if len(shape) == 3 and tuple(shape[1:]) == (3, 3) else array


def as_surface(mesh: Any) -> Surface:
    """The surface that an object is or looks like: a Surface, a pair of arrays (V, F), and meshes of
    pyvista, trimesh, meshio and VTK (vtkPolyData, vtkUnstructuredGrid), by the rules of files: polygons
    are cut into triangles, and of volume cells alone the boundary is taken (``Surface.notes``).

    Vertices keep their numbers. Meshes are repaired as when reading a file: vertices at one
    position are joined and invalid triangles dropped. Point and cell data are kept. Raises
    TypeError for anything else.
    """
    if isinstance(mesh, Surface):
        return mesh
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        return Surface(mesh[0], mesh[1])
    return Surface._of(*surface_of(mesh))


def read(path: Any, *, points: Optional[bool] = None, neighbors: int = 8, subdivide: int = 0,
         rounded: bool = False, crease_angle: float = 40,
         progress: Optional[Progress] = None) -> Surface:
    """Reads .vtp, .vtu, .vtk, .ply, .obj, .stl, .off, .gltf, .glb, or points of .csv and others.

    ``points``: read only the vertices, as points, each joined to its ``neighbors`` nearest; None:
    if the file has no faces. ``subdivide``: times, 0 to 10, that every triangle is split in four;
    ``rounded``: as in ``Surface.subdivide``. ``crease_angle``: edges that bend by more degrees
    are creases, whose vertices are copied for each further face, behind all others; 180: none.
    ``progress(stage, fraction)`` may return False to cancel.

    ``s.point_data`` and ``s.cell_data`` are the file's arrays. Raises brindle.Error with the
    file, the line if any, and the remedy.
    """
    if points is not None:
        points = flag(points, "points")
    return Surface._of(_core.read(path_of(path), points, whole_number(neighbors, "neighbors"),
                                  _times(subdivide), _rounded(rounded, subdivide),
                                  number(crease_angle, "crease_angle"), progress))


def shape(name: str, *, subdivide: int = 0, rounded: bool = False, crease_angle: float = 40,
          **parameters: float) -> Surface:
    """A built-in shape: ``shape("torus")``, ``shape("torus", resolution=64, noise=0.2)`` or
    ``shape("torus,resolution=64")``. ``shape_names()`` and ``shape_help()`` list them; other
    parameters are those of ``read``."""
    spec = word(name, "name")
    for key, value in parameters.items():
        if isinstance(value, (bool, str)) or not hasattr(value, "__float__"):
            raise TypeError(f"{key}: expected a number, got {value!r}")
        spec += f",{key}={value}"
    return Surface._of(_core.shape(spec, _times(subdivide), _rounded(rounded, subdivide),
                                   number(crease_angle, "crease_angle")))


def points(positions: ArrayLike, normals: Optional[ArrayLike] = None, *, neighbors: int = 8,
           point_data: Optional[Mapping[str, ArrayLike]] = None) -> Surface:
    """A surface of points: positions (n, 3) and optional normals (n, 3). Each point is joined to
    its ``neighbors`` nearest. Points that are repeated or not finite are ignored and keep their
    numbers."""
    return Surface._of(_core.surface_of_points(positions, normals,
                                               whole_number(neighbors, "neighbors"),
                                               dict(point_data or {})))


def shape_names() -> list[str]:
    """The names of all built-in shapes."""
    return _core.shape_names()


def shape_help() -> str:
    """A line per shape and parameter, with ranges and defaults."""
    return _core.shape_help()


def _times(subdivide: Any) -> int:
    times = whole_number(subdivide, "subdivide")
    if not 0 <= times <= 10:
        raise Error(f"subdivide: {times} is not in 0 .. 10")
    return times


def _rounded(rounded: Any, subdivide: int) -> bool:
    if flag(rounded, "rounded") and subdivide == 0:
        raise Error("rounded: bends triangles that are split, and none is; try subdivide=2")
    return bool(rounded)
