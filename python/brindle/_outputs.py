"""Results: stripes, their curves, samples where two patterns cross, textures and their meshes."""

from __future__ import annotations

import json
from functools import cached_property
from typing import Any, Iterator, Mapping, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import (Arrays, Error, Floats, Indices, Projection, Result, Tiles, Up, flag,
                         kept_property, number, numbers_given, path_of, placed, warn, whole_number, word)
from ._interop import put_pattern
from ._look import Drawn, picture_of, tile_png
from ._options import Look
from ._surface import Surface

CURVE_ENDS = ("closed", "boundary", "no_wave", "nonmanifold", "branch", "singularity", "crease")
_TURN = "turn_deg"
_STRIPE_COLOR, _SAMPLE_COLOR = "#1c325a", "#c7422b"


def fitting(path: str, points: Mapping[str, Any], cells: Mapping[str, Any]) -> tuple[dict, dict]:
    """The waves' arrays that a format can hold: glTF has no NaN and no cells, OBJ no waves."""
    kind = path.lower().rpartition(".")[2]
    if kind == "obj":
        return {name: points[name] for name in ("normal", "uv") if name in points}, {}
    if kind not in ("gltf", "glb"):
        return dict(points), dict(cells)
    return {name: np.nan_to_num(array) if name.startswith(("phase", "sin_phase")) else array
            for name, array in points.items()}, {}


