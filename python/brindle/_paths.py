"""Curves as paths of a tool."""

from __future__ import annotations

from typing import Any, Literal, Optional

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arguments import (Error, kept_property, number, numbers_given, numbers_of, path_of, placed,
                         whole_number)
from ._outputs import Curves

Order = Literal["nearest", "boustrophedon", "layers", "spiral"]

_NUMBERS = ("thickness", "filament", "speed", "travel_speed", "lift")


class Paths:
    """Paths in the order of travel, with data at each of their points."""

    def __init__(self, core: _core.Paths, curves: Curves) -> None:
        self._core = core
        self.curves = curves

    def __repr__(self) -> str:
        report = self.report
        return (f"<brindle.Paths: {report['paths']} paths of length {report['length']:.4g}, travel "
                f"{report['travel']:.4g}, on {self.curves.stripes.surface!r}>")

    @kept_property
    def _columns(self) -> dict[str, NDArray[Any]]:
        return self._core.columns()

    @kept_property
    def points(self) -> NDArray[np.floating]:
        """(k, 3) points, path after path."""
        return placed(self._columns["points"], self.curves.stripes.surface.origin)

    @property
    def offsets(self) -> NDArray[np.int32]:
        """(paths + 1,): path i has the points offsets[i] up to offsets[i + 1]."""
        return self._columns["offsets"]

    @property
    def normals(self) -> NDArray[np.float32]:
        """(k, 3) unit normals of the surface."""
        return self._columns["normals"]

    @property
    def directions(self) -> NDArray[np.float32]:
        """(k, 3) unit vectors along which the tool travels."""
        return self._columns["directions"]

    @property
    def poses(self) -> NDArray[np.float32]:
        """(k, 4) unit quaternions w, x, y, z, which turn x into the direction, z into the normal."""
        return self._columns["poses"]

    @property
    def widths(self) -> NDArray[np.float32]:
        """(k,) mean distances to the curves on both sides."""
        return self._columns["widths"]

    @property
    def joins(self) -> NDArray[np.uint8]:
        """(k,) 1 where the segment to the next point joins two curves."""
        return self._columns["joins"]

    @property
    def cuts(self) -> NDArray[np.uint8]:
        """(k,) 1 behind the cut of fibre (``cut_length``)."""
        return self._columns["cuts"]

    @kept_property
    def report(self) -> dict[str, Any]:
        """Lengths, travel and counts, as in ``brindle paths --report``."""
        return self._core.metrics()

    def write(self, path: Any, *, gcode: Literal["marlin", "plain"] = "marlin", axes: int = 3,
              scale: float = 1, place: Optional[tuple[float, float, float]] = None,
              **machine: float) -> None:
        """Writes .gcode, .dxf, .csv, .vtp, .ply or .obj, atomically. ``scale``: millimetres in a unit
        of length; ``place``: millimetres, the middle of the paths' base. Further numbers of the
        machine: ``thickness``, ``filament``, ``speed``, ``travel_speed``, ``lift``."""
        if gcode not in ("marlin", "plain"):
            raise Error(f"gcode: {gcode!r}; give marlin or plain")
        for name in machine:
            if name not in _NUMBERS:
                raise TypeError(f"write() has no argument '{name}'; it has {', '.join(_NUMBERS)}")
        options: dict[str, Any] = {name: number(value, name)
                                   for name, value in {"scale": scale, **machine}.items()}
        options.update(plain=gcode == "plain", axes=whole_number(axes, "axes"))
        if place is not None:
            options["place"] = numbers_of(place, "place", "x, y and z", 3)
        self._core.write(path_of(path), options)


def paths(curves: Curves, *, order: Order = "nearest", width: Optional[float] = None,
          connect: Optional[float] = None, least_radius: float = 0, least_length: float = 0,
          cut_length: float = 0) -> Paths:
    """Orders curves for a tool, joins their ends and measures them, as ``brindle paths`` does.

    ``width``: of the trace (default: the mean spacing). ``connect``: ends this near are joined along
    the surface (default: two widths; 0 with ``least_radius`` and ``order="spiral"``).
    ``least_radius``: curves are cut at tighter bends. ``least_length``: shorter ones are left out.
    ``cut_length``: marks this much of each path's end, for fibre. A spiral is one curve, as
    ``brindle.stripes(..., layout=Layout(winding=1))`` makes it. Lengths are in the units of the vertices."""
    stripes = curves.stripes
    if width is None:
        width = 1 / stripes.frequency.mean(dtype=float)
    if connect is not None and connect > 0 and (least_radius > 0 or order == "spiral"):
        raise Error("connect: joins are sharp bends, and a spiral is one path; leave it out")
    options = {"width": number(width, "width"), **numbers_given(connect=connect),
               "least_radius": number(least_radius, "least_radius"),
               "least_length": number(least_length, "least_length"),
               "cut_length": number(cut_length, "cut_length")}
    return Paths(_core.tool_paths(curves._core, order, options), curves)
