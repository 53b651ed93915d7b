"""Cameras, colours and sizes of pictures, and what is drawn in them."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union

from . import _core
from ._arguments import Error, Projection, Up, number, numbers_of, whole_number, word
from ._options import Look


def picture_of(surface: Any, size: Sequence[int] = (1200, 900),
               camera: Union[str, Sequence[float]] = (30, 20),
               projection: Optional[Projection] = None, up: Optional[Up] = None,
               slice: Optional[str] = None, colors: Optional[Sequence[str]] = None) -> _core.Picture:
    picture = _core.Picture()
    try:
        width, height = size
    except (TypeError, ValueError) as error:
        raise Error("size: expected (width, height)") from error
    picture.set_size(whole_number(width, "size"), whole_number(height, "size"))
    axis = word(surface._core.up if up is None else up, "up")
    if isinstance(camera, str):
        picture.set_side(camera, axis)
    else:
        azimuth, elevation, *zoom = numbers_of(
            camera, "camera", "(azimuth, elevation[, zoom]) or a side such as 'front'", 2, 3)
        picture.set_camera(azimuth, elevation, zoom[0] if zoom else 1, axis)
    if projection is not None:
        picture.set_projection(word(projection, "projection"))
    if slice is not None:
        picture.set_slice(word(slice, "slice"))
    if colors is not None:
        picture.set_colors([word(color, "colors") for color in colors])
    return picture


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
    picture = _core.Picture()
    if colors is not None:
        picture.set_colors([word(color, "colors") for color in colors])
    return _core.tile_png(tile, picture, of_crosses)
