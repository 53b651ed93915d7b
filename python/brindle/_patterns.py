"""Patterns from surfaces and directions."""

from __future__ import annotations

from typing import Any, Optional, Union

from numpy.typing import ArrayLike

from . import _core
from ._arguments import Error, PhaseShift, Progress, Run, SolverName, flag, number, warn, word
from ._inputs import Field, frequencies_of, invocation
from ._interop import split_source
from ._options import (Layout, Measured, Previous, Slack, Solver, one_frequency, previous_of, solving,
                       two_frequencies)
from ._outputs import Samples, Stripes, Texture
from ._surface import Surface, as_surface


def _is_along(run: Any) -> bool:
    if word(run, "run") not in ("along", "across"):
        raise Error(f"run: expected one of along|across, got '{run}'")
    return run == "along"


def stripes(surface: Any, directions: Optional[ArrayLike] = None, *, stripes: Any = None,
            frequency: Any = None, spacing: Optional[float] = None, run: Run = "across",
            slack: Union[None, float, ArrayLike, Slack] = None, layout: Optional[Layout] = None,
            measured: Optional[Measured] = None, solver: Union[Solver, SolverName] = "multilevel",
            previous: Union[None, Stripes, Previous] = None,
            progress: Optional[Progress] = None) -> Stripes:
    """Lays stripes over a surface, across ``directions``: waves run along them.

    ``surface``: a Surface, or anything that ``brindle.as_surface`` accepts. ``directions``: (n,
    3) vectors of any length, up to sign, one per vertex, projected into the tangent planes (unit
    tangent vectors are not changed); zero or NaN for no wave; or the name of an array of vectors
    or tensors of the surface; None: ``surface.smooth_field()``. ``run``: stripes run "across" the
    directions or "along" them.

    ``stripes``: so many along the bounding box's diagonal (40 unless one of the others is given).
    ``frequency``: stripes per unit length, a number, an array (n,), where NaN means no wave
    (of vectors (n, 3) the length counts), or the name of one. ``spacing``: distance between
    stripes, the same as a ``frequency`` of 1 / spacing.

    ``slack``: spacing tolerance S, a number or an array (n,): frequencies may vary between f / (1
    + S) and f (1 + S) for fewer branches; 0 or None: not at all; a ``brindle.Slack`` also avoids
    branches in places. ``p.frequency`` is then the chosen one.

    ``layout``: ``brindle.Layout(anchor_boundary=0.5)`` lays the first stripe along boundaries, half
    a period inside; ``winding=1`` makes it one helix around the only loop, ``winding={"loop-1": 1}``
    around one of ``surface.loops()``, by turning the field by small angles; ``cancel_branches=0.05``
    cancels pairs of opposite branches while the energy rises by at most this share.

    ``measured``: directions are data; ``brindle.Measured(1)`` smooths them over one period and fills
    holes. ``p.point_data`` then has ``coherence``, how much data agree around a vertex, and
    ``filled``, 1 where the direction or frequency fills a hole.

    ``solver``: "multilevel", "relaxation", "averaged" or "global" (in builds with CHOLMOD), or a
    ``brindle.Solver`` with parameters, weights and threads.

    ``previous``: stays near to the phases of other Stripes, or as a ``brindle.Previous`` requests.
    The smooth field (``directions`` None) then goes on from that pattern's field, as it was before
    ``run`` turned it, unless the stiffness is 0. It solves again, and so moves phases a little even
    where the input is that of the other pattern; ``brindle.Animator`` then keeps them, and is faster,
    for the frames of one surface. Use ``previous`` where faces change, or for single steps.

    ``progress(stage, fraction)`` receives progress, and cancels by returning False. Other Python
    threads run meanwhile; Ctrl-C cancels. Results do not depend on the number of threads.

    Raises brindle.Error for invalid values, brindle.Cancelled, TypeError for wrong types.
    """
    given = dict(locals())
    surface = as_surface(surface)
    last = previous_of(previous)
    if last is not None and not isinstance(last.pattern, (Stripes, type(None))):
        raise TypeError(f"previous: expected brindle.Stripes, got {type(last.pattern).__name__}")
    options = solving(surface, solver, slack, layout, last)
    field = Field(surface, directions, _is_along(run), frequency, measured,
                  last if last is not None and last.stiffness != 0 else None)
    count, frequency = one_frequency(stripes, frequencies_of(surface, frequency), spacing)
    made = _core.stripes(surface._core, field.directions, count, frequency, field.origin, options,
                         None if last is None else last.pattern._core,
                         "" if last is None else last.match or "", progress)
    warn(made.warnings(field.origin.source))
    return Stripes(made, surface, invocation(_STRIPES, surface, given))


def stripes_from_phases(surface: Any, phases: ArrayLike, directions: ArrayLike, *,
                        stripes: Any = None, frequency: Any = None,
                        spacing: Optional[float] = None,
                        phase_shift: PhaseShift = "aligned") -> Stripes:
    """The pattern of phases that are known, such as those of ``Animator.frame`` or of a file:
    complex (n,), exp(i Phi) per vertex; where they are 0 or NaN (``np.exp(1j *
    p.point_data["phase"])``), there is no wave. Directions and frequencies are those of the frame.
    Lifted to the triangles and measured like any other."""
    given = {name: value for name, value in locals().items() if name != "directions"}
    surface = as_surface(surface)
    field = Field(surface, directions)
    count, frequency = one_frequency(stripes, frequencies_of(surface, frequency), spacing)
    made = _core.stripes_from_phases(surface._core, phases, field.directions, count, frequency,
                                     field.origin, solving(surface, Solver(phase_shift=phase_shift), None))
    return Stripes(made, surface, invocation(stripes_from_phases, surface, given))


