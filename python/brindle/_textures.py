"""Texture coordinates along a field, and along cross fields."""

from __future__ import annotations

import json
from functools import cached_property
from time import perf_counter
from typing import TYPE_CHECKING, Any, Mapping, Optional, Union

from . import _core
from ._arguments import (Error, PhaseShift, Result, Solver, Tiles, Weights, count_and_frequency,
                         flag, kept_property, one_of_both, path_of, solving, warn, word)
from ._curves import placed
from ._stripes import Field, Stripes, defaults_of, fitting, frequencies_of, invocation
from ._surface import Progress, Surface, as_surface

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


class TexturedMesh:
    """A mesh with texture coordinates at vertices, for other programs. Vertices of the surface
    keep their numbers; copies and new ones follow."""

    def __init__(self, core: "_core.TexturedMesh", of: "Union[Stripes, Texture]") -> None:
        self._core = core
        self._of = of
        self.surface: Surface = of.surface

    def __repr__(self) -> str:
        return (f"<brindle.TexturedMesh: {len(self.uv)} vertices, {len(self.triangles)} triangles, of "
                f"{self.surface!r}>")

    def __reduce__(self) -> Any:
        return type(self._of).mesh, (self._of,)

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
        """(n', 3): the vertices of the surface whose mean a vertex is; three times the same for a
        vertex and its copies."""
        return self._core.vertex_origins

    @property
    def triangle_origins(self) -> "NDArray[np.int32]":
        """(m',): the triangle of the surface that contains each triangle."""
        return self._core.triangle_origins

    @kept_property
    def _arrays(self) -> "tuple[dict[str, NDArray[Any]], dict[str, NDArray[Any]]]":
        return self._core.arrays()

    @property
    def point_data(self) -> "dict[str, NDArray[Any]]":
        """Named arrays with a row per vertex: normal, uv, those of the patterns and of the
        surface."""
        return self._arrays[0]

    @property
    def cell_data(self) -> "dict[str, NDArray[Any]]":
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
            from ._pictures import tile_png
            png = tile_png(tile, colors, isinstance(self._of, Texture) and self._of.is_cross)
        for line in _core.write_mesh(text, self._core.origin, self._core.local_vertices,
                                     self.triangles, points, cells, png):
            warn(line)


    def _cells_with(self, tile: Any, tiles: Optional[Tiles]) -> "dict[str, NDArray[Any]]":
        if not isinstance(self._of, Texture) or tile is None:
            if tiles is not None:
                raise Error("tiles has no effect here: there is no tile")
            return self.cell_data
        from ._pictures import whole_tiles
        broken = _core.triangles_with_broken_tiles(self._of._core, tile, whole_tiles(tiles))
        if broken is None:
            return self.cell_data
        cells: "dict[str, NDArray[Any]]" = {}
        for name, array in self.cell_data.items():
            cells[name] = array
            if name == "branch_v":  # the last of the patterns' own; those of the surface follow
                cells["tile_broken"] = broken[self.triangle_origins]
        return cells


class Texture(Result):
    """Texture coordinates over a surface: what ``brindle.texture`` and ``brindle.crosses`` return.

    ``surface`` is their surface: the given one or, for crosses, that with every singular triangle
    split in three at its barycentre.
    """

    def __init__(self, core: "_core.Texture", surface: Surface, said: str,
                 also_on: tuple[Surface, ...] = ()) -> None:
        self._core = core
        self._said = said
        self._also_on = also_on
        self.surface = surface

    def __repr__(self) -> str:
        return f"<brindle.Texture: {self.report['branches']} branches, on {self.surface!r}>"

    @kept_property
    def corner_uv(self) -> "NDArray[np.float32]":
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
        """The stripes along the field. Crosses have none (AttributeError): see ``cover``."""
        return self._part(self._core.u, "u")

    @cached_property
    def v(self) -> Stripes:
        """The stripes across the field. Crosses have none (AttributeError): see ``cover``."""
        return self._part(self._core.v, "v")

    @cached_property
    def cover(self) -> Stripes:
        """Of crosses: both waves, on a surface that has each vertex twice (2 i and 2 i + 1) and
        each triangle for either wave. Its curves are both families of lines. Other textures have
        none (AttributeError): see ``u`` and ``v``."""
        core = self._core.cover
        if core is None:
            raise AttributeError("cover: crosses have one; this texture has u and v")
        return Stripes(core, Surface._of(core.surface), self._said, (self.surface, *self._also_on))

    @property
    def cancelled_branches(self) -> Optional[dict[str, float]]:
        """With ``cancel_branches``: cancelled pairs, branches and energy before and after, of U
        and V together; without those at singularities for crosses."""
        return self._core.cancelled_branches()

    @property
    def triangle_origins(self) -> "NDArray[np.int32]":
        """For crosses: the triangle of the given surface for every triangle of ``surface``."""
        return self._core.triangle_origins

    @property
    def singular(self) -> "NDArray[np.int32]":
        """For crosses: triangles of the given surface around which U becomes V."""
        return self._core.singular

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

    def put_on(self, mesh: Any, *, prefix: str = "") -> Any:
        """Puts the coordinates on a mesh of pyvista, trimesh, meshio or VTK as the array "uv" of its
        triangles, its name after ``prefix``: six numbers each (u, v of three corners), NaN for
        triangles that were split. Raises Error where the mesh has an array of that name. Returns
        the mesh."""
        from ._meshes import put_pattern
        return put_pattern(mesh, self.surface, {}, {"uv": self.corner_uv.reshape(-1, 6)},
                           word(prefix, "prefix"))

    def _part(self, core: Any, name: str) -> Stripes:
        if core is None:
            raise AttributeError(f"{name}: crosses have both waves in cover")
        return Stripes(core, self.surface, self._said)


