"""Options that functions share. Fields of Solver, Layout and Measured are rows of the tool's table of
options, with its names, types and ranges; unset ones have its defaults."""

from __future__ import annotations

from dataclasses import dataclass, fields, make_dataclass
from typing import Any, Mapping, Optional, get_args

from . import _core
from ._arguments import (Error, Match, Tiles, check_scalar, flag, in_range, number, numbers_of,
                         option_name, whole_number, word)

ROWS: dict[str, dict[str, Any]] = {}
for _row in _core.option_rows():
    ROWS.setdefault(_row["name"].replace("-", "_"), _row)


def option_rows() -> dict[str, dict[str, Any]]:
    """The rows of the table of options by the names of arguments, for panels: words (a label), kind,
    form, unit, standard (the default), range, slider, excludes, part_of and help."""
    return {name: {**row, "help": _core.in_pythons_words(row["help"])} for name, row in ROWS.items()}


def checked(name: str, value: Any) -> Any:
    """The value of an option. Raises Error with the tool's message, TypeError for wrong types."""
    kind = ROWS[option_name(name).replace("-", "_")]["kind"]
    if kind == "choice":
        _core.check_choice(option_name(name), word(value, name))
    elif kind == "flag":
        return flag(value, name)
    elif kind in ("number", "whole"):
        check_scalar(name, value)
        return in_range(name, (number if kind == "number" else whole_number)(value, name), value)
    return value


class Options:
    """What is given of a group of options."""

    _OPTION_OF = {"name": "solver"}  # fields that have other names

    def __post_init__(self) -> None:
        for field in fields(self):  # type: ignore[arg-type]
            value = getattr(self, field.name)
            if value is not None:
                option = self._OPTION_OF.get(field.name, field.name)
                object.__setattr__(self, field.name, checked(option, value))

    def __repr__(self) -> str:
        given = ", ".join(f"{field.name}={getattr(self, field.name)!r}" for field in fields(self)  # type: ignore[arg-type]
                          if getattr(self, field.name) is not None)
        return f"{type(self).__name__}({given})"

    def given(self) -> dict[str, Any]:
        """By the names of options: those other than None, False and the words of defaults."""
        every = {self._OPTION_OF.get(field.name, field.name): getattr(self, field.name)
                 for field in fields(self)}  # type: ignore[arg-type]
        return {name: value for name, value in every.items()
                if value is not None and value is not False
                and not (ROWS[name]["kind"] == "choice" and value == ROWS[name]["standard"])}


def parts_of(option: str) -> list[str]:
    """The options that the tool has in another one's value."""
    return [name for name, row in ROWS.items() if option in row["part_of"].split()]


GROUPS = {
    "Solver": ("How phases are solved: the solver by its name, and its parameters.",
               ["name", *parts_of("solver"), "threads"]),
    "Layout": ("Branches that cancel, boundaries that stripes start at, loops that they wind around.",
               [name for name, row in ROWS.items() if row["group"] == "Fabrication"]),
    "Measured": ("Directions are measured data: how these are smoothed, weighted and filled.",
                 ["field_smoothing", *parts_of("field-smoothing"), "frequency_smoothing"]),
}


def _group(name: str) -> Any:
    about, names = GROUPS[name]
    options = [Options._OPTION_OF.get(field, field) for field in names]
    lines = [f"``{field}``: {_core.in_pythons_words(ROWS[option]['help'])}."
             for field, option in zip(names, options)]
    return make_dataclass(name, [(field, Any, None) for field in names], bases=(Options,), frozen=True,
                          eq=False, repr=False, namespace={"__module__": "brindle",
                                               "__doc__": "\n\n".join([about, *lines])})


Solver, Layout, Measured = (_group(name) for name in GROUPS)


@dataclass(frozen=True, eq=False)
class Slack:
    """Spacing tolerance: frequencies may vary between f / (1 + S) and f (1 + S) for fewer branches.

    ``tolerance``: S, a number or an array (n,). ``avoid_branches``: weights (n,) from 0 to 1, avoids
    branches there.
    """

    tolerance: Any
    avoid_branches: Any = None

    def __post_init__(self) -> None:
        if isinstance(self.tolerance, (bool, str)):
            raise TypeError(f"slack: expected a number or an array, got {self.tolerance!r}")
        check_scalar("slack", self.tolerance)

    def given(self) -> dict[str, Any]:
        """By the names of options."""
        return {"slack": self.tolerance, "avoid_branches": self.avoid_branches}


@dataclass(frozen=True, eq=False)
class Previous:
    """What a new pattern or field stays near to.

    ``pattern``: Stripes, or for fields a pair of a Surface before it moved and its (n, 3)
    directions. ``stiffness``: weight of the last phases (0.025; 0: none). ``match``: vertices are
    matched by "number" or "position" (default: by number if the faces are the same).
    ``max_distance``: limit of matching directions by position (default: none for a pair, one mean
    period for Stripes).
    """

    pattern: Any
    stiffness: Optional[float] = None
    match: Optional[Match] = None
    max_distance: Optional[float] = None

    def __post_init__(self) -> None:
        if self.stiffness is not None:
            checked("stiffness", self.stiffness)
        if self.match is not None and word(self.match, "match") not in get_args(Match):
            raise Error(f"match: '{self.match}' is neither 'number' nor 'position'")
        if self.max_distance is not None:
            number(self.max_distance, "max_distance")

    def given(self) -> dict[str, Any]:
        """By the names of options."""
        return {"previous": self.pattern, "lambda": self.stiffness, "match": self.match,
                "max_distance": self.max_distance}


