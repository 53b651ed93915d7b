"""Pictures as arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping, Optional, Sequence, Union

from . import _core
from ._arguments import Error, Projection, Tiles, Up, View, flag, number, path_of, warn, whole_number, word
from ._curves import Curves, Samples
from ._stripes import Stripes
from ._surface import Surface, as_surface
from ._textures import Texture

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

_STRIPE_COLOR = "#1c325a"
_SAMPLE_COLOR = "#c7422b"
_OPTIONS = {"size": (1200, 900), "camera": (30, 20), "projection": None, "up": None, "colors": None,
            "light_from": None, "slice": None}


#: Whether this build draws pictures.
has_opengl: bool = _core.has_opengl


def picture_of(surface: Surface, *, size: Sequence[int] = (1200, 900),
               camera: Union[str, Sequence[float]] = (30, 20),
               projection: Optional[Projection] = None, up: Optional[Up] = None,
               colors: Optional[Sequence[str]] = None,
               light_from: Optional[Sequence[float]] = None, slice: Optional[str] = None,
               **unknown: Any) -> "_core.Picture":
    if unknown:
        raise TypeError(f"{next(iter(unknown))}: no option of pictures; there are "
                        f"{', '.join(_OPTIONS)}")
    picture = _core.Picture()
    try:
        width, height = size
        azimuth, elevation, *rest = (0, 0) if isinstance(camera, str) else camera
        zoom = rest[0] if rest else 1
        if len(rest) > 1:
            raise ValueError("too many numbers")
    except (TypeError, ValueError) as error:
        raise Error("expected size=(width, height) and camera=(azimuth, elevation[, zoom]) or a side "
                    "such as 'front'") from error
    picture.set_size(whole_number(width, "size"), whole_number(height, "size"))
    axis = word(surface._core.up if up is None else up, "up")
    if isinstance(camera, str):
        picture.set_side(camera, axis)
    else:
        picture.set_camera(number(azimuth, "camera"), number(elevation, "camera"),
                           number(zoom, "camera"), axis)
    if projection is not None:
        picture.set_projection(word(projection, "projection"))
    if colors is not None:
        picture.set_colors([word(color, "colors") for color in colors])
    if light_from is not None:
        try:
            azimuth, elevation = light_from
        except (TypeError, ValueError) as error:
            raise Error("light_from: expected (azimuth, elevation) in degrees") from error
        picture.set_light_from(number(azimuth, "light_from"), number(elevation, "light_from"))
    if slice is not None:
        picture.set_slice(word(slice, "slice"))
    return picture


def render(surface: Any, pattern: Any = None, *, size: Sequence[int] = (1200, 900),
           camera: Union[str, Sequence[float]] = (30, 20),
           projection: Optional[Projection] = None, up: Optional[Up] = None,
           colors: Optional[Sequence[str]] = None, view: Optional[View] = None,
           stripe_width: Optional[float] = None, tile: Any = None, tiles: Optional[Tiles] = None,
           tube_radius: Optional[float] = None, transparent: bool = False,
           shading: bool = True, light_from: Optional[Sequence[float]] = None,
           slice: Optional[str] = None) -> "NDArray[np.uint8]":
    """A picture (h, w, 4) of uint8: red, green, blue and alpha, row by row from the top; equal to
    that of the tool with the same options.

    ``pattern``: Stripes, Texture, Curves, Samples or None, of this surface. ``size``: (width,
    height) in pixels. ``camera``: (azimuth, elevation) in degrees, and a zoom; or "front", "back",
    "left", "right", "top" or "bottom", as in "front,2" with a zoom. ``projection``: "perspective"
    (None) or "orthographic", which keeps parallel lines. ``up``: the axis that points up, x, y, z, -x, -y or -z; None: z for built-in shapes and .stl, else y. ``colors``: those of stripes,
    surface and background, like "#1c325a". ``view`` of stripes: "stripes", "branches" or
    "angle_error"; ``stripe_width``: share of the period, 0 to 1. ``tile`` of textures: "checker",
    "dots", "arrows" and so on, or an array of pixels; ``tiles``: "whole" leaves out those that a
    branch, a seam or the border would cut, "cut" draws what is left of them; None: whole for tiles
    with a shape of their own, such as dots and arrows. ``tube_radius`` of curves. ``transparent``:
    no background. ``shading``: light; ``light_from``: (azimuth, elevation) in degrees from the
    viewer, (90, 0) from the right and (0, 90) from above; None: from the upper left.
    ``slice``: a plane beyond which nothing is seen, such as "x=0.2", "z=50%" of the bounding box,
    "-z=50%" for the other side, or "X,Y,Z,NX,NY,NZ", a point and a normal.

    Needs no display, but a build with OpenGL; otherwise, and for a slice that leaves nothing,
    raises brindle.Error.
    """
    surface = as_surface(surface)
    picture = picture_of(surface, size=size, camera=camera, projection=projection, up=up,
                         colors=colors, light_from=light_from, slice=slice)
    picture.transparent = flag(transparent, "transparent")
    picture.shading = flag(shading, "shading")
    if not picture.shading and light_from is not None:
        raise Error("light_from has no effect here: there is no light; leave out shading=False")
    _refuse_unused(pattern, view, stripe_width, tile, tiles, tube_radius)
    if isinstance(pattern, (Stripes, Texture, Curves, Samples)):
        _check_belongs(surface, pattern)
    if view is not None:
        picture.set_view(word(view, "view"))
    if stripe_width is not None:
        picture.set_stripe_width(number(stripe_width, "stripe_width"))
    if isinstance(pattern, Texture):
        image, warnings = _core.render_texture(pattern._core, "checker" if tile is None else tile,
                                               whole_tiles(tiles), picture)
        warn(warnings)
        return image
    if isinstance(pattern, (Curves, Samples)):
        return _render_ornaments(surface, pattern, colors, tube_radius, picture)
    if pattern is not None and not isinstance(pattern, Stripes):
        raise TypeError(f"pattern: expected Stripes, Texture, Curves or Samples, got "
                        f"{type(pattern).__name__}")
    return _core.render(surface._core, None if pattern is None else pattern._core, picture)


def notebook_png(thing: Any) -> Optional[bytes]:
    """A small picture, for notebooks; None, so that they show the text, where none can be drawn."""
    if not has_opengl:
        return None
    surface = thing.stripes.surface if isinstance(thing, Curves) else getattr(thing, "surface", thing)
    try:
        image = render(surface, None if surface is thing else thing, size=(480, 360))
    except Error:
        return None
    return _core.tile_png(image, _core.Picture(), False)


def whole_tiles(tiles: Optional[Tiles]) -> Optional[bool]:
    """What ``tiles`` asks for; None: what suits the tile."""
    if tiles is None:
        return None
    if word(tiles, "tiles") not in ("whole", "cut"):
        raise Error(f"tiles: expected one of whole|cut, got '{tiles}'")
    return tiles == "whole"


def _refuse_unused(pattern: Any, view: Any, stripe_width: Any, tile: Any, tiles: Any,
                   tube_radius: Any) -> None:
    stripes, texture = isinstance(pattern, Stripes), isinstance(pattern, Texture)
    for name, value, used in (("view", view, stripes or texture),
                              ("stripe_width", stripe_width, stripes),
                              ("tile", tile, texture),
                              ("tiles", tiles, texture),
                              ("tube_radius", tube_radius, isinstance(pattern, Curves))):
        if value is not None and not used:
            raise Error(f"{name} has no effect here: the picture shows something else")


def _check_belongs(surface: Surface, pattern: Any) -> None:
    """Accepts, for crosses, the given surface or the one with split triangles."""
    made_for = pattern.stripes if isinstance(pattern, Curves) else pattern
    counts = [(s.vertex_count, s.triangle_count) for s in (made_for.surface, *made_for._also_on)]
    if (surface.vertex_count, surface.triangle_count) not in counts:
        raise Error("the pattern was not made for this surface")


def _color(colors: Optional[Sequence[str]]) -> str:
    return _STRIPE_COLOR if colors is None else colors[0]


def _render_ornaments(surface: Surface, pattern: Any, colors: Any, tube_radius: Any,
                      picture: "_core.Picture") -> Any:
    if isinstance(pattern, Curves):
        radius = tube_radius
        if radius is None:
            radius = 1 / (12 * float(pattern.stripes.frequency.mean()))
        mesh, color = pattern.tubes(radius), _color(colors)
    else:
        mesh, color = _discs(pattern), _SAMPLE_COLOR if colors is None else colors[0]
    ornament = _core.Ornament(mesh.vertices, mesh.triangles, color)
    return _core.render_ornaments(surface._core, [ornament], picture)


def _discs(samples: Samples) -> Surface:
    """Discs a third of the spacing wide, just above and below the surface, whose winding may be
    either."""
    import numpy as np
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


def draw_curves(path: str, curves: Curves, options: Mapping[str, Any]) -> None:
    surface = curves.stripes.surface
    if options.get("light_from") is not None:
        raise Error("light_from has no effect here: a drawing of lines shows no light")
    picture = picture_of(surface, **options)
    pen = _core.PenLines("u", _color(options.get("colors")), curves._core.local_points,
                         curves.offsets, curves.closed.astype("u1"))
    _core.draw_lines(path, surface._core, [pen], picture)


def tile_png(tile: Any, colors: Optional[Sequence[str]], of_crosses: bool = False) -> bytes:
    """A tile as a PNG file, by name or as an array of pixels. Raises Error for a tile without the
    symmetry of crosses."""
    picture = _core.Picture()
    if colors is not None:
        picture.set_colors([word(color, "colors") for color in colors])
    return _core.tile_png(tile, picture, of_crosses)


def write_png(path: Any, image: "NDArray[np.uint8]") -> None:
    """Writes an array of pixels (h, w, 3 or 4) of uint8 to a .png file, atomically."""
    _core.write_png(path_of(path), image)


def read_png(path: Any) -> "NDArray[np.uint8]":
    """Reads the pixels (h, w, 4) of a PNG file."""
    return _core.read_png(path_of(path))
