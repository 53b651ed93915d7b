"""Pictures as arrays."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arguments import Error, Projection, Up, View, path_of
from ._look import Drawn, picture_of
from ._options import Look, group
from ._surface import Surface, as_surface

#: Whether this build draws pictures.
has_opengl: bool = _core.has_opengl


def render(surface: Any, pattern: Any = None, *, size: Sequence[int] = (1200, 900),
           camera: Union[str, Sequence[float]] = (30, 20),
           projection: Optional[Projection] = None, up: Optional[Up] = None,
           slice: Optional[str] = None, colors: Optional[Sequence[str]] = None,
           view: Optional[View] = None, tile: Any = None,
           look: Optional[Look] = None) -> NDArray[np.uint8]:
    """A picture (h, w, 4) of uint8: red, green, blue and alpha, row by row from the top; equal to
    that of the tool with the same options.

    ``pattern``: Stripes, Texture, Curves, Samples or None, of this surface. ``size``: (width,
    height) in pixels. ``camera``: (azimuth, elevation) in degrees, and a zoom; or "front", "back",
    "left", "right", "top" or "bottom", as in "front,2" with a zoom. ``projection``: "perspective"
    (None) or "orthographic", which keeps parallel lines. ``up``: the axis that points up, x, y, z,
    -x, -y or -z; None: z for built-in shapes and .stl, else y. ``slice``: a plane beyond which
    nothing is seen, such as "x=0.2", "z=50%" of the bounding box, "-z=50%" for the other side, or
    "X,Y,Z,NX,NY,NZ", a point and a normal. ``colors``: those of stripes, surface and background,
    like "#1c325a". ``view`` of stripes: "stripes", "branches" or "angle_error". ``tile`` of
    textures: "checker", "dots", "arrows" and so on, or an array of pixels. ``look``: widths, light,
    broken tiles (``brindle.Look``).

    Needs no display, but a build with OpenGL; otherwise, and for a slice that leaves nothing,
    raises brindle.Error.
    """
    surface = as_surface(surface)
    chosen: Look = group(look, Look, "look")
    picture = picture_of(surface, size, camera, projection, up, slice, colors, view, chosen)
    if pattern is not None and (not isinstance(pattern, Drawn) or isinstance(pattern, Surface)):
        raise TypeError(f"pattern: expected Stripes, Texture, Curves or Samples, got "
                        f"{type(pattern).__name__}")
    shown = surface if pattern is None else pattern
    for name, value in (("view", view), ("stripe_width", chosen.stripe_width), ("tile", tile),
                        ("tiles", chosen.tiles), ("tube_radius", chosen.tube_radius)):
        if value is not None and name not in shown._SHOWS:
            raise Error(f"{name} has no effect here: the picture shows something else")
    if pattern is not None:
        _check_belongs(surface, pattern)
    return shown._drawn(surface, picture, chosen, tile)


def _check_belongs(surface: Surface, pattern: Any) -> None:
    """Accepts, for crosses, the given surface or the one with split triangles."""
    counts = [(s.vertex_count, s.face_count) for s in (pattern.surface, *pattern._also_on)]
    if (surface.vertex_count, surface.face_count) not in counts:
        raise Error("the pattern was not made for this surface")


def write_png(path: Any, image: NDArray[np.uint8]) -> None:
    """Writes an array of pixels (h, w, 3 or 4) of uint8 to a .png file, atomically."""
    _core.write_png(path_of(path), image)


def read_png(path: Any) -> NDArray[np.uint8]:
    """Reads the pixels (h, w, 4) of a PNG file."""
    return _core.read_png(path_of(path))
