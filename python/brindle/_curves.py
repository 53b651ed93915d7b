"""Stripes as curves, and samples where two patterns cross."""

from __future__ import annotations

import json
from functools import cached_property
from typing import TYPE_CHECKING, Any, Iterator, Mapping, Optional, Union

from . import _core
from ._arguments import (PhaseShift, Result, Solver, Weights, count_and_frequency, flag,
                         kept_property, number, one_of_both, path_of, solving, warn, whole_number)
from ._stripes import Field, Stripes, defaults_of, frequencies_of, invocation
from ._surface import Progress, Surface, as_surface

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray

CURVE_ENDS = ("closed", "boundary", "no_wave", "nonmanifold", "branch", "singularity",
              "crease")


def placed(points: Any, origin: tuple[float, float, float]) -> Any:
    """Points in absolute coordinates."""
    if origin == (0.0, 0.0, 0.0):
        return points
    import numpy as np
    return points.astype(np.float64) + np.asarray(origin)


class Curves(Result):
    """The centre lines of stripes. ``points, edges = curves`` are ready for a curve network."""

    def __init__(self, core: "_core.Curves", stripes: Stripes) -> None:
        self._core = core
        self.stripes = stripes

    def __iter__(self) -> "Iterator[NDArray[Any]]":
        return iter((self.points, self.edges))

    def __repr__(self) -> str:
        return (f"<brindle.Curves: {self.count} curves of {len(self.points)} points, length "
                f"{self.lengths.sum():.4g}, on {self.stripes.surface!r}>")

    @property
    def count(self) -> int:
        """The number of curves."""
        return len(self._core.closed)

    @kept_property
    def points(self) -> "NDArray[np.floating]":
        """(k, 3) points on the surface, curve after curve."""
        return placed(self._core.local_points, self.stripes.surface.origin)

    @kept_property
    def edges(self) -> "NDArray[np.int32]":
        """(l, 2) point numbers of the edges; closed curves return to their first point."""
        return self._core.edges()

    @property
    def normals(self) -> "NDArray[np.float32]":
        """(k, 3) unit normals of the surface."""
        return self._core.normals

    @property
    def offsets(self) -> "NDArray[np.int32]":
        """(count + 1,): curve i has the points offsets[i] up to offsets[i + 1]."""
        return self._core.offsets

    @property
    def closed(self) -> "NDArray[np.bool_]":
        """(count,) whether a curve is closed; its first point is not repeated."""
        return self._core.closed

    @kept_property
    def lengths(self) -> "NDArray[np.float64]":
        """(count,) lengths, including the closing edge."""
        return self._core.lengths()

    @cached_property
    def ends(self) -> list[tuple[str, str]]:
        """The reasons why each curve ends at its first and its last point: "closed", "boundary",
        "no_wave", "nonmanifold", "branch", "singularity" or "crease"."""
        return [(CURVE_ENDS[first], CURVE_ENDS[last]) for first, last in self._core.ends()]

    @property
    def lines(self) -> "list[NDArray[np.floating]]":
        """The points of every curve, (?, 3) each."""
        import numpy as np
        return np.split(self.points, self.offsets[1:-1]) if self.count else []

    @property
    def places(self) -> "tuple[NDArray[np.int32], NDArray[np.float64]]":
        """Where the points are on the mesh: triangles (k,), barycentric coordinates (k, 3)."""
        return self._core.places()

    def carried(self, array: "Union[str, ArrayLike]", *, axes: bool = False) -> "NDArray[Any]":
        """An array of the surface, or its name, at the points: of a row per vertex, means of the
        triangle's corners (whole numbers come from the nearest one); of a row per triangle, that
        row. With ``axes``, signs of vectors do not count."""
        return self._core.carried(*self.stripes.surface._own_array(array), flag(axes, "axes"))

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
                **json.loads(self.stripes._core.making()),
                **{key: quality[key] for key in ("frequency_change",) if key in quality}}

    def measures(self, path_width: float = 0) -> dict[str, Any]:
        """Metrics for fabrication: ``lengths``, ``gaps`` between neighbours (in a build with
        nanoflann) and, for a width above 0, ``coverage``, the share of the surface's area that
        lines of this width cover. Lengths are in the units of the vertices."""
        return self._core.measures(self.stripes._core, number(path_width, "path_width"))

    def tubes(self, radius: float, sides: int = 8) -> Surface:
        """Tubes around the curves, as a surface, for printing and pictures."""
        vertices, triangles = self._core.tubes(number(radius, "radius"), whole_number(sides, "sides"))
        return Surface(placed(vertices, self.stripes.surface.origin), triangles)

    def write(self, path: Any, *, name: str = "u",
              point_data: Optional[Mapping[str, "ArrayLike"]] = None) -> None:
        """Writes .obj, .ply, .vtp or .csv lines, or a drawing (``.svg``, as ``draw``),
        atomically. ``point_data``: arrays with a row per point."""
        text = path_of(path)
        if text.lower().endswith(".svg"):
            self.draw(text)
            return
        self._core.write(text, name, dict(point_data or {}))

    def draw(self, path: Any, **options: Any) -> None:
        """Writes an SVG drawing without hidden lines; size, camera, projection, up, colors
        and slice as in ``brindle.render``."""
        from ._pictures import draw_curves
        draw_curves(path_of(path), self, options)


