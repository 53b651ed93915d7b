"""Stripes and fields that follow changing input, frame by frame."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Optional

from . import _core
from ._arguments import Error, check_slack, flag, kept_property, number, whole_number, word
from ._surface import Progress, Surface, as_surface

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import ArrayLike, NDArray


class Animator:
    """Lays stripes over one surface whose directions, frequencies and positions change.

    What depends on the triangles alone is built in the first frame; later ones take a few
    milliseconds. ``lambda_``: how strongly a frame holds on to the last one's phases, 0 not at all.
    ``solver``: "multilevel" (``sweeps``, ``cycles``) or "relaxation" (``iterations``).
    ``edge_weights``: one per directed edge (``Surface.neighbors``). ``slack`` and ``calm``: as for
    ``brindle.stripes``.

    One frame at a time: a second call meanwhile, from another thread, is an Error. What raises
    leaves the animator as it was.
    """

    def __init__(self, surface: Any, *, lambda_: float = 0.025, solver: str = "multilevel",
                 sweeps: int = 2, cycles: int = 0, iterations: int = 3,
                 phase_shift: str = "aligned", edge_weights: "Optional[ArrayLike]" = None,
                 slack: Any = None, calm: "Optional[ArrayLike]" = None) -> None:
        self.surface: Surface = as_surface(surface)
        check_slack(slack, calm)
        self._core = _core.Animator(self.surface._core, word(solver, "solver"),
                                    number(lambda_, "lambda_"), whole_number(sweeps, "sweeps"),
                                    whole_number(cycles, "cycles"),
                                    whole_number(iterations, "iterations"),
                                    word(phase_shift, "phase_shift"), edge_weights, slack,
                                    calm)

    def frame(self, directions: "ArrayLike", frequencies: "ArrayLike",
              positions: "Optional[ArrayLike]" = None, *,
              out: "Optional[NDArray[np.complex64]]" = None,
              progress: Optional[Progress] = None) -> "NDArray[np.complex64]":
        """The phases of the next frame: (n,) exp(i Phi), in a new array or in ``out``.

        ``directions``: (n, 3) unit tangent vectors, or zero for no wave (``Surface.array_field``
        makes such of any vectors). ``frequencies``: stripes per unit length, a number or (n,).
        ``positions``: (n, 3), where vertices have moved to. Packed arrays of float32 are read where
        they are; others are converted.
        """
        return self._core.frame(directions, frequencies, positions, out, progress)

    @property
    def phase_step(self) -> float:
        """How far phases moved in the last frame, in radians, on average."""
        return self._core.phase_step

    @property
    def unchanged(self) -> bool:
        """Whether the last frame's input was that of the frame before."""
        return self._core.unchanged

    @property
    def frequencies(self) -> "NDArray[np.float32]":
        """(n,) of the last frame, with slack; empty without: those of the input."""
        return self._core.frequencies()

    @property
    def energy(self) -> float:
        """Of the last frame's phases, between 0 and 1. Raises Error before the first frame."""
        return self._core.energy()

    @property
    def milliseconds(self) -> dict[str, float]:
        """Of the last frame: frequency, couple, sum, solve."""
        return self._core.milliseconds

    @property
    def topology_milliseconds(self) -> float:
        """What the first frame built, once."""
        return self._core.topology_milliseconds

    def sibling(self) -> "Animator":
        """An animator for another field on the same surface that shares what was built. Call it
        after the first frame."""
        other = Animator.__new__(Animator)
        other.surface = self.surface
        other._core = self._core.sibling()
        return other

    def restart(self) -> None:
        """Forgets the last phases: the next frame is solved from scratch."""
        self._core.restart()

    def set_last_phases(self, phases: "ArrayLike") -> None:
        """Lets the next frame follow these phases: complex (n,), 0 where none is known."""
        self._core.set_last_phases(phases)


class TextureAnimator:
    """Lays a texture over one surface whose field changes from frame to frame. Triangles go on
    running as they ran, so that the seam stays where it is. ``oriented``, ``slack`` and ``calm`` as
    for ``brindle.texture``, all else as for ``Animator``."""

    def __init__(self, surface: Any, *, oriented: bool = False, lambda_: float = 0.025,
                 sweeps: int = 2, cycles: int = 0, slack: Any = None,
                 calm: "Optional[ArrayLike]" = None) -> None:
        self.surface: Surface = as_surface(surface)
        check_slack(slack, calm)
        self._core = _core.TextureAnimator(self.surface._core, flag(oriented, "oriented"),
                                           number(lambda_, "lambda_"), whole_number(sweeps, "sweeps"),
                                           whole_number(cycles, "cycles"), slack, calm)

    def frame(self, directions: "ArrayLike", frequencies: "ArrayLike",
              positions: "Optional[ArrayLike]" = None, *,
              frequencies_v: "Optional[ArrayLike]" = None,
              normals: "Optional[ArrayLike]" = None,
              progress: Optional[Progress] = None) -> "NDArray[np.float32]":
        """The next frame's coordinates at the corners of triangles, (m, 3, 2), as
        ``Texture.corner_uv``. Input as for ``Animator.frame``; ``frequencies_v`` are V's unless U's
        are wanted, ``normals`` (n, 3) those of moved positions."""
        return self._core.frame(directions, frequencies, positions, frequencies_v, normals,
                                progress)

    @property
    def figures(self) -> dict[str, Any]:
        """Of the last frame: branches, seams, distortion, how far phases moved, and how the
        orientation follows from the last frame's ("afresh", "kept", "continued", "shortened")."""
        return dict(self._core.figures)

    def restart(self) -> None:
        """Forgets the last frame."""
        self._core.restart()


