"""Fields and frequencies that patterns are asked for, as the C++ side takes them."""

from __future__ import annotations

import json
from time import perf_counter
from typing import Any, Mapping, Optional

from . import _core
from ._arguments import described
from ._options import Measured, Previous, group
from ._surface import Surface, flat_tensors, last_field

_TENSOR_COLUMNS = (6, 9)
_OWN_WEIGHTS = ("length", "anisotropy")


def _is_number(frequency: Any) -> bool:
    """Whether the frequency, of U in a pair, is uniform: a number or the default."""
    if isinstance(frequency, tuple) and len(frequency) == 2:
        frequency = frequency[0]
    return not isinstance(frequency, (str, list, tuple)) and not getattr(frequency, "shape", ())


class Field:
    """Directions of a pattern, and their origin; the ``symmetry`` of crosses is 4."""

    def __init__(self, surface: Surface, given: Any, along: bool = False, frequency: Any = None,
                 measured: Optional[Measured] = None, previous: Optional[Previous] = None,
                 symmetry: int = 2, oriented: bool = False) -> None:
        """``oriented``: vectors of a named array have signs: opposite ones cancel."""
        begin = perf_counter()
        self.origin = _core.FieldOrigin()
        self.origin.measured = given is not None
        smoothing = group(measured, Measured, "measured")
        self._signs = oriented or smoothing.field_arrows is True
        self.directions = (self._following(surface, previous) if given is None and previous is not None
                           else self._directions(surface, given, symmetry))
        options = smoothing.given()
        weight = options.get("field_weight")
        self.origin.smooth_data(options, 1 if smoothing.field_arrows and symmetry == 2 else symmetry,
                                  not _is_number(frequency), self._weights(surface, weight)
                                  if options.get("field_smoothing") else None)
        self.is_detailed = bool(options.get("field_smoothing"))
        if along:
            if not self.is_detailed:  # smoothing comes before the turn
                self.directions = surface.rotate_field(self.directions, 90)
            self.origin.turn_deg = 90
        self.origin.milliseconds = 1000 * (perf_counter() - begin)

    def _weights(self, surface: Surface, weight: Any) -> Any:
        if not isinstance(weight, str) or weight in _OWN_WEIGHTS:
            return weight
        _, array, is_of_cells = surface._core.array_named(weight)
        return array if is_of_cells and self._of_triangles else surface.array(weight)

    def _following(self, surface: Surface, previous: Previous) -> Any:
        """The smooth field that goes on from that of a pattern, before it was turned."""
        self.origin.source = "the smooth field"
        before, turn = previous.pattern.directions, previous.pattern._core.turn_deg
        if turn != 0:
            before = previous.pattern.surface.rotate_field(before, -turn)
        field, turned = surface._smooth_field(last=last_field(previous, before))
        self.origin.field_turned_deg = turned
        return field

    def _directions(self, surface: Surface, given: Any, symmetry: int) -> Any:
        self.origin.source = "the field"
        if given is None:
            self.origin.source = "the smooth field"
            return surface.smooth_field(symmetry=symmetry)
        if isinstance(given, str):
            self.origin.source = f"the array '{given}'"
            name, array, is_of_cells = surface._core.array_named(given)
            rows = surface.array(given) if self._signs else surface.axes(given)
            directions = self._of_array(surface, name, rows)
            if is_of_cells:  # before the transfer to vertices
                self.origin.rows_nonfinite = _core.nonfinite_rows(array)
                if self.origin.tensor is None:
                    self._of_triangles = True
                    self.origin.set_data(name, array, True)
            return directions
        if isinstance(given, (list, tuple)):
            given = _core.unmasked(given)
        shape: tuple[int, ...] = getattr(given, "shape", ())
        if len(shape) == 2 and shape[1] == 2 or len(shape) == 3 or (
                len(shape) == 2 and shape[1] in _TENSOR_COLUMNS):
            return self._of_array(surface, "directions", given)
        if len(shape) == 2 and shape[1] == 3:
            self.origin.set_data("directions", given, False)
        return given

    _of_triangles = False  # whether rows are those of triangles

    def _of_array(self, surface: Surface, name: str, array: Any) -> Any:
        array = flat_tensors(array)
        if len(array.shape) == 2 and array.shape[1] in _TENSOR_COLUMNS:
            directions, nonfinite, near_normal, isotropic, _ = _core.tensor_field(
                surface._core, name, array, "major")
            self.origin.tensor = (near_normal, isotropic)
        else:
            directions, nonfinite = _core.array_field(surface._core, name, array)
        self.origin.rows_nonfinite = nonfinite
        self.origin.set_data(name, array, False)
        return directions


def frequencies_of(surface: Surface, frequency: Any) -> Any:
    """A frequency, or those of a named array; pairs of both."""
    if isinstance(frequency, tuple):
        return tuple(frequencies_of(surface, each) for each in frequency)
    return surface.array(frequency) if isinstance(frequency, str) else frequency


def invocation(function: Any, surface: Surface, given: Mapping[str, Any]) -> str:
    """The call in reports, as JSON: keyword arguments other than the defaults."""
    defaults = function.__kwdefaults__
    options = {name: value for name, value in given.items()
               if name != "progress" and (name in defaults or name == "directions")}
    return json.dumps({"version": _core.version(), "command": function.__name__, "input": surface.name,
                       "options": described(options, defaults)})
