"""Stripes and fields that follow changing input, frame by frame."""

from __future__ import annotations

import json
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arguments import (Error, Floats, FrameSolver, PhaseShift, Progress, Running, flag,
                         kept_property, number, whole_number, word)
from ._options import Slack, Solver, checked, slack_of, solver_given, solving
from ._surface import Surface, as_surface

Tolerance = Union[None, float, ArrayLike, Slack]
_NOT_OF_FRAMES = ("weights", "epsilon", "momentum", "seed", "global_iterations", "threads")


def checked_slack(surface: Surface, slack: Any) -> Slack:
    """The slack. Raises Error for branches to avoid without tolerance."""
    solving(surface, None, slack)
    return slack_of(slack)


def loaded(kind: Any, surface: Surface, *saved: Any) -> Any:
    """An animator as ``Saved.__reduce__`` left it."""
    animator = kind.__new__(kind)
    animator.surface = surface
    animator._core = getattr(_core, kind.__name__).loaded(surface._core, *saved)
    return animator


class Saved(Running):
    """An animator that is copied and pickled with its last frame, and goes on with the same bits."""

    _core: Any

    def __reduce__(self) -> Any:
        return loaded, (type(self), self.surface, *self._core.saved())


class Animator(Saved):
    """Lays stripes over one surface whose directions, frequencies and positions change. Where its
    triangles change, too, follow the last pattern by ``brindle.stripes(..., previous=)``.

    Data that depend on the faces alone are built in the first frame; later ones take a few
    milliseconds. ``stiffness``: weight of the last frame's phases, 0 for none. ``solver``:
    "multilevel", "relaxation" or a ``brindle.Solver`` with ``sweeps``, ``cycles``, ``iterations``
    or ``phase_shift``. ``edge_weights``: one per directed edge (``Surface.neighbors``). ``slack``:
    as for ``brindle.stripes``.

    One frame at a time: a concurrent call raises Error. A failed call leaves the animator
    unchanged.
    """

    def __init__(self, surface: Any, *, stiffness: float = 0.025,
                 solver: Union[Solver, FrameSolver] = "multilevel",
                 edge_weights: Optional[ArrayLike] = None, slack: Tolerance = None) -> None:
        self.surface: Surface = as_surface(surface)
        given = solver_given(solver, _NOT_OF_FRAMES, "it is not for frames")
        slack = checked_slack(self.surface, slack)
        self._core = _core.Animator(self.surface._core, given, checked("stiffness", stiffness),
                                    edge_weights, slack.tolerance, slack.avoid_branches)

    def frame(self, directions: ArrayLike, frequencies: ArrayLike,
              positions: Optional[ArrayLike] = None, *,
              out: Optional[NDArray[np.complex64]] = None,
              progress: Optional[Progress] = None) -> NDArray[np.complex64]:
        """The phases of the next frame: (n,) exp(i Phi), in a new array or in ``out``.

        ``directions``: (n, 3) vectors of any length, as for ``brindle.stripes`` of the surface at
        ``positions``, except that unit vectors are not projected where vertices have moved, which
        would take as long as the frame; zero, NaN or masked for no wave. ``frequencies``: stripes
        per unit length, a number or (n,), NaN for no wave. ``positions``: (n, 3), where vertices
        have moved to. Packed arrays of float32 that hold unit tangent vectors are read where they
        are; others are converted.
        """
        return self._core.frame(directions, frequencies, positions, out, progress)

    @property
    def phase_step(self) -> float:
        """The mean change of phases in the last frame, in radians."""
        return self._core.phase_step

    @property
    def unchanged(self) -> bool:
        """Whether the last frame's input was that of the frame before: then its phases are, too."""
        return self._core.unchanged

    @property
    def frequencies(self) -> Floats:
        """(n,) frequencies of the last frame with ``slack``; empty without."""
        return self._core.frequencies()

    @property
    def energy(self) -> float:
        """The energy of the last frame's phases, between 0 and 1. Raises Error before the first
        frame."""
        return self._core.energy()

    @property
    def milliseconds(self) -> dict[str, float]:
        """Times of the last frame: frequency, couple, sum, solve."""
        return self._core.milliseconds

    @property
    def topology_milliseconds(self) -> float:
        """The time to build the first frame's data."""
        return self._core.topology_milliseconds

    def sibling(self) -> "Animator":
        """An animator for another field on the same surface that shares the first frame's data.
        Call it after the first frame."""
        other = Animator.__new__(Animator)
        other.surface = self.surface
        other._core = self._core.sibling()
        return other

    def restart(self) -> None:
        """Discards the last phases: the next frame is solved from scratch."""
        self._core.restart()

    def set_phases(self, phases: ArrayLike) -> None:
        """Makes the next frame continue these phases: complex (n,), 0 where unknown."""
        self._core.set_phases(phases)


