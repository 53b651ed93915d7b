"""Textures raised from surfaces, as closed meshes."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import (Error, Indices, Progress, Result, Tiles, flag, kept_property, number,
                         numbers_given, numbers_of, path_of, placed)
from ._options import Look
from ._outputs import Texture


class Relief(Result):
    """A closed mesh of a texture: what ``brindle.relief`` returns."""

    def __init__(self, positions: Any, faces: Any, report: dict[str, Any], texture: Texture) -> None:
        self._positions = positions
        self.faces: Indices = faces
        self.report = report
        self.texture = texture

    def __repr__(self) -> str:
        state = "closed" if self.report["closed"] else "open"
        return f"<brindle.Relief: {len(self.faces)} triangles, {state}, on {self.texture.surface!r}>"

    @kept_property
    def vertices(self) -> NDArray[np.floating]:
        """(n, 3)."""
        return placed(self._positions, self.texture.surface.origin)

    def write(self, path: Any) -> None:
        """Writes .stl (binary), .3mf, .ply, .obj, .vtp, .gltf or .glb, atomically."""
        _core.write_mesh(path_of(path), self.texture.surface.origin, self._positions, self.faces, {}, {}, b"")


def relief(texture: Texture, tile: Any, height: float, *, tolerance: Optional[float] = None,
           tiles: Optional[Tiles] = None, keep_flat: bool = False,
           only: Union[None, str, Sequence[float], ArrayLike] = None, inlay: Optional[float] = None,
           cut: bool = False, fill_holes: Optional[float] = None,
           progress: Optional[Progress] = None) -> Relief:
    """Raises a tile from the surface of a texture, as ``brindle relief`` does.

    ``tile``: "knurl", "bricks", "weave", "scales" and so on, or an array of pixels, whose grey values
    are heights. ``height``: of the highest places above the surface. ``tolerance``: greatest error
    (default: a twentieth of the height). ``tiles``: "whole" leaves out broken tiles, "cut" does not;
    None: by the tile. ``keep_flat``: flat faces wider than the spacing stay as they are. ``only``:
    (x, y, z) or (x, y, z, degrees), faces within that angle (45) of a direction; or an array (n,) or
    its name, faces whose vertices are above 0.5. ``inlay``: closed bodies from this depth to the
    height, one for each motif. ``cut``: a shell as thick as the height, with motifs as slots.
    ``fill_holes``: holes up to this perimeter are filled (default: 0.5 diagonals of the bounding box;
    0: none). Lengths are in the units of the vertices."""
    if not isinstance(texture, Texture):
        raise TypeError(f"texture: expected brindle.Texture, got {type(texture).__name__}")
    given: dict[str, Any] = {"height": number(height, "height"), "keep_flat": flag(keep_flat, "keep_flat"),
                             "cut": flag(cut, "cut"),
                             **numbers_given(tolerance=tolerance, fill_holes=fill_holes, inlay=inlay)}
    if cut and inlay is not None:
        raise Error("cut: has no effect together with inlay")
    if only is not None:
        given.update(_chosen(texture, only))
    positions, faces, report = _core.relief(texture._core, tile, Look(tiles=tiles).whole, given, progress)
    return Relief(positions, faces, report, texture)


def _chosen(texture: Texture, only: Any) -> dict[str, Any]:
    """Faces towards a direction, or by an array."""
    surface = texture.surface
    if not isinstance(only, str) and len(only) in (3, 4):
        x, y, z, degrees = (numbers_of(only, "only", "x, y, z and degrees", 3, 4) + [45.0])[:4]
        if x == y == z == 0:
            raise Error("only: expected a direction, got zero")
        return {"towards": (x, y, z, degrees)}
    weights = np.asarray(surface.array(only) if isinstance(only, str) else only, dtype=np.float32)
    counts = {len(one.vertices) for one in (surface, *texture._also_on)}
    if weights.ndim != 1 or len(weights) not in counts:
        raise Error(f"only: expected a direction or an array of one number for each of the "
                    f"{len(surface.vertices)} vertices")
    return {"weights": weights}
