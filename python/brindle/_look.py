"""Cameras, colours and sizes of pictures, and what is drawn in them."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union, get_args

from . import _core
from ._arguments import Error, Projection, Up, View, numbers_of, whole_number, word
from ._options import Look, checked


def picture_of(surface: Any, size: Sequence[int] = (1200, 900),
               camera: Union[str, Sequence[float]] = (30, 20),
               projection: Optional[Projection] = None, up: Optional[Up] = None,
               slice: Optional[str] = None, colors: Optional[Sequence[str]] = None,
               view: Optional[View] = None, look: Look = Look()) -> _core.Picture:
    if projection is not None and word(projection, "projection") not in get_args(Projection):
        raise Error(f"projection: '{projection}' is none of perspective, orthographic")
    try:
        width, height = size
    except (TypeError, ValueError) as error:
        raise Error("size: expected (width, height)") from error
    given = {"size": (whole_number(width, "size"), whole_number(height, "size")),
             "up": checked("up", surface._core.up if up is None else up),
             "camera": camera if isinstance(camera, str) else text_of(
                 camera, "camera", "(azimuth, elevation[, zoom]) or a side such as 'front'", 2, 3),
             "projection": projection, "slice": slice if slice is None else word(slice, "slice"),
             "colors": colors_of(colors), "view": view if view is None else checked("view", view),
             "stripe_width": look.stripe_width, "transparent": look.transparent, "shading": look.shading,
             "light_from": look.light_from and text_of(look.light_from, "light_from", "two angles", 2)}
    return _core.Picture({name: value for name, value in given.items() if value is not None})


def text_of(values: Any, what: str, expected: str, *counts: int) -> str:
    """Numbers as the tool takes them."""
    return ",".join(map(repr, numbers_of(values, what, expected, *counts)))


def colors_of(colors: Optional[Sequence[str]]) -> list[str]:
    return [word(color, "colors") for color in colors or ()]


class Drawn:
    """What pictures show, also in notebooks."""

    __slots__ = ()

    #: Options of a picture that have an effect here.
    _SHOWS: tuple[str, ...] = ()
    surface: Any

    def _drawn(self, surface: Any, picture: _core.Picture, look: Look, tile: Any) -> Any:
        raise NotImplementedError

    def _repr_png_(self) -> Optional[bytes]:
        """None, so that notebooks show the text, where no picture can be drawn."""
        if not _core.has_opengl:
            return None
        surface = getattr(self, "surface", self)
        try:
            return _core.png_of(self._drawn(surface, picture_of(surface, (480, 360)), Look(), None))
        except Error:
            return None


def tile_png(tile: Any, colors: Optional[Sequence[str]], of_crosses: bool) -> bytes:
    """A tile as a PNG file, by name or as an array of pixels. Raises Error for a tile without the
    symmetry of crosses."""
    return _core.tile_png(tile, _core.Picture({"colors": colors_of(colors)}), of_crosses)