class TextureAnimator(Saved):
    """Lays a texture over one surface whose field changes from frame to frame. Triangles go on
    running as they ran, so that the seam stays where it is. ``oriented`` and ``slack`` as
    for ``brindle.texture``, all else as for ``Animator``."""

    def __init__(self, surface: Any, *, oriented: bool = False, stiffness: float = 0.025,
                 solver: Optional[Solver] = None, slack: Tolerance = None) -> None:
        self.surface: Surface = as_surface(surface)
        given = solver_given(solver, ("solver", "phase_shift", "iterations", *_NOT_OF_FRAMES),
                             "it is not for frames of textures")
        slack = checked_slack(self.surface, slack)
        self._core = _core.TextureAnimator(self.surface._core, flag(oriented, "oriented"), given,
                                           checked("stiffness", stiffness), slack.tolerance,
                                           slack.avoid_branches)

    def frame(self, directions: ArrayLike, frequencies: ArrayLike,
              positions: Optional[ArrayLike] = None, *,
              frequencies_v: Optional[ArrayLike] = None,
              normals: Optional[ArrayLike] = None,
              progress: Optional[Progress] = None) -> Floats:
        """The next frame's coordinates at the corners of triangles, (m, 3, 2), as
        ``Texture.corner_uv``. Input as for ``Animator.frame``; ``frequencies_v`` are V's unless U's
        are wanted; ``normals`` (n, 3) left out: those of ``positions``."""
        return self._core.frame(directions, frequencies, positions, frequencies_v, normals,
                                progress)

    @property
    def metrics(self) -> dict[str, Any]:
        """Metrics of the last frame: branches, seams, distortion, change of phases, and the
        continuation of the orientation ("afresh", "kept", "continued", "shortened")."""
        return dict(self._core.metrics)

    def restart(self) -> None:
        """Discards the last frame."""
        self._core.restart()


class PatternFrames(Running):
    """What a renderer of your own draws of the frames of an ``Animator``: normals of vertices that
    moved, corner phases, and the buffers that the installed shaders read (docs/gpu.md). ``phases``
    are what ``Animator.frame`` gave; ``directions``, ``frequencies`` and ``positions`` what it was
    given, with slack ``Animator.frequencies``. Packed arrays of float32 are read where they are, and
    ``out`` spares the result's allocation. One call at a time."""

    def __init__(self, surface: Any) -> None:
        self.surface: Surface = as_surface(surface)
        self._core = _core.PatternFrames(self.surface._core)

    @kept_property
    def faces(self) -> NDArray[np.uint32]:
        """(m, 4) the triangle buffer: three vertices and 0; the same for all frames."""
        return self._core.triangles()

    def normals(self, positions: ArrayLike) -> Floats:
        """(n, 3) unit normals of vertices at ``positions`` (n, 3)."""
        return self._core.normals(positions)

    def vertices(self, phases: ArrayLike, directions: ArrayLike, frequencies: ArrayLike,
                 positions: Optional[ArrayLike] = None, *,
                 normals: Optional[ArrayLike] = None,
                 out: Optional[Floats] = None) -> Floats:
        """(n, 12) the vertex buffer: x, y, z, frequency; direction, cosine of the phase; normal,
        its sine. ``normals``: (n, 3); by default, those of ``positions``."""
        return self._core.vertices(phases, directions, frequencies, positions, normals, out)

    def corner_phases(self, phases: ArrayLike, directions: ArrayLike,
                      frequencies: ArrayLike, positions: Optional[ArrayLike] = None, *,
                      phase_shift: PhaseShift = "aligned",
                      out: Optional[Floats] = None) -> Floats:
        """(m, 3) as ``Stripes.corner_phases``."""
        return self._core.corner_phases(phases, directions, frequencies, positions,
                                        word(phase_shift, "phase_shift"), out)