def curves_of(stripes: Stripes, join: bool, trim: Optional[float], fair: float, offset: float,
              min_length: float, simplify: Optional[float], resample: Optional[float]) -> Curves:
    request = _core.CurveRequest()
    request.join = flag(join, "join")
    if trim is not None:
        request.trim = number(trim, "trim")
    request.fair = number(fair, "fair")
    request.offset = number(offset, "offset")
    request.min_length = number(min_length, "min_length")
    if simplify is not None:
        request.simplify = number(simplify, "simplify")
    if resample is not None:
        request.resample = number(resample, "resample")
    made = _core.curves(stripes._core, request)
    warn(made.warnings(), 4)
    return Curves(made, stripes)


class Samples(Result):
    """Points where two patterns cross. ``points, normals = samples`` are (k, 3) each."""

    def __init__(self, core: "_core.Samples", surface: Surface, u: Stripes, v: Stripes) -> None:
        self._core = core
        self._also_on = u._also_on
        self.surface = surface
        self.u = u
        self.v = v

    def __iter__(self) -> "Iterator[NDArray[Any]]":
        return iter((self.points, self.normals))

    def __repr__(self) -> str:
        spacing = " x ".join(f"{each.mean():.4g}" for each in self.spacings) if self.count else "none"
        return f"<brindle.Samples: {self.count} samples, spacing {spacing}, on {self.surface!r}>"

    @kept_property
    def _columns(self) -> "dict[str, NDArray[Any]]":
        return self._core.columns()

    @property
    def count(self) -> int:
        """k, the number of samples."""
        return self._core.count

    @kept_property
    def points(self) -> "NDArray[np.floating]":
        """(k, 3) positions on the surface."""
        return placed(self._columns["points"], self.surface.origin)

    @property
    def normals(self) -> "NDArray[np.float32]":
        """(k, 3) unit normals."""
        return self._columns["normals"]

    @property
    def directions(self) -> "tuple[NDArray[np.float32], NDArray[np.float32]]":
        """(k, 3) unit tangent directions of U and of V, up to sign."""
        return self._columns["directions_u"], self._columns["directions_v"]

    @property
    def spacings(self) -> "tuple[NDArray[np.float32], NDArray[np.float32]]":
        """(k,) target distances to the next sample along U and along V."""
        return self._columns["spacing_u"], self._columns["spacing_v"]

    @property
    def places(self) -> "tuple[NDArray[np.int32], NDArray[np.float32]]":
        """Positions of the samples on the mesh: triangles (k,), barycentric coordinates (k, 3)."""
        return self._columns["triangles"], self._columns["barycentric"]

    def carried(self, array: "Union[str, ArrayLike]", *, axes: bool = False) -> "NDArray[Any]":
        """An array of the surface at the samples, as ``Curves.carried``."""
        return self._core.carried(*self.surface._own_array(array), flag(axes, "axes"))

    @cached_property
    def report(self) -> dict[str, Any]:
        """The samples' own metrics of ``brindle sample --report``."""
        return {"samples": self.count, "doubles_left_out": self._core.doubles,
                "branches_u": self.u.report.get("branches", 0),
                "branches_v": self.v.report.get("branches", 0),
                "nearest_neighbour": self._core.spacing()}

    def write(self, path: Any, *, point_data: Optional[Mapping[str, "ArrayLike"]] = None) -> None:
        """Writes .csv, .ply or .vtp with positions on the mesh, directions and spacings,
        atomically. ``point_data``: arrays with a row per sample."""
        self._core.write(path_of(path), dict(point_data or {}))