class Stripes(Drawn, Result):
    """Stripes over a surface: what ``brindle.stripes`` returns.

    Arrays share the pattern's memory if possible, are read-only, and keep it alive.
    """

    def __init__(self, core: _core.Stripes, surface: Surface, said: str,
                 also_on: tuple[Surface, ...] = ()) -> None:
        self._core = core
        self._said = said
        self._also_on = also_on
        self.surface = surface

    _SHOWS = ("view", "stripe_width")

    def _drawn(self, surface: Surface, picture: _core.Picture, look: Look, tile: Any) -> Any:
        return _core.render(surface._core, self._core, picture)

    def _mesh_parts(self) -> tuple[Any, ...]:
        return (self.surface.vertices, "triangle", self.surface.faces,
                {**self.surface.point_data, **self.point_data}, {**self.surface.cell_data, **self.cell_data})

    def __repr__(self) -> str:
        branches = "" if self.surface.is_points else f"{self.report['branches']} branches, "
        return f"<brindle.Stripes: {branches}spacing {self._spacing():.4g}, on {self.surface!r}>"

    def _spacing(self) -> float:
        """One mean period of the waves; 1 if there are none."""
        frequencies = self.frequency[np.any(self.directions != 0, axis=1)]
        return 1 / float(np.mean(frequencies, dtype=np.float64)) if len(frequencies) else 1

    @property
    def phases(self) -> NDArray[np.complex64]:
        """(n,) exp(i Phi) per vertex; stripes are where Phi is near pi / 2. Without a wave it is
        a meaningless 1j: ``point_data`` has NaN there, and ``valid`` 0. Shares memory."""
        return self._core.phases

    @property
    def frequency(self) -> Floats:
        """(n,) stripes per unit length. Shares memory."""
        return self._core.frequency

    @property
    def frequency_wanted(self) -> Floats:
        """(n,) requested stripes per unit length: ``frequency`` before the spacing tolerance."""
        return self._core.frequency_wanted

    @property
    def frequency_change(self) -> Optional[dict[str, Any]]:
        """With ``slack``, metrics of the change of frequencies: ratios of chosen to requested
        ones, the share of vertices at the bounds, and so on."""
        return self.report.get("frequency_change")

    @property
    def field_rotation(self) -> Optional[dict[str, float]]:
        """With ``winding``, how far it turned the field, and the energy before."""
        return self.report.get("turned")

    @property
    def cancelled_branches(self) -> Optional[dict[str, float]]:
        """With ``cancel_branches``: cancelled pairs, branches and energy before and after."""
        return self._core.cancelled_branches()

    def windings(self) -> dict[str, Optional[int]]:
        """Winding numbers of ``surface.loops()``, by name: 0 are rings, 1 a right-handed spiral,
        -1 a left-handed one. None if the field has no orientation along the loop."""
        return _core.windings(self._core)

    @property
    def directions(self) -> Floats:
        """(n, 3) unit tangent vectors, zero where there is no wave. Shares memory."""
        return self._core.directions

    @kept_property
    def corner_phases(self) -> Floats:
        """(m, 3) lifted phases at the corners of triangles, in radians, linear within each; NaN
        for triangles without (a singularity of the field, a corner without wave)."""
        return self._core.corner_phases()

    @kept_property
    def branches(self) -> NDArray[np.int8]:
        """(m,) 1 in triangles where a stripe begins or ends, including singularities of the
        field; 0 elsewhere."""
        return self._core.branches()

    @kept_property
    def branch_indices(self) -> NDArray[np.int8]:
        """(m,) the phase gained around each triangle, over 2 pi; 0 in singularities."""
        return self._core.branch_indices()

    @kept_property
    def singularities(self) -> NDArray[np.bool_]:
        """(m,) True in triangles whose corners' directions cannot be aligned."""
        return self._core.kinds() == 2

    @kept_property
    def angle_errors(self) -> Floats:
        """(m,) degrees between the phase's gradient and the field; -1 in irregular triangles."""
        return self._core.angle_errors()

    @cached_property
    def report(self) -> dict[str, Any]:
        """All metrics of the pattern, with the keys of the tool's ``--report``."""
        return json.loads(self._core.report(self._said))

    @kept_property
    def point_data(self) -> Arrays:
        """Named arrays with a row per vertex, as in the tool's mesh files: phase (radians; NaN
        without a wave), direction, frequency, branch, sin_phase, valid, original_id."""
        return self._core.point_arrays()

    @kept_property
    def cell_data(self) -> Arrays:
        """Named arrays with a row per triangle: branch, corner_phase."""
        return self._core.cell_arrays()

    def curves(self, *, join: bool = False, trim: Optional[float] = None, fair: float = 0,
               offset: float = 0, min_length: float = 0, simplify: Optional[float] = None,
               resample: Optional[float] = None) -> Curves:
        """The centre lines of the stripes: ``points, edges = p.curves()`` gives (k, 3) and (l,
        2).

        ``join``: where curves end in one branch, joins them in pairs. ``trim``: cuts ends at branches
        and singularities back to where no neighbour is nearer than this share of the spacing (0.6 by
        default; 0: as traced), without hooks; not together with ``join``. ``fair``: takes out kinks
        shorter than about this share of the spacing (0.25 is good; 0 leaves them). ``offset``: moved by
        so many periods (0.5: the middle of the gaps). ``min_length``, ``resample`` (distance between
        points) and ``simplify`` (tolerance) are lengths.
        """
        made = _core.curves(self._core, {"join": flag(join, "join"), **numbers_given(
            trim=trim, fair=fair, offset=offset, min_length=min_length, simplify=simplify, resample=resample)})
        warn(made.warnings())
        return Curves(made, self)

    def mesh(self) -> TexturedMesh:
        """A mesh with texture coordinates: U across the stripes, one unit per period."""
        return TexturedMesh(_core.textured_stripes(self._core), self)

    def write(self, path: Any, *, uv: bool = False) -> None:
        """Writes .vtp, .ply, .gltf, .glb or .obj as ``brindle stripe --output``, atomically: the
        arrays of the pattern and of the surface; one with a name of the pattern's becomes
        "NAME_input". ``uv``: adds texture coordinates, which splits vertices. Warns of arrays
        that the format cannot hold."""
        if flag(uv, "uv"):
            self.mesh().write(path)
            return
        points, cells = fitting(path_of(path), self.point_data, self.cell_data)
        if self.surface.is_points:
            points = {"normal": self.surface.normals, **points}
        # The turn in the surface's arrays belongs to other waves.
        beside = {name: array for name, array in self.surface.point_data.items() if name != _TURN}
        for line in _core.write_surface(path_of(path), self.surface._core, points, cells, beside,
                                        self.surface.cell_data):
            warn(line)

    def add_to(self, mesh: Any, *, prefix: str = "") -> Any:
        """Adds the pattern's arrays to a mesh of pyvista, trimesh, meshio or VTK with the same
        number of vertices: ``point_data`` and ``cell_data``, with ``prefix`` before their names.
        Replaces those of an earlier pattern; raises Error if another array has one of the names.
        Returns the mesh."""
        return put_pattern(mesh, self.surface, self.point_data, self.cell_data, word(prefix, "prefix"))