def texture(surface: Any, directions: "Optional[ArrayLike]" = None, *, stripes: Any = None,
            frequency: Any = None, spacing: Optional[float] = None, stripes_v: Any = None,
            frequency_v: Any = None, oriented: bool = False, along: bool = False, slack: Any = None,
            avoid_branches: "Optional[ArrayLike]" = None, solver: Solver = "multilevel",
            phase_shift: PhaseShift = "aligned", weights: Weights = "paper", epsilon: Optional[float] = None,
            momentum: Optional[float] = None, seed: Optional[int] = None,
            sweeps: Optional[int] = None, cycles: Optional[int] = None,
            global_iterations: Optional[int] = None, cancel_branches: Optional[float] = None,
            cancel_distance: Optional[float] = None,
            field_smoothing: Optional[float] = None, field_weight: Any = None,
            fill: Optional[float] = None, field_arrows: bool = False,
            field_singularities: Optional[int] = None, hold_out: Optional[float] = None,
            frequency_smoothing: Optional[float] = None, threads: int = 0,
            progress: Optional[Progress] = None) -> Texture:
    """Texture coordinates along a field (U) and across it (V); ``t.corner_uv`` is (m, 3, 2).

    ``oriented``: directions have signs, and U runs along them; otherwise an orientation is found.
    ``stripes_v`` or ``frequency_v``: tiles across the field (default: as along it). Other
    arguments as for ``brindle.stripes``.
    """
    given = dict(locals())
    surface = as_surface(given.pop("surface"))
    given.pop("progress")
    one_of_both("stripes_v", stripes_v, "frequency_v", frequency_v)
    options = solving(given, surface)
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
            avoid_branches: "Optional[ArrayLike]" = None,
            solver: Solver = "multilevel", phase_shift: PhaseShift = "aligned", weights: Weights = "paper",
            epsilon: Optional[float] = None, momentum: Optional[float] = None,
            seed: Optional[int] = None, sweeps: Optional[int] = None, cycles: Optional[int] = None,
            global_iterations: Optional[int] = None, cancel_branches: Optional[float] = None,
            cancel_distance: Optional[float] = None,
            field_smoothing: Optional[float] = None, field_weight: Any = None,
            fill: Optional[float] = None, field_singularities: Optional[int] = None,
            hold_out: Optional[float] = None,
            frequency_smoothing: Optional[float] = None, threads: int = 0,
            progress: Optional[Progress] = None) -> Texture:
    """Square tiles along a cross field, whose directions are equivalent under quarter turns.
    ``directions``: as for ``brindle.stripes``; None: ``surface.smooth_field(symmetry=4)``. Other
    arguments as for ``brindle.stripes``."""
    given = dict(locals())
    surface = as_surface(given.pop("surface"))
    given.pop("progress")
    options = solving(given, surface)
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
    from ._meshes import split_source
    split = Surface._of(made.surface, split_source(surface, made.triangle_origins))
    return Texture(made, split, invocation("crosses", surface, given, _CROSS_DEFAULTS), (surface,))


_CROSS_DEFAULTS = defaults_of(crosses)
