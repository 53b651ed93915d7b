"""Texture coordinates along a field, and along cross fields."""

from __future__ import annotations

import json
from functools import cached_property
from time import perf_counter
from typing import TYPE_CHECKING, Any, Mapping, Optional

from . import _core
from ._arguments import (Error, count_and_frequency, flag, kept_property, one_of_both, path_of,
                         solving, warn)
from ._curves import placed
from ._stripes import Field, Stripes, defaults_of, fitting, frequencies_of, invocation
from ._surface import Progress, Surface, as_surface

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


class TexturedMesh:
    """A mesh whose vertices have texture coordinates, for other programs. Vertices of the surface
    keep their numbers; copies and new ones follow them."""

    def __init__(self, core: "_core.TexturedMesh", surface: Surface, of_crosses: bool = False,
                 texture: "Optional[_core.Texture]" = None) -> None:
        self._core = core
        self._of_crosses = of_crosses
        self._texture = texture
        self.surface = surface

    @kept_property
    def vertices(self) -> "NDArray[np.floating]":
        """(n', 3)."""
        return placed(self._core.local_vertices, self._core.origin)

    @property
    def triangles(self) -> "NDArray[np.int32]":
        """(m', 3)."""
        return self._core.triangles

    @property
    def uv(self) -> "NDArray[np.float32]":
        """(n', 2): one tile is one unit; U to the right, V upwards."""
        return self._core.uv

    @property
    def vertex_origins(self) -> "NDArray[np.int32]":
        """(n', 3): the vertices of the surface whose mean a vertex is: three times the same for a
        vertex and its copies."""
        return self._core.vertex_origins

    @property
    def triangle_origins(self) -> "NDArray[np.int32]":
        """(m',): the triangle of the surface that a triangle is or is part of."""
        return self._core.triangle_origins

    @kept_property
    def _arrays(self) -> "tuple[dict[str, NDArray[Any]], dict[str, NDArray[Any]]]":
        return self._core.arrays()

    @property
    def point_data(self) -> "dict[str, NDArray[Any]]":
        """Named arrays of a row per vertex: normal, uv, those of the patterns and of the surface."""
        return self._arrays[0]

    @property
    def cell_data(self) -> "dict[str, NDArray[Any]]":
        """Named arrays of a row per triangle: branch, and those of the surface."""
        return self._arrays[1]

    def write(self, path: Any, *, tile: Any = None, tiles: Optional[str] = None,
              colors: Optional[tuple[str, ...]] = None) -> None:
        """Writes .vtp, .ply, .obj, .gltf or .glb with texture coordinates. ``tile``: a picture that
        goes along, by name ("checker" and so on, in ``colors``) or as an array (h, w, 3 or 4) of
        uint8; .gltf and .glb hold it, for others it is written beside the mesh. ``tiles``: with
        "whole" triangles have the array tile_broken, 1 where a tile reaches that a branch, a seam or
        the border cuts; None: as ``render`` has it."""
        text = path_of(path)
        if tiles is not None and text.lower().endswith((".obj", ".gltf", ".glb")):
            raise Error(f"tiles has no effect here: '{text}' holds no values of triangles; write .vtp "
                        "or .ply")
        points, cells = fitting(text, self.point_data, self._cells_with(tile, tiles))
        png = b""
        if tile is not None:
            from ._pictures import tile_png
            png = tile_png(tile, colors, self._of_crosses)
        for line in _core.write_mesh(text, self._core.origin, self._core.local_vertices,
                                     self.triangles, points, cells, png):
            warn(line)


    def _cells_with(self, tile: Any, tiles: Optional[str]) -> "dict[str, NDArray[Any]]":
        if self._texture is None or tile is None:
            if tiles is not None:
                raise Error("tiles has no effect here: there is no tile")
            return self.cell_data
        from ._pictures import whole_tiles
        broken = _core.triangles_with_broken_tiles(self._texture, tile, whole_tiles(tiles))
        if broken is None:
            return self.cell_data
        cells: "dict[str, NDArray[Any]]" = {}
        for name, array in self.cell_data.items():
            cells[name] = array
            if name == "branch_v":  # the last of the patterns' own; those of the surface follow
                cells["tile_broken"] = broken[self.triangle_origins]
        return cells