class Curves(Drawn, Result):
    """The centre lines of stripes. ``points, edges = curves`` are ready for a curve network."""

    def __init__(self, core: _core.Curves, stripes: Stripes) -> None:
        self._core = core
        self.stripes = stripes

    _SHOWS = ("tube_radius",)

    @property
    def surface(self) -> Surface:  # type: ignore[override]
        """The surface of the stripes."""
        return self.stripes.surface

    @property
    def _also_on(self) -> tuple[Surface, ...]:
        return self.stripes._also_on

    def _drawn(self, surface: Surface, picture: _core.Picture, look: Look, tile: Any) -> Any:
        radius = look.tube_radius
        if radius is None:
            radius = 1 / (12 * float(self.stripes.frequency.mean()))
        return _drawn_on(surface, self.tubes(radius), picture, _STRIPE_COLOR)

    def _mesh_parts(self) -> tuple[Any, ...]:
        return self.points, "line", self.edges, {"normal": self.normals}, {}

    def __iter__(self) -> Iterator[NDArray[Any]]:
        return iter((self.points, self.edges))

    def __repr__(self) -> str:
        return (f"<brindle.Curves: {self.count} curves of {len(self.points)} points, length "
                f"{self.lengths.sum():.4g}, on {self.surface!r}>")

    @property
    def count(self) -> int:
        """The number of curves."""
        return len(self._core.closed)

    @kept_property
    def points(self) -> NDArray[np.floating]:
        """(k, 3) points on the surface, curve after curve."""
        return placed(self._core.local_points, self.surface.origin)

    @kept_property
    def edges(self) -> Indices:
        """(l, 2) point numbers of the edges; closed curves return to their first point."""
        return self._core.edges()

    @property
    def normals(self) -> Floats:
        """(k, 3) unit normals of the surface."""
        return self._core.normals

    @property
    def offsets(self) -> Indices:
        """(count + 1,): curve i has the points offsets[i] up to offsets[i + 1]."""
        return self._core.offsets

    @property
    def closed(self) -> NDArray[np.bool_]:
        """(count,) whether a curve is closed; its first point is not repeated."""
        return self._core.closed

    @kept_property
    def lengths(self) -> NDArray[np.float64]:
        """(count,) lengths, including the closing edge."""
        return self._core.lengths()

    @cached_property
    def ends(self) -> list[tuple[str, str]]:
        """The reasons why each curve ends at its first and its last point: "closed", "boundary",
        "no_wave", "nonmanifold", "branch", "singularity" or "crease"."""
        return [(CURVE_ENDS[first], CURVE_ENDS[last]) for first, last in self._core.ends()]

    @property
    def lines(self) -> list[NDArray[np.floating]]:
        """The points of every curve, (?, 3) each."""
        return np.split(self.points, self.offsets[1:-1]) if self.count else []

    @property
    def places(self) -> tuple[Indices, NDArray[np.float64]]:
        """Where the points are on the mesh: triangles (k,), barycentric coordinates (k, 3)."""
        return self._core.places()

    def interpolate(self, array: Union[str, ArrayLike], *, axes: bool = False) -> NDArray[Any]:
        """An array of the surface, or its name, at the points: of a row per vertex, means of the
        triangle's corners (whole numbers come from the nearest one); of a row per triangle, that
        row. With ``axes``, signs of vectors do not count."""
        name, rows = self.surface._own_array(array)
        return self._core.interpolate(name, rows, flag(axes, "axes"))

    @cached_property
    def report(self) -> dict[str, Any]:
        """The metrics of one family of curves in ``brindle curves --report``, without
        ``spacing``."""
        quality = self.stripes.report
        closed, metrics = int(self.closed.sum()), self._core.metrics()
        return {"energy": quality["energy"], "branches": quality["branches"],
                "field_singularities": quality["field_singularities"], "curves": self.count,
                "closed": closed, "open": self.count - closed,
                "short_curves_left_out": metrics.pop("short_curves_left_out"),
                "points": len(self.points), "length": float(sum(self.lengths)), **metrics,
                **json.loads(self.stripes._core.fabrication()),
                **{key: quality[key] for key in ("frequency_change",) if key in quality}}

    def measures(self, path_width: float = 0) -> dict[str, Any]:
        """Metrics for fabrication: ``lengths``, ``gaps`` between neighbours (in a build with
        nanoflann) and, for a width above 0, ``coverage``, the share of the surface's area that
        lines of this width cover. Lengths are in the units of the vertices."""
        return self._core.measures(self.stripes._core, number(path_width, "path_width"))

    def tubes(self, radius: float, sides: int = 8) -> Surface:
        """Tubes around the curves, as a surface, for printing and pictures."""
        vertices, triangles = self._core.tubes(number(radius, "radius"), whole_number(sides, "sides"))
        return Surface(placed(vertices, self.surface.origin), triangles)

    def write(self, path: Any, *, name: str = "u",
              point_data: Optional[Mapping[str, ArrayLike]] = None) -> None:
        """Writes .obj, .ply, .vtp or .csv lines, or a drawing (``.svg``, as ``draw``),
        atomically. ``point_data``: arrays with a row per point."""
        text = path_of(path)
        if text.lower().endswith(".svg"):
            self.draw(text)
            return
        self._core.write(text, name, dict(point_data or {}))

    def draw(self, path: Any, *, size: Sequence[int] = (1200, 900),
             camera: Union[str, Sequence[float]] = (30, 20), projection: Optional[Projection] = None,
             up: Optional[Up] = None, slice: Optional[str] = None,
             colors: Optional[Sequence[str]] = None) -> None:
        """Writes an SVG drawing without hidden lines; arguments as for ``brindle.render``."""
        picture = picture_of(self.surface, size, camera, projection, up, slice, colors)
        self._core.draw(path_of(path), picture, _STRIPE_COLOR)


