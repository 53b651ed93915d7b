"""What functions are given: paths, options, fields and frequencies."""

from __future__ import annotations

import os
import re
import warnings
from typing import Any, Iterable, Mapping

from . import _core

Error = _core.Error
Cancelled = _core.Cancelled
Error.__module__ = Cancelled.__module__ = "brindle"
Error.__doc__ = """A job that could not be done: what is wrong, where, and what to do about it."""
Cancelled.__doc__ = """A job that a progress function stopped by returning False."""


class PatternWarning(UserWarning):
    """What is probably not meant: waves that are missing, stripes too fine for the mesh, arrays
    that a file cannot hold."""


def path_of(path: Any) -> str:
    """The path as text. Raises TypeError for anything but a string or an os.PathLike."""
    if not isinstance(path, (str, os.PathLike)):
        raise TypeError(f"expected a path, got {type(path).__name__}; open files are not taken")
    text = os.fspath(path)
    return os.fsdecode(text) if isinstance(text, bytes) else text


def in_pythons_words(text: str) -> str:
    """The tool's messages name options; here they are arguments: --frequency-by is frequency_by."""
    return re.sub(r"--([a-z][a-z-]*)", lambda found: found.group(1).replace("-", "_"), text)


def warn(text: str, level: int = 3) -> None:
    """A warning for every line."""
    for line in text.splitlines():
        line = in_pythons_words(line).removeprefix("warning: ")
        warnings.warn(line, PatternWarning, stacklevel=level)


def number(value: Any, what: str) -> float:
    """A finite or infinite number. Raises TypeError for anything else."""
    if isinstance(value, (bool, str, bytes)):
        raise TypeError(f"{what}: expected a number, got {value!r}")
    try:
        return float(value)
    except (TypeError, ValueError) as error:
        raise TypeError(f"{what}: expected a number, got {type(value).__name__}") from error


def whole_number(value: Any, what: str) -> int:
    """Raises TypeError for what is no whole number, Error for one beyond 32 bits."""
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


def refuse(given: Mapping[str, Any], names: Iterable[str], why: str) -> None:
    """Raises Error for the first of the options that was given, as it has no effect."""
    for name in names:
        if given.get(name) is not None:
            raise Error(f"{name} has no effect here: {why}")


_NUMBERS = ("epsilon", "momentum")
_WHOLE_NUMBERS = ("seed", "sweeps", "cycles", "global_iterations")


def check_slack(slack: Any, calm: Any) -> None:
    """Raises TypeError for what is no number or array, Error for calm without slack."""
    if isinstance(slack, (bool, str)):
        raise TypeError(f"slack: expected a number or an array, got {slack!r}")
    if calm is not None and slack is None:
        raise Error("calm has no effect here: no frequency yields; add slack")


def set_windings(made: "_core.Solving", winding: Any) -> None:
    """A number for the only way round, or numbers by the names of loops."""
    wanted = winding if isinstance(winding, Mapping) else {"": winding}
    for loop, periods in wanted.items():
        made.add_winding(word(loop, "winding"), whole_number(periods, "winding"))


def solving(solver: str, phase_shift: str, weights: str, threads: int,
            options: Mapping[str, Any]) -> "_core.Solving":
    """How to solve. Options that are None have their defaults; those that would change nothing are
    refused."""
    made = _core.Solving()
    made.solver = word(solver, "solver")
    made.phase_shift = word(phase_shift, "phase_shift")
    made.weights = word(weights, "weights")
    made.threads = whole_number(threads, "threads")
    if solver not in ("relaxation", "averaged"):
        refuse(options, ("epsilon", "momentum", "seed"),
               f"it is for the solvers relaxation and averaged, not for {solver}")
    if solver != "global":
        refuse(options, ("global_iterations",), f"it is for the solver global, not for {solver}")
    if solver != "multilevel" and not options.get("cycles"):
        refuse(options, ("sweeps",), f"it is for the solver multilevel and for cycles, not for {solver}")
    check_slack(options.get("slack"), options.get("calm"))
    if options.get("slack") is not None:
        made.set_slack(options["slack"], options.get("calm"))
    if options.get("winding") is not None:
        set_windings(made, options["winding"])
    if options.get("anchor_boundary") is not None:
        made.anchor_boundary = number(options["anchor_boundary"], "anchor_boundary")
    if options.get("merge_branches") is not None:
        made.merge_branches = number(options["merge_branches"], "merge_branches")
    for name in _NUMBERS:
        if options.get(name) is not None:
            setattr(made, name, number(options[name], name))
    for name in _WHOLE_NUMBERS:
        if options.get(name) is None:
            continue
        value = whole_number(options[name], name)
        if value < 0:
            raise Error(f"{name}: {value} is below zero")
        setattr(made, name, value)
    return made


DEFAULT_STRIPES = 40


def one_of_both(name: str, value: Any, other_name: str, other: Any) -> None:
    """At most one of them is given."""
    if value is not None and other is not None:
        raise Error(f"{name} and {other_name} exclude each other: give one of both")


def count_and_frequency(stripes: Any, frequency: Any) -> tuple[Any, Any]:
    """One of both; 40 stripes if neither was given."""
    one_of_both("stripes", stripes, "frequency", frequency)
    if stripes is None and frequency is None:
        return DEFAULT_STRIPES, None
    return stripes, frequency


def described(options: Mapping[str, Any]) -> dict[str, Any]:
    """Options for a report: those that were given, arrays by their shape."""
    result = {}
    for name, value in options.items():
        if value is None:
            continue
        if isinstance(value, (bool, int, float, str)):
            result[name] = value
        elif hasattr(value, "shape"):
            shape = tuple(value.shape)
            result[name] = value.item() if shape == () else f"array {shape}"
        else:
            result[name] = type(value).__name__
    return result