def texture(surface: Any, directions: Optional[ArrayLike] = None, *, stripes: Any = None,
            frequency: Any = None, spacing: Any = None, run: Run = "across", oriented: bool = False,
            slack: Union[None, float, ArrayLike, Slack] = None, layout: Optional[Layout] = None,
            measured: Optional[Measured] = None, solver: Union[Solver, SolverName] = "multilevel",
            progress: Optional[Progress] = None) -> Texture:
    """Texture coordinates along a field (U) and across it (V); ``t.corner_uv`` is (m, 3, 2).

    ``oriented``: directions have signs, and U runs along them; otherwise an orientation is found.
    ``stripes``, ``frequency`` and ``spacing`` may be pairs (U, V), such as ``stripes=(40, 20)``; None
    in a pair: not by this one. Other arguments as for ``brindle.stripes``.
    """
    given = dict(locals())
    surface = as_surface(surface)
    options = solving(surface, solver, slack, layout, is_stripes=False)
    field = Field(surface, directions, _is_along(run), frequency, measured,
                  oriented=flag(oriented, "oriented"))
    u, v = two_frequencies(stripes, frequencies_of(surface, frequency), spacing)
    made = _core.texture(surface._core, field.directions, *u, *v, oriented, field.origin, options, progress)
    warn(made.warnings(field.origin.source))
    return Texture(made, surface, invocation(texture, surface, given))


def crosses(surface: Any, directions: Optional[ArrayLike] = None, *, stripes: Any = None,
            frequency: Any = None, spacing: Optional[float] = None,
            slack: Union[None, float, ArrayLike, Slack] = None, layout: Optional[Layout] = None,
            measured: Optional[Measured] = None, solver: Union[Solver, SolverName] = "multilevel",
            progress: Optional[Progress] = None) -> Texture:
    """Square tiles along a cross field, whose directions are equivalent under quarter turns.
    ``directions``: as for ``brindle.stripes``; None: ``surface.smooth_field(symmetry=4)``. Other
    arguments as for ``brindle.stripes``."""
    given = dict(locals())
    surface = as_surface(surface)
    options = solving(surface, solver, slack, layout, is_stripes=False)
    field = Field(surface, directions, False, frequency, measured, symmetry=4)
    count, frequency = one_frequency(stripes, frequencies_of(surface, frequency), spacing)
    made = _core.crosses(surface._core, field.directions, count, frequency, field.origin,
                         options, progress)
    warn(made.warnings(field.origin.source))
    split = Surface._of(made.surface, split_source(surface, made.face_origins))
    return Texture(made, split, invocation(crosses, surface, given), (surface,))


def samples(surface: Any, directions: Optional[ArrayLike] = None, *,
            directions_v: Optional[ArrayLike] = None, stripes: Any = None, frequency: Any = None,
            spacing: Any = None, min_distance: float = 0.25,
            slack: Union[None, float, ArrayLike, Slack] = None, measured: Optional[Measured] = None,
            solver: Union[Solver, SolverName] = "multilevel",
            progress: Optional[Progress] = None) -> Samples:
    """Regular points along a field: crossings of the stripes across ``directions`` (U) with those
    along them (V). ``points, normals = brindle.samples(s, d, stripes=40)``.

    Arguments as for ``brindle.texture``; ``directions_v`` are V's (default: U's turned by 90
    degrees). Samples nearer to another than ``min_distance`` spacings are left out. Needs a build
    with nanoflann.
    """
    given = dict(locals())
    surface = as_surface(surface)
    options = solving(surface, solver, slack)
    field = first = Field(surface, directions, False, frequency, measured)
    of_u, of_v = two_frequencies(stripes, frequencies_of(surface, frequency), spacing)
    said = invocation(samples, surface, given)

    def pattern(field: Field, directions: Any, count: Any, frequency: Any) -> Stripes:
        field.origin.see_frequencies_like(first.origin)
        made = _core.stripes(surface._core, directions, count, frequency, field.origin, options, None,
                             "", progress)
        warn(made.warnings(field.origin.source), 4)
        return Stripes(made, surface, said)

    u = pattern(field, field.directions, *of_u)
    directions_of_v = directions_v
    if directions_v is None:
        directions_of_v = surface.rotate_field(u.directions, 90)
        if field.is_detailed:  # once is enough
            field = Field(surface, directions_of_v)
            field.origin.source = first.origin.source
    else:
        field = Field(surface, directions_v)
        directions_of_v = field.directions
    v = pattern(field, directions_of_v, *(of_u if of_v == (None, None) else of_v))
    return samples_of(u, v, min_distance=min_distance)


def samples_of(u: Stripes, v: Stripes, *, min_distance: float = 0.25) -> Samples:
    """Crossings of the stripes of two patterns on one surface."""
    made = _core.samples(u._core, v._core, number(min_distance, "min_distance"))
    return Samples(made, u.surface, u, v)


def has_solver(name: str) -> bool:
    """Whether this build has the solver; only "global" may be missing."""
    return _core.has_solver(word(name, "name"))


_STRIPES = stripes  # the name is an argument there