class Samples(Drawn, Result):
    """Points where two patterns cross. ``points, normals = samples`` are (k, 3) each."""

    def __init__(self, core: _core.Samples, surface: Surface, u: Stripes, v: Stripes) -> None:
        self._core = core
        self._also_on = u._also_on
        self.surface = surface
        self.u = u
        self.v = v

    def _drawn(self, surface: Surface, picture: _core.Picture, look: Look, tile: Any) -> Any:
        return _drawn_on(surface, _discs(self), picture, _SAMPLE_COLOR)

    def _mesh_parts(self) -> tuple[Any, ...]:
        arrays = {"normal": self.normals, "direction_u": self.directions[0], "direction_v": self.directions[1],
                  "spacing_u": self.spacings[0], "spacing_v": self.spacings[1]}
        return self.points, "vertex", np.arange(self.count)[:, None], arrays, {}

    def __iter__(self) -> Iterator[NDArray[Any]]:
        return iter((self.points, self.normals))

    def __repr__(self) -> str:
        spacing = " x ".join(f"{each.mean():.4g}" for each in self.spacings) if self.count else "none"
        return f"<brindle.Samples: {self.count} samples, spacing {spacing}, on {self.surface!r}>"

    @kept_property
    def _columns(self) -> Arrays:
        return self._core.columns()

    @property
    def count(self) -> int:
        """k, the number of samples."""
        return self._core.count

    @kept_property
    def points(self) -> NDArray[np.floating]:
        """(k, 3) positions on the surface."""
        return placed(self._columns["points"], self.surface.origin)

    @property
    def normals(self) -> Floats:
        """(k, 3) unit normals."""
        return self._columns["normals"]

    @property
    def directions(self) -> tuple[Floats, Floats]:
        """(k, 3) unit tangent directions of U and of V, up to sign."""
        return self._columns["directions_u"], self._columns["directions_v"]

    @property
    def spacings(self) -> tuple[Floats, Floats]:
        """(k,) target distances to the next sample along U and along V."""
        return self._columns["spacing_u"], self._columns["spacing_v"]

    @property
    def places(self) -> tuple[Indices, Floats]:
        """Positions of the samples on the mesh: triangles (k,), barycentric coordinates (k, 3)."""
        return self._columns["triangles"], self._columns["barycentric"]

    def interpolate(self, array: Union[str, ArrayLike], *, axes: bool = False) -> NDArray[Any]:
        """An array of the surface at the samples, as ``Curves.interpolate``."""
        name, rows = self.surface._own_array(array)
        return self._core.interpolate(name, rows, flag(axes, "axes"))

    @cached_property
    def report(self) -> dict[str, Any]:
        """The samples' own metrics of ``brindle sample --report``."""
        return {"samples": self.count, "doubles_left_out": self._core.doubles,
                "branches_u": self.u.report.get("branches", 0),
                "branches_v": self.v.report.get("branches", 0),
                "nearest_neighbour": json.loads(self._core.spacing())}

    def write(self, path: Any, *, point_data: Optional[Mapping[str, ArrayLike]] = None) -> None:
        """Writes .csv, .ply or .vtp with positions on the mesh, directions and spacings,
        atomically. ``point_data``: arrays with a row per sample."""
        self._core.write(path_of(path), dict(point_data or {}))