class PatternFrames:
    """What a renderer of your own draws of the frames of an ``Animator``: normals of vertices that
    moved, corner phases, and the buffers that the installed shaders read (docs/gpu.md). ``phases``
    are what ``Animator.frame`` gave; ``directions``, ``frequencies`` and ``positions`` what it was
    given, with slack ``Animator.frequencies``. Packed arrays of float32 are read where they are, and
    ``out`` spares the result's allocation. One call at a time."""

    def __init__(self, surface: Any) -> None:
        self.surface: Surface = as_surface(surface)
        self._core = _core.PatternFrames(self.surface._core)

    @kept_property
    def triangles(self) -> "NDArray[np.uint32]":
        """(m, 4) the buffer of triangles: three vertices and 0, which no frame changes."""
        return self._core.triangles()

    def normals(self, positions: "ArrayLike") -> "NDArray[np.float32]":
        """(n, 3) unit normals of vertices that stand at ``positions`` (n, 3)."""
        return self._core.normals(positions)

    def vertices(self, phases: "ArrayLike", directions: "ArrayLike", frequencies: "ArrayLike",
                 positions: "Optional[ArrayLike]" = None, *,
                 normals: "Optional[ArrayLike]" = None,
                 out: "Optional[NDArray[np.float32]]" = None) -> "NDArray[np.float32]":
        """(n, 12) the buffer of vertices: x, y, z, frequency; direction, cosine of the phase; normal,
        its sine. ``normals``: (n, 3); left out: those of ``positions``."""
        return self._core.vertices(phases, directions, frequencies, positions, normals, out)

    def corner_phases(self, phases: "ArrayLike", directions: "ArrayLike",
                      frequencies: "ArrayLike", positions: "Optional[ArrayLike]" = None, *,
                      phase_shift: str = "aligned",
                      out: "Optional[NDArray[np.float32]]" = None) -> "NDArray[np.float32]":
        """(m, 3) as ``Stripes.corner_phases``."""
        return self._core.corner_phases(phases, directions, frequencies, positions,
                                        word(phase_shift, "phase_shift"), out)


class FieldAnimator:
    """A smooth field on one surface whose anchors change: data, or a brush. ``symmetry``: 1
    vectors, 2 lines, 4 crosses; ``lambda_``: how strongly a frame holds on to the last one's
    field."""

    def __init__(self, surface: Any, *, symmetry: int = 2, lambda_: float = 0.05,
                 sweeps: int = 2) -> None:
        self.surface: Surface = as_surface(surface)
        self._core = _core.FieldAnimator(self.surface._core, whole_number(symmetry, "symmetry"),
                                         number(lambda_, "lambda_"), whole_number(sweeps, "sweeps"))

    def frame(self, vertices: "ArrayLike" = (), directions: "Optional[ArrayLike]" = None,
              weights: "ArrayLike" = 1.0, *,
              progress: Optional[Progress] = None) -> "NDArray[np.float32]":
        """(n, 3) unit tangent vectors, drawn at k ``vertices`` (k,) towards ``directions`` (k, 3)
        by ``weights``, a number or (k,), in multiples of what all neighbours together pull."""
        if directions is None:
            if len(vertices) > 0:  # type: ignore[arg-type]
                raise Error("directions: give one to each of the vertices")
            import numpy as np
            vertices, directions = np.empty(0, np.int64), np.empty((0, 3), np.float32)
        return self._core.frame(vertices, directions, weights, progress)


class FieldDetail:
    """Measured fields on one surface, one after the other, seen at the scale of their stripes: what
    depends on the surface alone is made once. ``periods``: the scale. ``symmetry``: 1 arrows, 2
    lines, 4 crosses. ``fill``: how far holes are filled, in periods. ``singularities``: at most so
    many are left. ``memory``: how much the field of the frame before counts beside the data, so that
    noise does not make it jump (0: not at all; 1: as much). ``hold_out``: a share of the data that
    a check hides; ``figures`` has the mean angle to them."""

    def __init__(self, surface: Any, periods: float = 1, *, symmetry: int = 2, fill: float = 2,
                 singularities: Optional[int] = None, memory: float = 0,
                 hold_out: float = 0) -> None:
        self.surface: Surface = as_surface(surface)
        left = None if singularities is None else whole_number(singularities, "singularities")
        self._core = _core.FieldDetail(self.surface._core, number(periods, "periods"),
                                       whole_number(symmetry, "symmetry"), number(fill, "fill"),
                                       left, number(memory, "memory"),
                                       number(hold_out, "hold_out"))

    def frame(self, vectors: "ArrayLike", frequencies: "ArrayLike", *,
              confidence: "Optional[ArrayLike]" = None, last: "Optional[ArrayLike]" = None,
              progress: Optional[Progress] = None
              ) -> "tuple[NDArray[np.float32], NDArray[np.float32]]":
        """The next frame: (n, 3) unit tangent vectors, zero beyond what is filled, and (n,) how much
        the data around each vertex agree, from 0 to 1.

        ``vectors``: (n, 3), or (m, 3) of triangles, of any length; zero or NaN: there is no datum.
        ``frequencies``: stripes per unit length, a number or (n,), NaN for no wave.
        ``confidence``: how much each datum counts, a row per vector, 0 or NaN if it is none.
        ``last``: (n, 3), the field before, where it is not that of the frame before.
        """
        return self._core.frame(vectors, frequencies, confidence, last, progress)

    @property
    def filled(self) -> "NDArray[np.uint8]":
        """Of the last frame, (n,): 1 for directions that fill a hole. Empty before the first."""
        return self._core.filled()

    @property
    def figures(self) -> dict[str, Any]:
        """Of the last frame, by the keys of reports: by how many degrees it was turned from its
        data, how many singularities data and field have, vertices with data, filled and not.
        Raises Error before the first frame."""
        return json.loads(self._core.figures())
