"""Checks of arguments: paths, options, fields and frequencies."""

from __future__ import annotations

import numbers
import os
import warnings
from functools import cached_property, wraps
from typing import TYPE_CHECKING, Any, Literal, Mapping, Optional

from . import _core

if TYPE_CHECKING:
    from ._surface import Surface

# The words of arguments with choices, for editors and type checkers; the C++ side checks them.
Solver = Literal["multilevel", "relaxation", "averaged", "global"]
FrameSolver = Literal["multilevel", "relaxation"]
PhaseShift = Literal["aligned", "common_source", "trapezoid"]
FramePhaseShift = Literal["aligned", "trapezoid"]
Weights = Literal["paper", "cotangent"]
Match = Literal["number", "position"]
Curvature = Literal["max", "min"]
TensorAxis = Literal["major", "minor", "max-abs", "tangent-major", "tangent-minor"]
TensorOrder = Literal["vtk", "voigt", "plane"]
View = Literal["stripes", "branches", "angle_error"]
Tiles = Literal["whole", "cut"]
Projection = Literal["perspective", "orthographic"]
Up = Literal["x", "y", "z", "-x", "-y", "-z"]

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
    elif isinstance(value, dict):
        for array in value.values():
            frozen(array)
    elif isinstance(value, tuple):
        for part in value:
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
    """What a notebook shows as a picture, and what copies and pickles without its cached properties,
    which are made again."""

    def _repr_png_(self) -> Optional[bytes]:
        from ._pictures import notebook_png
        return notebook_png(self)

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in vars(self).items()
                if not isinstance(getattr(type(self), name, None), cached_property)}


class Running:
    """What depends on the calls before, and is neither copied nor pickled."""

    _INSTEAD = "pickle its surface, and make a new one of it"
    surface: "Surface"

    def __repr__(self) -> str:
        return f"<brindle.{type(self).__name__} on {self.surface!r}>"

    def __reduce__(self) -> Any:
        raise TypeError(f"brindle.{type(self).__name__} cannot be pickled or copied; {self._INSTEAD}")


def path_of(path: Any) -> str:
    """The path as text. Raises TypeError for anything but a string, bytes or an os.PathLike."""
    if not isinstance(path, (str, bytes, os.PathLike)):
        raise TypeError(f"expected a path, got {type(path).__name__}; open files are not taken")
    text = os.fspath(path)
    return os.fsdecode(text) if isinstance(text, bytes) else text


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


def distance(value: Any, what: str) -> float:
    """A number of 0 or more, possibly infinite. Raises Error for others."""
    result = number(value, what)
    if not result >= 0:
        raise Error(f"{what}: expected 0 or more, got {result}")
    return result


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
    if isinstance(value, bool) or type(value).__name__ == "bool_":
        return bool(value)
    raise TypeError(f"{what}: expected True or False, got {value!r}")


def word(value: Any, what: str) -> str:
    """Raises TypeError for anything but a string."""
    if not isinstance(value, str):
        raise TypeError(f"{what}: expected a string, got {type(value).__name__}")
    return value


def in_range(name: str, value: Any, written: Any) -> Any:
    """The value. Raises Error with the tool's message for a number outside its option's range."""
    _core.check_number(name.strip("_").replace("_", "-"), value, str(written))
    return value


def check_scalar(name: str, value: Any) -> None:
    """The same for a number; ignores other types, such as arrays."""
    if isinstance(value, numbers.Real) and not isinstance(value, bool):
        in_range(name, value, value)


_NUMBERS = ("epsilon", "momentum", "anchor_boundary", "cancel_branches", "cancel_distance",
            "lambda_")
_WHOLE_NUMBERS = ("seed", "sweeps", "cycles", "global_iterations")


def check_slack_type(slack: Any) -> None:
    """Raises TypeError for other than numbers and arrays."""
    if isinstance(slack, (bool, str)):
        raise TypeError(f"slack: expected a number or an array, got {slack!r}")


def check_slack(slack: Any, avoid_branches: Any, surface: "Surface") -> None:
    """The same; Error for avoid_branches without slack."""
    check_slack_type(slack)
    made = _core.Solving()
    made.set_slack(slack, avoid_branches, surface._core)
    made.check(options_of({"avoid_branches": avoid_branches}), False)


def set_windings(made: "_core.Solving", winding: Any) -> None:
    """A number for the only loop, or numbers by the names of loops."""
    wanted = winding if isinstance(winding, Mapping) else {"": winding}
    if not wanted:
        raise Error("winding: it names no loop; give a number, or numbers by names of loops()")
    for loop, periods in wanted.items():
        made.add_winding(word(loop, "winding"), whole_number(periods, "winding"))


def options_of(given: Mapping[str, Any]) -> set[str]:
    """The given arguments by the tool's names: lambda_ is --lambda."""
    return {"--" + name.strip("_").replace("_", "-") for name, value in given.items()
            if value is not None and not (isinstance(value, str) and value == _UNLESS_GIVEN.get(name))}


_UNLESS_GIVEN = {"weights": "paper", "phase_shift": "aligned", "solver": "multilevel"}


def solving(given: Mapping[str, Any], surface: "Surface") -> "_core.Solving":
    """How to solve what is asked for, on a surface. Options that are None have their
    defaults; those that would change nothing are refused."""
    options = {name: value for name, value in given.items() if value is not None}
    made = _core.Solving()
    for name in ("solver", "phase_shift", "weights"):
        if name in options:
            _core.check_choice(name.replace("_", "-"), word(options[name], name))
            setattr(made, name, options[name])
    check_scalar("threads", options.get("threads"))
    made.threads = whole_number(options.get("threads", 0), "threads")
    check_slack_type(options.get("slack"))
    check_scalar("slack", options.get("slack"))
    made.set_slack(options.get("slack"), options.get("avoid_branches"), surface._core)
    if "winding" in options:
        set_windings(made, options["winding"])
    for names, converted in ((_NUMBERS, number), (_WHOLE_NUMBERS, whole_number)):
        for name in names:
            if name in options:
                check_scalar(name, options[name])
                value = converted(options[name], name)
                setattr(made, name, in_range(name, value, options[name]))
    made.check(options_of(options), surface.is_points)
    return made


DEFAULT_STRIPES = 40


def one_of_both(name: str, value: Any, other_name: str, other: Any) -> None:
    """Checks that at most one is given, and its range."""
    if value is not None and other is not None:
        raise Error(f"{name} and {other_name} exclude each other: give one of both")
    check_scalar(name, value)
    check_scalar(other_name, other)


def count_and_frequency(stripes: Any, frequency: Any, spacing: Any) -> tuple[Any, Any]:
    """A number of stripes or a frequency; 40 stripes if nothing was given."""
    if spacing is not None:
        if stripes is not None or frequency is not None:
            raise Error("stripes, frequency and spacing exclude each other: give one of them")
        return None, _core.frequency_of_spacing(number(spacing, "spacing"))
    one_of_both("stripes", stripes, "frequency", frequency)
    if stripes is None and frequency is None:
        return DEFAULT_STRIPES, None
    return stripes, frequency


def described(options: Mapping[str, Any], defaults: Mapping[str, Any]) -> dict[str, Any]:
    """Options in a report: those other than the defaults, arrays by their shape."""
    result = {}
    for name, value in options.items():
        if value is None or value is defaults.get(name):
            continue
        if isinstance(value, (bool, int, float, str)):
            result[name] = value
        elif hasattr(value, "shape"):
            shape = tuple(value.shape)
            result[name] = value.item() if shape == () else f"array {shape}"
        else:
            result[name] = type(value).__name__
    return result