class TexturedMesh:
    """A mesh with texture coordinates at vertices, for other programs. Vertices of the surface
    keep their numbers; copies and new ones follow."""

    def __init__(self, core: _core.TexturedMesh, of: Union[Stripes, Texture]) -> None:
        self._core = core
        self._of = of
        self.surface: Surface = of.surface

    def __repr__(self) -> str:
        return (f"<brindle.TexturedMesh: {len(self.uv)} vertices, {len(self.faces)} triangles, of "
                f"{self.surface!r}>")

    def __reduce__(self) -> Any:
        return type(self._of).mesh, (self._of,)

    @kept_property
    def vertices(self) -> NDArray[np.floating]:
        """(n', 3)."""
        return placed(self._core.local_vertices, self._core.origin)

    @property
    def faces(self) -> Indices:
        """(m', 3)."""
        return self._core.faces

    @property
    def uv(self) -> Floats:
        """(n', 2): one tile is one unit; U to the right, V upwards."""
        return self._core.uv

    @property
    def vertex_origins(self) -> Indices:
        """(n', 3): the vertices of the surface whose mean a vertex is; three times the same for a
        vertex and its copies."""
        return self._core.vertex_origins

    @property
    def face_origins(self) -> Indices:
        """(m',): the triangle of the surface that contains each triangle."""
        return self._core.face_origins

    def _mesh_parts(self) -> tuple[Any, ...]:
        return self.vertices, "triangle", self.faces, self.point_data, self.cell_data

    @kept_property
    def _arrays(self) -> tuple[Arrays, Arrays]:
        return self._core.arrays()

    @property
    def point_data(self) -> Arrays:
        """Named arrays with a row per vertex: normal, uv, those of the patterns and of the
        surface."""
        return self._arrays[0]

    @property
    def cell_data(self) -> Arrays:
        """Named arrays with a row per triangle: branch, and those of the surface."""
        return self._arrays[1]

    def write(self, path: Any, *, tile: Any = None, tiles: Optional[Tiles] = None,
              colors: Optional[tuple[str, ...]] = None) -> None:
        """Writes .vtp, .ply, .obj, .gltf or .glb with texture coordinates. ``tile``: an image, by
        name ("checker" and so on, in ``colors``) or as an array (h, w, 3 or 4) of uint8; embedded
        in .gltf and .glb, otherwise written beside the mesh. ``tiles``: "whole" adds the triangle
        array tile_broken, 1 for triangles of a tile that a branch, a seam or the border cuts;
        None: as in ``render``."""
        text = path_of(path)
        if tiles is not None and text.lower().endswith((".obj", ".gltf", ".glb")):
            raise Error(f"tiles has no effect here: '{text}' holds no values of triangles; write .vtp "
                        "or .ply")
        points, cells = fitting(text, self.point_data, self._cells_with(tile, tiles))
        png = b""
        if tile is not None:
            png = tile_png(tile, colors, isinstance(self._of, Texture) and self._of.is_cross)
        for line in _core.write_mesh(text, self._core.origin, self._core.local_vertices,
                                     self.faces, points, cells, png):
            warn(line)

    def _cells_with(self, tile: Any, tiles: Optional[Tiles]) -> Arrays:
        if not isinstance(self._of, Texture) or tile is None:
            if tiles is not None:
                raise Error("tiles has no effect here: there is no tile")
            return self.cell_data
        broken = _core.triangles_with_broken_tiles(self._of._core, tile, Look(tiles=tiles).whole)
        if broken is None:
            return self.cell_data
        cells: Arrays = {}
        for name, array in self.cell_data.items():
            cells[name] = array
            if name == "branch_v":  # the last of the patterns' own; those of the surface follow
                cells["tile_broken"] = broken[self.face_origins]
        return cells