def samples(surface: Any, directions: "Optional[ArrayLike]" = None, *, stripes: Any = None,
            frequency: Any = None, spacing: Optional[float] = None,
            directions_v: "Optional[ArrayLike]" = None, stripes_v: Any = None,
            frequency_v: Any = None, min_distance: float = 0.25,
            slack: Any = None, avoid_branches: "Optional[ArrayLike]" = None, solver: Solver = "multilevel",
            phase_shift: PhaseShift = "aligned", weights: Weights = "paper", epsilon: Optional[float] = None,
            momentum: Optional[float] = None, seed: Optional[int] = None,
            sweeps: Optional[int] = None, cycles: Optional[int] = None,
            global_iterations: Optional[int] = None,
            field_smoothing: Optional[float] = None, field_weight: Any = None,
            fill: Optional[float] = None, field_arrows: bool = False,
            field_singularities: Optional[int] = None, hold_out: Optional[float] = None,
            frequency_smoothing: Optional[float] = None, threads: int = 0,
            progress: Optional[Progress] = None) -> Samples:
    """Regular points along a field: crossings of the stripes across ``directions`` (U) with those
    along them (V). ``points, normals = brindle.samples(s, d, stripes=40)``.

    Arguments as for ``brindle.stripes``; ``directions_v``, ``stripes_v`` and ``frequency_v`` are
    V's (default: U's turned by 90 degrees, and U's frequency). Samples nearer to another than
    ``min_distance`` spacings are left out. Needs a build with nanoflann.
    """
    given = dict(locals())
    surface = as_surface(given.pop("surface"))
    given.pop("progress")
    options = solving(given, surface)
    field = Field(surface, directions, False, options=given)
    count, frequency = count_and_frequency(stripes, frequencies_of(surface, frequency), spacing)
    frequency_v = frequencies_of(surface, frequency_v)
    one_of_both("stripes_v", stripes_v, "frequency_v", frequency_v)
    count_v, frequency_v = (count, frequency) if stripes_v is None and frequency_v is None else (
        stripes_v, frequency_v)

    first = field.origin
    said = invocation("samples", surface, given, _DEFAULTS)

    def pattern(of: Field, directions: Any, count: Any, frequency: Any) -> Stripes:
        of.origin.see_frequencies_like(first)
        made = _core.stripes(surface._core, directions, count, frequency, of.origin, options, None,
                             "", progress)
        warn(made.warnings(of.origin.source), 4)
        return Stripes(made, surface, said)

    u = pattern(field, field.directions, count, frequency)
    if directions_v is None:
        across = surface.turned_field(u.directions, 90)
        if field.is_detailed:  # once is enough
            source, field = field.origin.source, Field(surface, across, False)
            field.origin.source = source
        v = pattern(field, across, count_v, frequency_v)
    else:
        other = Field(surface, directions_v, False)
        v = pattern(other, other.directions, count_v, frequency_v)
    return samples_of(u, v, min_distance=min_distance)


_DEFAULTS = defaults_of(samples)


def samples_of(u: Stripes, v: Stripes, *, min_distance: float = 0.25) -> Samples:
    """Crossings of the stripes of two patterns on one surface."""
    made = _core.samples(u._core, v._core, number(min_distance, "min_distance"))
    return Samples(made, u.surface, u, v)