@dataclass(frozen=True)
class Look:
    """The look of a picture.

    ``stripe_width``: share of the period, 0 to 1. ``tiles``: "whole" leaves out those that a
    branch, a seam or the border would cut, "cut" draws what is left of them; None: whole for tiles
    with a shape of their own, such as dots and arrows. ``tube_radius`` of curves. ``transparent``:
    no background. ``shading``: light; ``light_from``: (azimuth, elevation) in degrees from the
    viewer, (90, 0) from the right and (0, 90) from above; None: from the upper left.
    """

    stripe_width: Optional[float] = None
    tiles: Optional[Tiles] = None
    tube_radius: Optional[float] = None
    transparent: bool = False
    shading: bool = True
    light_from: Optional[tuple[float, float]] = None

    def __post_init__(self) -> None:
        for name in ("stripe_width", "tiles", "transparent"):
            if getattr(self, name) is not None:
                checked(name, getattr(self, name))
        if self.tube_radius is not None:
            number(self.tube_radius, "tube_radius")
        flag(self.shading, "shading")
        if self.light_from is not None:
            numbers_of(self.light_from, "light_from", "(azimuth, elevation) in degrees", 2)
            if not self.shading:
                raise Error("light_from has no effect here: there is no light; leave out shading=False")

    @property
    def whole(self) -> Optional[bool]:
        """Whether only whole tiles are drawn; None: what suits the tile."""
        return None if self.tiles is None else self.tiles == "whole"


def group(value: Any, kind: Any, what: str) -> Any:
    """A group of options, those of a default if None. Raises TypeError for others."""
    if value is None:
        return kind()
    if not isinstance(value, kind):
        raise TypeError(f"{what}: expected brindle.{kind.__name__}, got {type(value).__name__}")
    return value


def slack_of(slack: Any) -> Slack:
    return slack if isinstance(slack, Slack) else Slack(slack)


def previous_of(previous: Any) -> Optional[Previous]:
    return previous if previous is None or isinstance(previous, Previous) else Previous(previous)


def solver_given(solver: Any, without_effect: tuple[str, ...], why: str) -> dict[str, Any]:
    """What is given of a solver. Raises Error for options that have no effect here."""
    given = (solver if isinstance(solver, Solver) else Solver(solver)).given()
    for name in without_effect:
        if name in given:
            raise Error(f"{name}: has no effect here: {why}")
    return given


def solving(surface: Any, solver: Any, slack: Any, layout: Any = None,
            previous: Optional[Previous] = None, is_stripes: bool = True) -> _core.Solving:
    """How to solve what is asked for, on a surface. Raises Error for options without effect."""
    given = {**solver_given(solver, ("iterations",), "it is for the frames of animators"),
             **group(layout, Layout, "layout").given()}
    if "winding" in given:
        given["winding"] = _windings(given["winding"])
    if previous is not None:
        given.update((name, value) for name, value in previous.given().items() if value is not None)
        if previous.pattern is not None:
            given["previous"] = True
    slack = slack_of(slack)
    return _core.Solving(given, slack.tolerance, slack.avoid_branches, surface._core, is_stripes)


def _windings(winding: Any) -> list[tuple[str, int]]:
    """A number for the only loop, or numbers by the names of loops."""
    wanted = winding if isinstance(winding, Mapping) else {"": winding}
    if not wanted:
        raise Error("winding: it names no loop; give a number, or numbers by names of loops()")
    return [(word(loop, "winding"), whole_number(periods, "winding")) for loop, periods in wanted.items()]


DEFAULT_STRIPES = 40


def one_frequency(stripes: Any, frequency: Any, spacing: Any, of_v: str = "") -> tuple[Any, Any]:
    """A number of stripes or a frequency; 40 stripes if nothing was given. ``of_v``: "_v"."""
    if sum(given is not None for given in (stripes, frequency, spacing)) > 1:
        raise Error("stripes, frequency and spacing exclude each other: give one of them")
    check_scalar("stripes" + of_v, stripes)
    check_scalar("frequency" + of_v, frequency)
    if spacing is not None:
        frequency = _core.frequency_of_spacing(number(spacing, "spacing"))
    return (DEFAULT_STRIPES if stripes is None and frequency is None else stripes), frequency


def two_frequencies(stripes: Any, frequency: Any, spacing: Any) -> tuple[tuple[Any, Any], tuple[Any, Any]]:
    """The same of U and of V, which pairs (U, V) tell apart; None and None if V's are U's."""
    given = (stripes, frequency, spacing)
    is_pair = [isinstance(each, tuple) and len(each) == 2 for each in given]
    u, v = zip(*(each if pair else (each, each) for each, pair in zip(given, is_pair)))
    own = any(is_pair) and any(each is not None for each in v)
    return one_frequency(*u), one_frequency(v[0], v[1], v[2], "_v") if own else (None, None)