class Texture(Drawn, Result):
    """Texture coordinates over a surface: what ``brindle.texture`` and ``brindle.crosses`` return.

    ``surface`` is their surface: the given one or, for crosses, that with every singular triangle
    split in three at its barycentre.
    """

    def __init__(self, core: _core.Texture, surface: Surface, said: str,
                 also_on: tuple[Surface, ...] = ()) -> None:
        self._core = core
        self._said = said
        self._also_on = also_on
        self.surface = surface

    _SHOWS = ("view", "tile", "tiles")

    def _drawn(self, surface: Surface, picture: _core.Picture, look: Look, tile: Any) -> Any:
        image, warnings = _core.render_texture(self._core, "checker" if tile is None else tile, look.whole,
                                               picture)
        warn(warnings, 4)
        return image

    def _mesh_parts(self) -> tuple[Any, ...]:
        return self.mesh()._mesh_parts()

    def __repr__(self) -> str:
        return f"<brindle.Texture: {self.report['branches']} branches, on {self.surface!r}>"

    @kept_property
    def corner_uv(self) -> Floats:
        """(m, 3, 2) coordinates at the corners of triangles, linear in each, one unit per tile.
        They agree along edges up to whole tiles and, without an orientation, a half turn, except
        at triangles with a branch of U or V. NaN in triangles without coordinates: singularities
        of the field, corners without wave."""
        return self._core.corner_uv()

    @property
    def is_cross(self) -> bool:
        """Whether it follows a cross field."""
        return self._core.is_cross

    @cached_property
    def u(self) -> Stripes:
        """The stripes along the field. Crosses have none (AttributeError): see ``double_cover``."""
        return self._part(self._core.u, "u")

    @cached_property
    def v(self) -> Stripes:
        """The stripes across the field. Crosses have none (AttributeError): see ``double_cover``."""
        return self._part(self._core.v, "v")

    @cached_property
    def double_cover(self) -> Stripes:
        """Of crosses: both waves, on a surface that has each vertex twice (2 i and 2 i + 1) and
        each triangle for either wave. Its curves are both families of lines. Other textures have
        none (AttributeError): see ``u`` and ``v``."""
        core = self._core.double_cover
        if core is None:
            raise AttributeError("double_cover: crosses have one; this texture has u and v")
        return Stripes(core, Surface._of(core.surface), self._said, (self.surface, *self._also_on))

    @property
    def cancelled_branches(self) -> Optional[dict[str, float]]:
        """With ``cancel_branches``: cancelled pairs, branches and energy before and after, of U
        and V together; without those at singularities for crosses."""
        return self._core.cancelled_branches()

    @property
    def face_origins(self) -> Indices:
        """For crosses: the triangle of the given surface for every triangle of ``surface``."""
        return self._core.face_origins

    @property
    def singular_faces(self) -> Indices:
        """For crosses: triangles of the given surface around which U becomes V."""
        return self._core.singular_faces

    @cached_property
    def report(self) -> dict[str, Any]:
        """All metrics, with the keys of the tool's ``--report``."""
        return json.loads(self._core.report(self._said))

    def mesh(self) -> TexturedMesh:
        """A mesh with texture coordinates per vertex, with vertices split where it needs that."""
        return TexturedMesh(self._core.mesh(), self)

    def write(self, path: Any, *, tile: Any = "checker", tiles: Optional[Tiles] = None,
              colors: Optional[tuple[str, ...]] = None) -> None:
        """Writes .vtp, .ply, .obj, .gltf or .glb with the tile, as ``brindle stripe --texture``.
        ``tiles``: as in ``TexturedMesh.write``."""
        self.mesh().write(path, tile=tile, tiles=tiles, colors=colors)

    def add_to(self, mesh: Any, *, prefix: str = "") -> Any:
        """Adds the coordinates to a mesh of pyvista, trimesh, meshio or VTK as the array "uv" of its
        triangles, its name after ``prefix``: six numbers each (u, v of three corners), NaN for
        triangles that were split. Raises Error where the mesh has an array of that name. Returns
        the mesh."""
        return put_pattern(mesh, self.surface, {}, {"uv": self.corner_uv.reshape(-1, 6)},
                           word(prefix, "prefix"))

    def _part(self, core: Any, name: str) -> Stripes:
        if core is None:
            raise AttributeError(f"{name}: crosses have both waves in double_cover")
        return Stripes(core, self.surface, self._said)


def _drawn_on(surface: Surface, ornament: Surface, picture: _core.Picture, color: str) -> Any:
    return _core.render_ornament(surface._core, ornament._core, color, picture)


def _discs(samples: Samples) -> Surface:
    """Discs a third of the spacing wide, just above and below the surface, whose winding may be
    either."""
    corners = 16
    x, normal = samples.directions[0], samples.normals
    y = np.cross(normal, x)
    radius = 0.16 * np.minimum(*samples.spacings)[:, None, None]
    angles = np.linspace(0, 2 * np.pi, corners, endpoint=False)[None, :, None]
    ring = np.cos(angles) * x[:, None, :] + np.sin(angles) * y[:, None, :]
    vertices = np.concatenate([samples.points[:, None, :]
                               + radius * (ring + height * normal[:, None, :])
                               for height in (-0.12, 0.12)], axis=1).reshape(-1, 3)
    fan = np.array([(0, k, k + 1) for k in range(1, corners - 1)])
    starts = corners * np.arange(2 * samples.count)[:, None, None]
    return Surface(vertices, (starts + fan[None]).reshape(-1, 3))