class FieldAnimator(Running):
    """A smooth field on one surface whose anchors change: data, or a brush. ``symmetry``: 1
    vectors, 2 lines, 4 crosses; ``stiffness``: how strongly a frame holds on to the last one's
    field."""

    def __init__(self, surface: Any, *, symmetry: int = 2, stiffness: float = 0.05,
                 sweeps: int = 2) -> None:
        self.surface: Surface = as_surface(surface)
        self._core = _core.FieldAnimator(self.surface._core, whole_number(symmetry, "symmetry"),
                                         checked("stiffness", stiffness), checked("sweeps", sweeps))

    def frame(self, vertices: ArrayLike = (), directions: Optional[ArrayLike] = None,
              weights: ArrayLike = 1.0, *,
              progress: Optional[Progress] = None) -> Floats:
        """(n, 3) unit tangent vectors, attracted at k ``vertices`` (k,) to ``directions`` (k, 3)
        by ``weights``, a number or (k,), relative to the pull of all neighbours together."""
        if directions is None:
            if len(vertices) > 0:  # type: ignore[arg-type]
                raise Error("directions: give one to each of the vertices")
            vertices, directions = np.empty(0, np.int64), np.empty((0, 3), np.float32)
        return self._core.frame(vertices, directions, weights, progress)


class FieldSmoothing(Running):
    """Measured fields on one surface, one after the other, seen at the scale of their stripes: what
    depends on the surface alone is made once. ``periods``: the scale. ``symmetry``: 1 arrows, 2
    lines, 4 crosses. ``fill``: how far holes are filled, in periods. ``singularities``: at most so
    many are left. ``temporal_smoothing``: how much the field of the frame before counts beside the data, so that
    noise does not make it jump (0: not at all; 1: as much). ``hold_out``: a share of the data that
    a check hides; ``metrics`` has the mean angle to them."""

    _INSTEAD = "pickle its surface and the last field; a new one goes on from it by frame(previous=)"

    def __init__(self, surface: Any, periods: float = 1, *, symmetry: int = 2, fill: float = 2,
                 singularities: Optional[int] = None, temporal_smoothing: float = 0,
                 hold_out: float = 0) -> None:
        self.surface: Surface = as_surface(surface)
        left = None if singularities is None else whole_number(singularities, "singularities")
        self._core = _core.FieldSmoothing(self.surface._core, number(periods, "periods"),
                                       whole_number(symmetry, "symmetry"), number(fill, "fill"),
                                       left, number(temporal_smoothing, "temporal_smoothing"),
                                       number(hold_out, "hold_out"))

    def frame(self, vectors: ArrayLike, frequencies: ArrayLike, *,
              confidence: Optional[ArrayLike] = None, previous: Optional[ArrayLike] = None,
              progress: Optional[Progress] = None
              ) -> tuple[Floats, Floats]:
        """The next frame: (n, 3) unit tangent vectors, zero beyond filled holes, and (n,) the
        directional coherence of the data around each vertex, from 0 to 1.

        ``vectors``: (n, 3), or (m, 3) of triangles, of any length; zero or NaN for no datum.
        ``frequencies``: stripes per unit length, a number or (n,), NaN for no wave.
        ``confidence``: weight of each datum, a row per vector, 0 or NaN for none. ``previous``: (n,
        3), the last field, if not that of the last frame.
        """
        return self._core.frame(vectors, frequencies, confidence, previous, progress)

    @property
    def filled(self) -> NDArray[np.uint8]:
        """Of the last frame, (n,): 1 for directions that fill a hole. Empty before the first."""
        return self._core.filled()

    @property
    def metrics(self) -> dict[str, Any]:
        """Metrics of the last frame, by the keys of reports: turn from the data in degrees,
        singularities of data and field, vertices with data, filled and not. Raises Error before
        the first frame."""
        return json.loads(self._core.metrics())