class Texture:
    """Texture coordinates over a surface: what ``brindle.texture`` and ``brindle.crosses`` return.

    ``surface`` is what they belong to: the one handed over or, of crosses, that one with every
    singular triangle split in three at its barycentre.
    """

    def __init__(self, core: "_core.Texture", surface: Surface, said: str,
                 also_on: tuple[Surface, ...] = ()) -> None:
        self._core = core
        self._said = said
        self._also_on = also_on
        self.surface = surface

    def __repr__(self) -> str:
        return f"<brindle.Texture on {self.surface!r}>"

    @kept_property
    def corner_uv(self) -> "NDArray[np.float32]":
        """(m, 3, 2) coordinates at the corners of triangles, linear in each, one tile a unit.
        Along edges they agree up to whole tiles and, where the field cannot be oriented, a turn, but
        for edges of triangles with a branch of U or V, where they do not close.
        NaN in triangles without them: singularities of the field, corners without wave."""
        return self._core.corner_uv()

    @property
    def is_cross(self) -> bool:
        """Whether it lies along a cross field."""
        return self._core.is_cross

    @cached_property
    def u(self) -> Optional[Stripes]:
        """The stripes along the field; None for crosses."""
        return self._part(self._core.u)

    @cached_property
    def v(self) -> Optional[Stripes]:
        """The stripes across the field; None for crosses."""
        return self._part(self._core.v)

    @cached_property
    def cover(self) -> Optional[Stripes]:
        """Of crosses: both waves, on a surface that has each vertex twice (2 i and 2 i + 1) and
        each triangle for either wave. Its curves are both families of lines."""
        core = self._core.cover
        return None if core is None else Stripes(core, Surface._of(core.surface), self._said,
                                                 (self.surface, *self._also_on))

    @property
    def merged(self) -> Optional[dict[str, float]]:
        """With merge_branches: the pairs that are gone, branches and energy before and after, of U
        and V together; of crosses without those of singularities."""
        return self._core.merged()

    @property
    def triangle_origins(self) -> "NDArray[np.int32]":
        """Of crosses: for every triangle of ``surface`` that of the surface handed over."""
        return self._core.triangle_origins

    @property
    def singular(self) -> "NDArray[np.int32]":
        """Of crosses: triangles of the surface handed over around which U becomes V."""
        return self._core.singular

    @cached_property
    def report(self) -> dict[str, Any]:
        """Every figure, with the keys of the tool's ``--report``."""
        return json.loads(self._core.report(self._said))

    def mesh(self) -> TexturedMesh:
        """A mesh with texture coordinates per vertex, with vertices split where it needs that."""
        return TexturedMesh(self._core.mesh(), self.surface, self.is_cross, self._core)

    def write(self, path: Any, *, tile: Any = "checker", tiles: Optional[str] = None,
              colors: Optional[tuple[str, ...]] = None) -> None:
        """Writes .vtp, .ply, .obj, .gltf or .glb with the tile, as ``brindle stripe --texture``.
        ``tiles``: as for the mesh."""
        self.mesh().write(path, tile=tile, tiles=tiles, colors=colors)

    def put_on(self, mesh: Any, name: str = "uv") -> Any:
        """Puts the coordinates on a mesh of pyvista, trimesh, meshio or VTK as an array of its
        triangles, six numbers each (u, v of three corners). Returns the mesh."""
        from ._meshes import put_arrays
        return put_arrays(mesh, self.surface, {}, {name: self.corner_uv.reshape(-1, 6)})

    def _part(self, core: Any) -> Optional[Stripes]:
        return None if core is None else Stripes(core, self.surface, self._said)


