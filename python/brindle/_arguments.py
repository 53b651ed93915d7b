"""Checks of arguments, errors, and what results have in common."""

from __future__ import annotations

import numbers
import os
import warnings
from functools import cached_property, wraps
from typing import TYPE_CHECKING, Any, Callable, Literal, Mapping

import numpy as np
from numpy.typing import NDArray

from . import _core

# The words of arguments with choices, for editors and type checkers; the C++ side checks them.
SolverName = Literal["multilevel", "relaxation", "averaged", "global"]
FrameSolver = Literal["multilevel", "relaxation"]
PhaseShift = Literal["aligned", "common_source", "trapezoid"]
Match = Literal["number", "position"]
Run = Literal["along", "across"]
Curvature = Literal["max", "min"]
TensorAxis = Literal["major", "minor", "max-abs", "tangent-major", "tangent-minor"]
TensorOrder = Literal["vtk", "voigt", "plane"]
View = Literal["stripes", "branches", "angle_error"]
Tiles = Literal["whole", "cut"]
Projection = Literal["perspective", "orthographic"]
Up = Literal["x", "y", "z", "-x", "-y", "-z"]

Floats = NDArray[np.float32]
Indices = NDArray[np.int32]
Arrays = dict[str, NDArray[Any]]
Progress = Callable[[str, float], Any]

Error = _core.Error
Cancelled = _core.Cancelled
Error.__module__ = Cancelled.__module__ = "brindle"
Error.__doc__ = """A job that could not be done: what is wrong, where, and what to do about it."""
Cancelled.__doc__ = """A job that a progress function stopped by returning False."""


class PatternWarning(UserWarning):
    """A likely mistake: missing waves, stripes too fine for the mesh, arrays that a file cannot
    hold."""


def frozen(value: Any) -> Any:
    """The value with read-only arrays, also within dictionaries and tuples."""
    if hasattr(value, "flags"):
        value.flags.writeable = False
    elif isinstance(value, (dict, tuple)):
        for part in value.values() if isinstance(value, dict) else value:
            frozen(part)
    return value


if TYPE_CHECKING:
    kept_property = cached_property
else:
    class kept_property(cached_property):
        """A cached property with a read-only value."""

        def __init__(self, function):
            super().__init__(wraps(function)(lambda owner: frozen(function(owner))))


class Result:
    """What copies and pickles without its cached properties, which are made again."""

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items()
                if not isinstance(getattr(type(self), name, None), cached_property)}


class Running:
    """What depends on the calls before, and is neither copied nor pickled."""

    _INSTEAD = "pickle its surface, and make a new one of it"
    surface: Any

    def __repr__(self) -> str:
        return f"<brindle.{type(self).__name__} on {self.surface!r}>"

    def __reduce__(self) -> Any:
        raise TypeError(f"brindle.{type(self).__name__} cannot be pickled or copied; {self._INSTEAD}")


def path_of(path: Any) -> str:
    """The path as text. Raises TypeError for anything but a string, bytes or an os.PathLike."""
    if not isinstance(path, (str, bytes, os.PathLike)):
        raise TypeError(f"expected a path, got {type(path).__name__}; open files are not taken")
    return os.fsdecode(path)


def warn(text: str, level: int = 3) -> None:
    """Gives a warning per line."""
    for line in text.splitlines():
        line = _core.in_pythons_words(line).removeprefix("warning: ")
        warnings.warn(line, PatternWarning, stacklevel=level)


def number(value: Any, what: str) -> float:
    """A finite or infinite number. Raises TypeError for anything else."""
    if isinstance(value, (bool, str, bytes)):
        raise TypeError(f"{what}: expected a number, got {value!r}")
    try:
        return float(value)
    except (TypeError, ValueError) as error:
        raise TypeError(f"{what}: expected a number, got {type(value).__name__}") from error


def numbers_given(**values: Any) -> dict[str, float]:
    """Numbers by name, without those that are None."""
    return {name: number(value, name) for name, value in values.items() if value is not None}


def distance(value: Any, what: str) -> float:
    """A number of 0 or more, possibly infinite. Raises Error for others."""
    result = number(value, what)
    if not result >= 0:
        raise Error(f"{what}: expected 0 or more, got {result}")
    return result


def numbers_of(value: Any, what: str, expected: str, *counts: int) -> list[float]:
    """So many numbers. Raises Error for other counts."""
    try:
        parts = list(value)
    except TypeError as error:
        raise Error(f"{what}: expected {expected}") from error
    if len(parts) not in counts:
        raise Error(f"{what}: expected {expected}")
    return [number(part, what) for part in parts]


def whole_number(value: Any, what: str) -> int:
    """Raises TypeError for other than integers, Error beyond 32 bits."""
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise TypeError(f"{what}: expected a whole number, got {type(value).__name__}")
    result = value.__index__()
    if abs(result) >= 2**31:
        raise Error(f"{what}: {result} is out of range")
    return result


def flag(value: Any, what: str) -> bool:
    """Raises TypeError for anything but True and False."""
    if isinstance(value, (bool, np.bool_)):
        return bool(value)
    raise TypeError(f"{what}: expected True or False, got {value!r}")


def word(value: Any, what: str) -> str:
    """Raises TypeError for anything but a string."""
    if not isinstance(value, str):
        raise TypeError(f"{what}: expected a string, got {type(value).__name__}")
    return value


def option_name(argument: str) -> str:
    """The tool's name of an option, without dashes: stiffness is --lambda."""
    return {"stiffness": "lambda"}.get(argument, argument).replace("_", "-")


def in_range(name: str, value: Any, written: Any) -> Any:
    """The value. Raises Error with the tool's message for a number outside its option's range."""
    _core.check_number(option_name(name), value, str(written))
    return value


def check_scalar(name: str, value: Any) -> None:
    """The same for a number; ignores other types, such as arrays."""
    if isinstance(value, numbers.Real) and not isinstance(value, bool):
        in_range(name, value, value)


def described(options: Mapping[Any, Any], defaults: Mapping[str, Any]) -> dict[Any, Any]:
    """Options in a report: those other than the defaults, arrays by their shape."""
    result: dict[Any, Any] = {}
    for name, value in options.items():
        if value is None or value is defaults.get(name):
            continue
        if hasattr(value, "given"):
            result.update(described(value.given(), {}))
        elif isinstance(value, (bool, int, float, str)):
            result[name] = value
        elif isinstance(value, tuple):
            result[name] = list(described(dict(enumerate(value)), {}).values())
        elif hasattr(value, "shape"):
            shape = tuple(value.shape)
            result[name] = value.item() if shape == () else f"array {shape}"
        else:
            result[name] = type(value).__name__
    return result


def placed(points: Any, origin: tuple[float, float, float]) -> Any:
    """Points in absolute coordinates."""
    return points if origin == (0, 0, 0) else points.astype(np.float64) + np.asarray(origin)