def texture(surface: Any, directions: "Optional[ArrayLike]" = None, *, stripes: Any = None,
            frequency: Any = None, spacing: Optional[float] = None, stripes_v: Any = None,
            frequency_v: Any = None, oriented: bool = False, along: bool = False, slack: Any = None,
            calm: "Optional[ArrayLike]" = None, solver: str = "multilevel",
            phase_shift: str = "aligned", weights: str = "paper", epsilon: Optional[float] = None,
            momentum: Optional[float] = None, seed: Optional[int] = None,
            sweeps: Optional[int] = None, cycles: Optional[int] = None,
            global_iterations: Optional[int] = None, merge_branches: Optional[float] = None,
            merge_distance: Optional[float] = None,
            field_detail: Optional[float] = None, field_weight: Any = None,
            fill: Optional[float] = None, field_arrows: bool = False,
            field_singularities: Optional[int] = None,
            frequency_detail: Optional[float] = None, threads: int = 0,
            progress: Optional[Progress] = None) -> Texture:
    """Texture coordinates along a field (U) and across it (V); ``t.corner_uv`` is (m, 3, 2).

    ``oriented``: directions are vectors whose signs are meant, and U runs along them; otherwise an
    orientation is looked for. ``stripes_v`` or ``frequency_v``: tiles across the field; as along it
    unless given. All else as for ``brindle.stripes``.
    """
    given = dict(locals())
    surface = as_surface(given.pop("surface"))
    given.pop("progress")
    one_of_both("stripes_v", stripes_v, "frequency_v", frequency_v)
    options = solving(given, surface.is_points)
    oriented = flag(oriented, "oriented")
    field = Field(surface, directions, flag(along, "along"), options=given, oriented=oriented)
    count, frequency = count_and_frequency(stripes, frequencies_of(surface, frequency), spacing)
    made = _core.texture(surface._core, field.directions, count, frequency, stripes_v,
                         frequencies_of(surface, frequency_v), oriented,
                         field.origin, options, progress)
    warn(made.warnings(field.origin.source))
    return Texture(made, surface, invocation("texture", surface, given, _DEFAULTS))


_DEFAULTS = defaults_of(texture)


def crosses(surface: Any, directions: "Optional[ArrayLike]" = None, *, stripes: Any = None,
            frequency: Any = None, spacing: Optional[float] = None, slack: Any = None,
            calm: "Optional[ArrayLike]" = None,
            solver: str = "multilevel", phase_shift: str = "aligned", weights: str = "paper",
            epsilon: Optional[float] = None, momentum: Optional[float] = None,
            seed: Optional[int] = None, sweeps: Optional[int] = None, cycles: Optional[int] = None,
            global_iterations: Optional[int] = None, merge_branches: Optional[float] = None,
            merge_distance: Optional[float] = None,
            field_detail: Optional[float] = None, field_weight: Any = None,
            fill: Optional[float] = None, field_singularities: Optional[int] = None,
            frequency_detail: Optional[float] = None, threads: int = 0,
            progress: Optional[Progress] = None) -> Texture:
    """Square tiles along a cross field: directions and their quarter turns, which are not told
    apart. ``directions``: as for ``brindle.stripes``; None: ``surface.smooth_field(symmetry=4)``.
    All else as for ``brindle.stripes``.
    """
    given = dict(locals())
    surface = as_surface(given.pop("surface"))
    given.pop("progress")
    options = solving(given, surface.is_points)
    begin = perf_counter()
    field = Field(surface, surface.smooth_field(symmetry=4) if directions is None else directions,
                  False, options=given, symmetry=4, measured=directions is not None)
    field.origin.milliseconds = 1000 * (perf_counter() - begin)
    if directions is None:
        field.origin.source = "the smooth field"
    count, frequency = count_and_frequency(stripes, frequencies_of(surface, frequency), spacing)
    made = _core.crosses(surface._core, field.directions, count, frequency, field.origin,
                         options, progress)
    warn(made.warnings(field.origin.source))
    return Texture(made, Surface._of(made.surface),
                   invocation("crosses", surface, given, _CROSS_DEFAULTS), (surface,))


_CROSS_DEFAULTS = defaults_of(crosses)
